#include "common.h"

#include <algorithm>

namespace slalom::metrics {

/// L: length of the traveled path (positions only).
Value path_length(const MetricContext& context) {
  if (const auto na = na_without_samples(context)) return *na;
  return Value::of(length(context.trajectory.path()));
}

/// L* / L, L = closed_length().
Value optimality(const MetricContext& context) {
  if (const auto na = na_unless_reached(context)) return *na;
  if (!context.references.shortest) return Value::na(context.references.shortest_reason);
  const double traveled = closed_length(context);
  if (traveled <= 0) return Value::na("start and goal coincide");
  return Value::of(best_length(context) / traveled);
}

/// Success weighted by path length (Anderson et al. 2018): S L* / max(L, L*), L = closed_length().
Value spl(const MetricContext& context) {
  if (const auto na = na_without_verdict(context)) return *na;
  if (context.outcome != Outcome::Success) return Value::of(0);
  if (const auto na = na_without_samples(context)) return *na;
  if (!context.references.shortest) return Value::na(context.references.shortest_reason);
  const double best = best_length(context);
  const double longer = std::max(closed_length(context), best);
  return longer > 0 ? Value::of(best / longer) : Value::na("start and goal coincide");
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
  return Value::of(closed_length(context) / best_length(context) - 1);
}

}  // namespace slalom::metrics
