#pragma once

#include <slalom/metrics/metric.h>

#include <cmath>
#include <optional>

namespace slalom {

/// NA with the reason, unless the goal was reached by a trajectory that can be measured.
std::optional<Value> na_unless_reached(const MetricContext& context);

/// NA with the reason when the run left no trajectory to measure.
std::optional<Value> na_without_samples(const MetricContext& context);

/// NA with the outcome as reason where a failure is not the method's: the scenario has no path, or
/// the machinery failed.
std::optional<Value> na_without_verdict(const MetricContext& context);

/// NA with the reason unless there are samples over some time.
std::optional<Value> na_without_time(const MetricContext& context);

/// NA with the reason unless there is a shortest path of some length.
std::optional<Value> na_without_shortest(const MetricContext& context);

/// Length (m) of the trajectory closed by the straight line from its end to the goal. A run ends
/// within goal_tolerance of the goal; without the last stretch it would seem shorter than the best
/// path.
double closed_length(const MetricContext& context);

/// Integral along the path driven of the distance to `reference` (m^2), which is not empty.
double area_between(const Path& driven, const Path& reference);

/// Integral of f along the path, by length: trapezoids on points at most 0.02 m apart.
template <typename Function>
double integrate_along(const Path& path, Function f) {
  constexpr double kSpacing = 0.02;  // m, well under a cell
  const Path points = resample(path, kSpacing);
  if (points.empty()) return 0;
  double sum = 0, before = f(points[0]);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double here = f(points[i]);
    sum += 0.5 * (before + here) *
           std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
    before = here;
  }
  return sum;
}

}  // namespace slalom
