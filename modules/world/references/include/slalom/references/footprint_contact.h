// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/robot/footprint.h>
#include <slalom/scenario/world.h>

#include <memory>

namespace slalom {

/// Collision checking of a footprint; one class for each kind of footprint.
class FootprintContact {
 public:
  virtual ~FootprintContact() = default;

  virtual bool touches(const mrpt::math::TPose2D& pose) const = 0;

  /// Whether the footprint touches an obstacle on its motion from `from` to `to`; then `to` becomes
  /// the first pose of contact and `fraction` (0..1) its position along the motion. Position and
  /// heading are interpolated linearly: the deviation of the arc of a motion step from the straight
  /// line is an eighth of its length times its rotation, 0.02 mm with the default options.
  /// Consecutive calls must be contiguous: `from` is the last `to`.
  virtual bool find_contact(const mrpt::math::TPose2D& from, mrpt::math::TPose2D& to,
                            double& fraction) = 0;

  /// Whether the footprint keeps more than `margin` (m) from all obstacles on a motion, as
  /// find_contact() interpolates it; obstacles inside a polygon, which its motion up to `from`
  /// would have touched, are not seen.
  virtual bool is_free(const mrpt::math::TPose2D& from, const mrpt::math::TPose2D& to,
                       double margin) const = 0;
};

std::unique_ptr<FootprintContact> make_footprint_contact(const World& world,
                                                         const Footprint& footprint);

}  // namespace slalom
