// SPDX-License-Identifier: BSD-3-Clause
#include "common.h"

#include <slalom/core/math.h>

#include <algorithm>

namespace slalom::metrics {

/// Combined optimality and safety. o = 1 - clamp((L - L*) / L*, 0, 1), s = 1 - clamp((m_V - m) /
/// m_V, 0, 1) with m the minimum clearance of the run and m_V that of P_V; the norm of (o, s),
/// scaled to [0, 1], is reduced by their difference: (1 - |o - s|) sqrt(o^2 + s^2) / sqrt 2. L is
/// closed_length().
Value optisafe(const MetricContext& context) {
  const auto retained_fraction = [](double loss) { return 1 - std::clamp(loss, 0.0, 1.0); };
  if (const auto na = na_unless_reached(context)) return *na;
  if (const auto na = na_without_shortest(context)) return *na;
  if (!context.references.safest) return Value::na(context.references.safest_reason);
  const double widest =
      context.references.safest->bottleneck - context.robot.shape().inscribed_radius();
  if (widest <= 0) return Value::na("the safest path has no clearance");
  const Value closed = closed_length(context);
  if (closed.is_na()) return closed;
  const double best = best_length(context);
  const double nearest = *std::min_element(context.clearances.begin(), context.clearances.end());
  const double o = retained_fraction((closed.number() - best) / best);
  const double s = retained_fraction((widest - nearest) / widest);
  return Value::of((1 - std::abs(o - s)) * math::hypot(o, s) / std::sqrt(2.0));
}

}  // namespace slalom::metrics
