#pragma once

#include <slalom/robot/footprint.h>
#include <slalom/scenario/world.h>

#include <memory>

namespace slalom {

/// Whether and where a footprint touches obstacles; one for each kind of footprint.
class FootprintContact {
 public:
  virtual ~FootprintContact() = default;

  virtual bool touches(const mrpt::math::TPose2D& pose) const = 0;

  /// Whether the footprint touches something on its way from `from` to `to`; then `to` becomes the
  /// first pose of contact and `share` (0..1) how far along that is. On the way the position moves
  /// straight and the heading turns evenly: the arc driven in a motion step lies beside the
  /// straight line by an eighth of its length times its turn, 0.02 mm with the default options.
  /// Consecutive calls must follow each other: `from` is where the last one ended.
  virtual bool meets_obstacle(const mrpt::math::TPose2D& from, mrpt::math::TPose2D& to,
                              double& share) = 0;
};

std::unique_ptr<FootprintContact> make_footprint_contact(const World& world,
                                                         const Footprint& footprint);

}  // namespace slalom
