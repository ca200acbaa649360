// SPDX-License-Identifier: BSD-3-Clause
#include "common.h"

#include <algorithm>

namespace slalom::metrics {

/// L: length of the path driven (positions only).
Value path_length(const MetricContext& context) {
  if (const auto na = na_without_samples(context)) return *na;
  return Value::of(context.trajectory.traveled());
}

/// L* / L, L = closed_length().
Value optimality(const MetricContext& context) {
  if (const auto na = na_unless_reached(context)) return *na;
  if (const auto na = na_without_shortest(context)) return *na;
  const Value closed = closed_length(context);
  if (closed.is_na()) return closed;
  return Value::of(best_length(context) / closed.number());
}

/// Success weighted by path length (Anderson et al. 2018): S L* / max(L, L*), L = closed_length().
Value spl(const MetricContext& context) {
  if (const auto na = na_without_verdict(context)) return *na;
  if (context.outcome != Outcome::Success) return Value::of(0);
  if (const auto na = na_without_samples(context)) return *na;
  if (const auto na = na_without_shortest(context)) return *na;
  const Value closed = closed_length(context);
  if (closed.is_na()) return closed;
  const double best = best_length(context);
  return Value::of(best / std::max(closed.number(), best));
}

/// (1/L*) integral along the trajectory of the distance to P* (the framework paper integrates over
/// cells).
Value optimality_area(const MetricContext& context) {
  if (const auto na = na_unless_reached(context)) return *na;
  if (const auto na = na_without_shortest(context)) return *na;
  return Value::of(area_between(context.trajectory.path(), context.references.shortest->path) /
                   best_length(context));
}

/// (L - L*) / L*, L = closed_length().
Value path_excess(const MetricContext& context) {
  if (const auto na = na_unless_reached(context)) return *na;
  if (const auto na = na_without_shortest(context)) return *na;
  const Value closed = closed_length(context);
  if (closed.is_na()) return closed;
  return Value::of(closed.number() / best_length(context) - 1);
}

}  // namespace slalom::metrics
