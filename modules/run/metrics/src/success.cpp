// SPDX-License-Identifier: BSD-3-Clause
#include "common.h"

#include <algorithm>

namespace slalom::metrics {

/// 1 if the goal was reached within tolerance and time without collision, else 0. NA if the failure
/// is not attributable to the method: the scenario has no path, or the infrastructure failed.
Value success(const MetricContext& context) {
  if (const auto na = na_without_verdict(context)) return *na;
  return Value::of(context.outcome == Outcome::Success ? 1 : 0);
}

/// Soft success (Datta et al. 2021): max(0, 1 - |p_end - g| / |s - g|)
/// L* / max(L, L*). L is the traveled length.
Value soft_spl(const MetricContext& context) {
  if (const auto na = na_without_verdict(context)) return *na;
  if (const auto na = na_without_samples(context)) return *na;
  if (const auto na = na_without_shortest(context)) return *na;
  const auto& end = context.trajectory.samples.back().pose;
  const auto& start = context.world.scenario().start();
  const auto& goal = context.world.scenario().goal();
  const double straight = length({{start.x, start.y}, goal});
  if (straight <= 0) return Value::na("start and goal coincide");
  const double approached = std::max(0.0, 1 - length({{end.x, end.y}, goal}) / straight);
  const double best = best_length(context);
  return Value::of(approached * best / std::max(context.trajectory.traveled(), best));
}

/// The score of the BARN challenge since 2023: S OT / clip(T, 2 OT, 8 OT), OT = L* / v_max.
Value barn_score_v2(const MetricContext& context) {
  if (const auto na = na_without_verdict(context)) return *na;
  if (context.outcome != Outcome::Success) return Value::of(0);
  if (const auto na = na_without_samples(context)) return *na;
  if (const auto na = na_without_shortest(context)) return *na;
  const double best = best_length(context) / context.robot.max_v;
  return Value::of(best / std::clamp(context.trajectory.duration(), 2 * best, 8 * best));
}

}  // namespace slalom::metrics
