#include "along_path.h"
#include "confined_share.h"
#include "descriptors.h"

#include <slalom/core/text.h>

namespace slalom {
namespace {

/// Mean along P* of the share of directions in which a ray meets O within R: at the middles of
/// pieces of a cell's length at most.
class ConfinementPath : public Descriptor {
 public:
  QuantityInfo info() const override {
    return {"confinement_path", 1, "Confinement along the shortest path", "-", Direction::None};
  }

  std::string parameters(const DescriptorContext& context) const override {
    return join_parameters({"sensor_range=" + format_number(context.sensor_range),
                            robot_parameter(context), resolution_parameter(context.world)});
  }

  Value compute(const DescriptorContext& context) const override {
    const KnownPath& shortest = context.shortest();
    if (shortest.path.empty()) return Value::na(shortest.reason);
    double sum = 0;
    int places = 0;
    for (const mrpt::math::TPoint2D& place :
         piece_middles(shortest.path, context.world.occupancy().resolution()))
      sum += confined_share(context.world, place, context.sensor_range,
                            fraction(++places * kGoldenRatio));
    if (places == 0) return Value::na("the start is the goal");
    return Value::of(sum / places);
  }
};

}  // namespace

DescriptorPtr make_confinement_path() {
  return std::make_shared<ConfinementPath>();
}

}  // namespace slalom
