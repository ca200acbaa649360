#include "common.h"
#include "curve.h"
#include "families.h"

#include <mrpt/math/wrap2pi.h>

#include <algorithm>

namespace slalom {
namespace {

/// NA with the reason unless the robot moved by more than rounding.
std::optional<Value> na_without_way(const MetricContext& context, const Path& path) {
  if (const auto na = na_without_samples(context)) return na;
  if (without_close_points(path).size() >= 2) return std::nullopt;
  return Value::na("the robot did not move");
}

/// Sum of |change of heading| between samples.
class CumulativeHeadingChange : public Metric {
 public:
  QuantityInfo info() const override {
    return {"cumulative_heading_change", 1, "Heading change", "rad", Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_without_time(context)) return *na;
    const auto& samples = context.trajectory.samples;
    double sum = 0;
    for (std::size_t i = 1; i < samples.size(); ++i)
      sum += std::abs(mrpt::math::wrapToPi(samples[i].pose.phi - samples[i - 1].pose.phi));
    return Value::of(sum);
  }
};

/// Rotation of the path driven per metre.
class AngleOverLength : public Metric {
 public:
  QuantityInfo info() const override {
    return {"angle_over_length", 1, "Angle over length", "rad/m", Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    const Path path = context.trajectory.path();
    if (const auto na = na_without_way(context, path)) return *na;
    return Value::of(rotation(path) / length(path));
  }
};

/// max(0, rotation of the path driven - rotation of P*) / L (Guzzi et al. 2013).
class PathIrregularity : public Metric {
 public:
  QuantityInfo info() const override {
    return {"path_irregularity", 1, "Path irregularity", "rad/m", Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_unless_reached(context)) return *na;
    if (!context.references.shortest) return Value::na(context.references.shortest_reason);
    const Path path = context.trajectory.path();
    if (const auto na = na_without_way(context, path)) return *na;
    const double unneeded = rotation(path) - rotation(context.references.shortest->path);
    return Value::of(std::max(0.0, unneeded) / length(path));
  }
};

}  // namespace

MetricPtr make_cumulative_heading_change() {
  return std::make_shared<CumulativeHeadingChange>();
}
MetricPtr make_angle_over_length() {
  return std::make_shared<AngleOverLength>();
}
MetricPtr make_path_irregularity() {
  return std::make_shared<PathIrregularity>();
}

}  // namespace slalom
