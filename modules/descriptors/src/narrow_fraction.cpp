#include "along_path.h"
#include "descriptors.h"

namespace slalom {
namespace {

/// Share of P*'s length on which 2 d is less than 1.5 times the robot's width. Half of both is
/// compared; d is taken every quarter of a cell and linear in between.
class NarrowFraction : public Descriptor {
 public:
  QuantityInfo info() const override {
    return {"narrow_fraction", 1, "Narrow-passage fraction", "-", Direction::None};
  }

  std::string parameters(const DescriptorContext& context) const override {
    return join_parameters({robot_parameter(context), resolution_parameter(context.world)});
  }

  Value compute(const DescriptorContext& context) const override {
    constexpr double kNarrow = 1.5;  // robot widths
    constexpr double kPiece = 0.25;  // cells
    const KnownPath& shortest = context.shortest();
    if (shortest.path.empty()) return Value::na(shortest.reason);
    if (!(shortest.length > 0)) return Value::na("the start is the goal");
    const double narrow = kNarrow * context.robot_radius();
    const DistanceField& field = context.world.distance_field();
    return Value::of(
        share_below(shortest.path, kPiece * context.world.occupancy().resolution(), narrow - 1e-9,
                    [&](const mrpt::math::TPoint2D& place) { return field.clearance(place); }));
  }
};

}  // namespace

DescriptorPtr make_narrow_fraction() {
  return std::make_shared<NarrowFraction>();
}

}  // namespace slalom
