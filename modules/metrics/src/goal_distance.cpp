#include "common.h"
#include "families.h"

#include <slalom/references/exact_shortest.h>

#include <algorithm>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

double distance_to_goal(const MetricContext& context, const mrpt::math::TPose2D& pose) {
  return length({{pose.x, pose.y}, context.world.scenario().goal()});
}

/// |p_end - g|.
class FinalDistance : public Metric {
 public:
  QuantityInfo info() const override {
    return {"final_distance", 1, "Final distance to the goal", "m", Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_without_samples(context)) return *na;
    return Value::of(distance_to_goal(context, context.trajectory.samples.back().pose));
  }
};

/// The least |p_i - g|.
class ClosestDistance : public Metric {
 public:
  QuantityInfo info() const override {
    return {"closest_distance", 1, "Closest distance to the goal", "m", Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_without_samples(context)) return *na;
    double closest = distance_to_goal(context, context.trajectory.samples.front().pose);
    for (const Sample& sample : context.trajectory.samples)
      closest = std::min(closest, distance_to_goal(context, sample.pose));
    return Value::of(closest);
  }
};

/// 1 - geodesic(p_end, g) / L*: the share of the way that is done, below zero where the rest is
/// longer than the whole was. The geodesic is that of the references: of the inscribed disc, the
/// straight line where that is free, else the exact search to 1 %.
class Progress : public Metric {
 public:
  QuantityInfo info() const override { return {"progress", 1, "Progress", "-", Direction::Up}; }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_without_verdict(context)) return *na;
    if (const auto na = na_without_samples(context)) return *na;
    if (const auto na = na_without_shortest(context)) return *na;
    const auto& end = context.trajectory.samples.back().pose;
    const TPoint2D from(end.x, end.y), goal = context.world.scenario().goal();
    const double wanted = context.robot.shape().inscribed_radius();
    const double radius = std::min(wanted, context.world.distance_field().clearance(from));
    if (radius < wanted - kContactDepth) return Value::na("the run ends inside an obstacle");
    const double best = context.references.shortest->length;
    if (is_free(context.world, {from, goal}, radius))
      return Value::of(1 - length({from, goal}) / best);
    std::string reason;
    const auto rest = exact_shortest_path({context.world, radius, from, goal}, kGap, reason);
    if (!rest) return Value::na("from the end: " + reason);
    return Value::of(1 - rest->length / best);
  }

 private:
  /// A run that ends at a contact ends this much (m) inside it at most: the geodesic is then that
  /// of a robot thinner by so much.
  static constexpr double kContactDepth = 1e-3;
  static constexpr double kGap = 0.01;
};

}  // namespace

MetricPtr make_final_distance() {
  return std::make_shared<FinalDistance>();
}
MetricPtr make_closest_distance() {
  return std::make_shared<ClosestDistance>();
}
MetricPtr make_progress() {
  return std::make_shared<Progress>();
}

}  // namespace slalom
