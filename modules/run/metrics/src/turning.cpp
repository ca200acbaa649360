// SPDX-License-Identifier: BSD-3-Clause
#include "common.h"
#include "curve.h"

#include <mrpt/math/wrap2pi.h>

#include <algorithm>

namespace slalom::metrics {
namespace {

/// NA with the reason unless the robot moved by more than 1 mm.
std::optional<Value> na_without_motion(const MetricContext& context, const Path& path) {
  if (const auto na = na_without_samples(context)) return na;
  if (without_close_points(path).size() >= 2) return std::nullopt;
  return Value::na("the robot did not move");
}

}  // namespace

/// Sum of |change of heading| between samples.
Value cumulative_heading_change(const MetricContext& context) {
  if (const auto na = na_without_time(context)) return *na;
  const auto& samples = context.trajectory.samples;
  double sum = 0;
  for (std::size_t i = 1; i < samples.size(); ++i)
    sum += std::abs(mrpt::math::wrapToPi(samples[i].pose.phi - samples[i - 1].pose.phi));
  return Value::of(sum);
}

/// Rotation of the traveled path per meter.
Value angle_over_length(const MetricContext& context) {
  const Path path = context.trajectory.path();
  if (const auto na = na_without_motion(context, path)) return *na;
  return Value::of(rotation(path) / context.trajectory.traveled());
}

/// max(0, rotation of the traveled path - rotation of P*) / L (Guzzi et al. 2013).
Value path_irregularity(const MetricContext& context) {
  if (const auto na = na_unless_reached(context)) return *na;
  if (!context.references.shortest) return Value::na(context.references.shortest_reason);
  const Path path = context.trajectory.path();
  if (const auto na = na_without_motion(context, path)) return *na;
  const double excess = rotation(path) - rotation(context.references.shortest->path);
  return Value::of(std::max(0.0, excess) / context.trajectory.traveled());
}

}  // namespace slalom::metrics
