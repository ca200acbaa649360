// SPDX-License-Identifier: BSD-3-Clause
#include "common.h"
#include "path_similarity.h"

namespace slalom::metrics {
namespace {

/// A distance of the traveled path to P*.
Value distance_to_shortest(const MetricContext& context,
                           double (*measure)(const Path&, const Path&)) {
  if (const auto na = na_unless_reached(context)) return *na;
  if (!context.references.shortest) return Value::na(context.references.shortest_reason);
  return Value::of(measure(context.trajectory.path(), context.references.shortest->path));
}

}  // namespace

Value frechet_to_reference(const MetricContext& context) {
  return distance_to_shortest(context, frechet_distance);
}

Value hausdorff_to_reference(const MetricContext& context) {
  return distance_to_shortest(context, hausdorff_distance);
}

}  // namespace slalom::metrics
