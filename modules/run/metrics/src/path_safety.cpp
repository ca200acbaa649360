// SPDX-License-Identifier: BSD-3-Clause
#include "common.h"

namespace slalom::metrics {
namespace {

/// For the inscribed disc of the footprint, because a path has no heading.
double mean_footprint_clearance(const MetricContext& context, const Path& path) {
  const DistanceField& field = context.world.distance_field();
  const double integral =
      integrate_along(path, [&](const mrpt::math::TPoint2D& p) { return field.clearance(p); });
  return integral / length(path) - context.robot.shape().inscribed_radius();
}

}  // namespace

/// (mean clearance of the footprint along the trajectory, by length) / (the same along P_V).
Value safety(const MetricContext& context) {
  if (const auto na = na_unless_reached(context)) return *na;
  if (!context.references.safest) return Value::na(context.references.safest_reason);
  const Path traveled = context.trajectory.path();
  if (length(traveled) <= 0 || length(context.references.safest->path) <= 0)
    return Value::na("a path of zero length has no mean clearance");
  const double best = mean_footprint_clearance(context, context.references.safest->path);
  if (best <= 0) return Value::na("the safest path has no clearance");
  return Value::of(mean_footprint_clearance(context, traveled) / best);
}

/// (1/|P_V|) integral along the trajectory of the distance to P_V.
Value safety_area(const MetricContext& context) {
  if (const auto na = na_unless_reached(context)) return *na;
  if (!context.references.safest) return Value::na(context.references.safest_reason);
  const Path& best = context.references.safest->path;
  if (length(best) <= 0) return Value::na("the safest path has zero length");
  return Value::of(area_between(context.trajectory.path(), best) / length(best));
}

}  // namespace slalom::metrics
