#include "common.h"
#include "path_distance.h"

namespace slalom {

std::optional<Value> na_unless_reached(const MetricContext& context) {
  if (context.outcome != Outcome::Success)
    return Value::na("outcome: " + to_string(context.outcome));
  return na_without_samples(context);
}

std::optional<Value> na_without_samples(const MetricContext& context) {
  if (!context.trajectory.samples.empty()) return std::nullopt;
  return Value::na("no trajectory");
}

std::optional<Value> na_without_verdict(const MetricContext& context) {
  if (context.outcome != Outcome::UnsolvableScenario &&
      context.outcome != Outcome::InfrastructureError)
    return std::nullopt;
  return Value::na("outcome: " + to_string(context.outcome));
}

std::optional<Value> na_without_time(const MetricContext& context) {
  if (const auto na = na_without_samples(context)) return na;
  if (context.trajectory.duration() > 0) return std::nullopt;
  return Value::na("zero duration");
}

std::optional<Value> na_without_shortest(const MetricContext& context) {
  if (!context.references.shortest) return Value::na(context.references.shortest_reason);
  if (best_length(context) > 0) return std::nullopt;
  return Value::na("start and goal coincide");
}

double best_length(const MetricContext& context) {
  return context.references.shortest->certificate.lower_bound;
}

double area_between(const Path& traveled, const Path& reference) {
  PathDistance distance(reference);
  return integrate_along(traveled, [&](const mrpt::math::TPoint2D& p) { return distance(p); });
}

double closed_length(const MetricContext& context) {
  Path path = context.trajectory.path();
  path.push_back(context.world.scenario().goal());
  return length(path);
}

}  // namespace slalom
