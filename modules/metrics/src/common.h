#pragma once

#include <slalom/metrics/metric.h>

#include <optional>

namespace slalom {

/// NA with the reason, unless the goal was reached by a trajectory that can be measured.
std::optional<Value> na_unless_reached(const MetricContext& context);

/// NA with the reason when the run left no trajectory to measure.
std::optional<Value> na_without_samples(const MetricContext& context);

/// Length (m) of the trajectory closed by the straight line from its end to the goal. A run ends
/// within goal_tolerance of the goal; without the last stretch it would seem shorter than the best
/// path.
double closed_length(const MetricContext& context);

/// Integral of f along the path, by length: trapezoids on points at most 0.02 m apart.
template <typename Function>
double integrate_along(const Path& path, Function f) {
  constexpr double kSpacing = 0.02;  // m, well under a cell
  const Path points = resample(path, kSpacing);
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    sum += 0.5 * (f(points[i - 1]) + f(points[i])) * length({points[i - 1], points[i]});
  return sum;
}

}  // namespace slalom
