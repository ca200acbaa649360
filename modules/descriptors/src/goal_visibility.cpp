#include "along_path.h"
#include "descriptors.h"

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

/// Share of P* with a free line of sight to the goal: however far. From the middles of pieces
/// of a quarter of a cell at most.
class GoalVisibility : public Descriptor {
 public:
  QuantityInfo info() const override {
    return {"goal_visibility", 1, "Goal visibility", "-", Direction::None};
  }

  std::string parameters(const DescriptorContext& context) const override {
    return join_parameters({robot_parameter(context), resolution_parameter(context.world)});
  }

  Value compute(const DescriptorContext& context) const override {
    constexpr double kPiece = 0.25;  // cells
    const KnownPath& shortest = context.shortest();
    if (shortest.path.empty()) return Value::na(shortest.reason);
    if (!(shortest.length > 0)) return Value::na("the start is the goal");
    const RayCaster& rays = context.world.ray_caster();
    const mrpt::math::TPoint2D goal = context.world.scenario().goal();
    const auto middles =
        piece_middles(shortest.path, kPiece * context.world.occupancy().resolution());
    const auto sees_goal = [&](const mrpt::math::TPoint2D& place) {
      const double away = (goal - place).norm();
      const double angle = std::atan2(goal.y - place.y, goal.x - place.x);
      return rays.cast(place, angle, away) >= away * (1 - 1e-9);
    };
    return Value::of(static_cast<double>(std::count_if(middles.begin(), middles.end(), sees_goal)) /
                     static_cast<double>(middles.size()));
  }
};

}  // namespace

DescriptorPtr make_goal_visibility() {
  return std::make_shared<GoalVisibility>();
}

}  // namespace slalom
