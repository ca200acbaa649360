// SPDX-License-Identifier: BSD-3-Clause
#include "common.h"
#include "path_distance.h"

#include <slalom/core/text.h>
#include <slalom/references/disc_path.h>

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
  return context.references.shortest->exact_length;
}

namespace {

std::string arrival_violation(const MetricContext& context) {
  constexpr double kRounding = 1e-9;  // s
  if (!context.references.arrival) return "";
  const double earliest = context.references.arrival->certificate.lower_bound;
  const double duration = context.trajectory.duration();
  if (duration >= earliest - kRounding) return "";
  return "the run is faster than possible: " + format_number(duration) +
         " s, earliest arrival among the moving obstacles " + format_number(earliest) + " s";
}

}  // namespace

std::string bound_violation(const MetricContext& context) {
  if (na_unless_reached(context) || !context.references.shortest) return "";
  if (const std::string violation = arrival_violation(context); !violation.empty())
    return violation;
  const Value closed = closed_length(context);
  const double best = best_length(context);
  if (closed.is_na() || closed.number() >= best) return "";
  return "the run is shorter than possible: " + format_number(closed.number()) +
         " m with the rest to the goal, shortest path " + format_number(best) + " m";
}

double area_between(const Path& traveled, const Path& reference) {
  PathDistance distance(reference);
  return integrate_along(traveled, [&](const mrpt::math::TPoint2D& p) { return distance(p); });
}

std::optional<double> geodesic(const MetricContext& context, double radius,
                               const mrpt::math::TPoint2D& from, const mrpt::math::TPoint2D& to,
                               std::string& reason) {
  if (is_free(context.world, {from, to}, radius)) return distance_between(from, to);
  const auto path = shortest_disc_path(context.world.occupancy(), radius, from, to, reason);
  if (!path) return std::nullopt;
  return path->length;
}

Value closed_length(const MetricContext& context) {
  constexpr double kRounding = 1e-9;  // relative
  const Scenario& scenario = context.world.scenario();
  const double radius = context.robot.shape().inscribed_radius();
  const mrpt::math::TPoint2D start(scenario.start()),
      first(context.trajectory.samples.front().pose), last(context.trajectory.samples.back().pose);
  std::string reason;
  const auto before = geodesic(context, radius, start, first, reason);
  if (!before) return Value::na("to the first pose: " + reason);
  const auto after = geodesic(context, radius, last, scenario.goal(), reason);
  if (!after) return Value::na("from the final pose: " + reason);
  const double closed = *before + context.trajectory.traveled() + *after;
  const double best = best_length(context);
  return Value::of(closed < best && closed >= best * (1 - kRounding) ? best : closed);
}

}  // namespace slalom
