// SPDX-License-Identifier: BSD-3-Clause
#include "common.h"
#include "mover_encounters.h"

namespace slalom::metrics {

/// T on success.
Value time_to_goal(const MetricContext& context) {
  if (const auto na = na_unless_reached(context)) return *na;
  return Value::of(context.trajectory.duration());
}

/// T on success, 2 T_max on failure (PAR2, penalized average runtime).
Value par2_time(const MetricContext& context) {
  if (const auto na = na_without_verdict(context)) return *na;
  if (context.outcome != Outcome::Success) return Value::of(2 * context.max_time);
  if (const auto na = na_without_samples(context)) return *na;
  return Value::of(context.trajectory.duration());
}

/// T / (L* / v_max): time relative to the shortest path at maximum speed.
Value time_ratio(const MetricContext& context) {
  if (const auto na = na_unless_reached(context)) return *na;
  if (const auto na = na_without_time(context)) return *na;
  if (const auto na = na_without_shortest(context)) return *na;
  return Value::of(context.trajectory.duration() * context.robot.max_v / best_length(context));
}

/// T / the lower bound of the earliest arrival among movers.
Value arrival_ratio(const MetricContext& context) {
  if (const auto na = na_without_movers(context)) return *na;
  if (const auto na = na_unless_reached(context)) return *na;
  if (const auto na = na_without_shortest(context)) return *na;
  if (!context.references.arrival) {
    const std::string& reason = context.references.arrival_reason;
    if (!reason.empty()) return Value::na(reason);
    return Value::na(context.hindrances.empty() ? "the earliest arrival was not computed"
                                                : "people may notice the robot");
  }
  const double earliest = context.references.arrival->certificate.lower_bound;
  if (earliest == 0) return Value::na("the start is in the goal region");
  return Value::of(context.trajectory.duration() / earliest);
}

}  // namespace slalom::metrics
