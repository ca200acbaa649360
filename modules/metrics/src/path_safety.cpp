#include "common.h"
#include "families.h"

namespace slalom {
namespace {

/// Of the disc inscribed in the footprint: a path has no heading.
double mean_footprint_clearance(const MetricContext& context, const Path& path) {
  const DistanceField& field = context.world.distance_field();
  const double integral =
      integrate_along(path, [&](const mrpt::math::TPoint2D& p) { return field.clearance(p); });
  return integral / length(path) - context.robot.shape().inscribed_radius();
}

/// (mean clearance along the trajectory, by length) / (the same along P_V), of the footprint.
class Safety : public Metric {
 public:
  QuantityInfo info() const override { return {"safety", 1, "Safety", "-", Direction::Up}; }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_unless_reached(context)) return *na;
    if (!context.references.safest) return Value::na(context.references.safest_reason);
    const Path driven = context.trajectory.path();
    if (length(driven) <= 0 || length(context.references.safest->path) <= 0)
      return Value::na("a path of no length has no mean clearance");
    const double best = mean_footprint_clearance(context, context.references.safest->path);
    if (best <= 0) return Value::na("the safest path has no clearance");
    return Value::of(mean_footprint_clearance(context, driven) / best);
  }
};

/// (1/|P_V|) integral along the trajectory of the distance to P_V.
class SafetyArea : public Metric {
 public:
  QuantityInfo info() const override {
    return {"safety_area", 1, "Safety area", "m", Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_unless_reached(context)) return *na;
    if (!context.references.safest) return Value::na(context.references.safest_reason);
    const Path& best = context.references.safest->path;
    if (length(best) <= 0) return Value::na("the safest path has no length");
    return Value::of(area_between(context.trajectory.path(), best) / length(best));
  }
};

}  // namespace

MetricPtr make_safety() {
  return std::make_shared<Safety>();
}
MetricPtr make_safety_area() {
  return std::make_shared<SafetyArea>();
}

}  // namespace slalom
