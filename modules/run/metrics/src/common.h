// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/distance.h>
#include <slalom/metrics/metric.h>

#include <optional>

namespace slalom {

/// NA with the reason, unless the run reached the goal and has a trajectory.
std::optional<Value> na_unless_reached(const MetricContext& context);

/// NA with the reason if the run has no trajectory.
std::optional<Value> na_without_samples(const MetricContext& context);

/// NA with the outcome as reason if a failure is not attributable to the method: the scenario has
/// no path, or the infrastructure failed.
std::optional<Value> na_without_verdict(const MetricContext& context);

/// NA with the reason unless the trajectory has a positive duration.
std::optional<Value> na_without_time(const MetricContext& context);

/// NA with the reason unless there is a shortest path of positive length.
std::optional<Value> na_without_shortest(const MetricContext& context);

/// L* (m): the optimum of the inscribed disc, whatever the planner. No robot's path is shorter,
/// with the geodesics of that disc that extend it to the goal. Requires a shortest path.
double best_length(const MetricContext& context);

/// Length (m) of the exact shortest path of a disc; nullopt with the reason if there is none.
std::optional<double> geodesic(const MetricContext& context, double radius,
                               const mrpt::math::TPoint2D& from, const mrpt::math::TPoint2D& to,
                               std::string& reason);

/// L_closed (m): the length of the trajectory, extended to start and goal by geodesics of the
/// inscribed disc. A run ends within goal_tolerance of the goal, and a log may begin beside the
/// start; without these it could be shorter than the shortest path. A length below L* by no more
/// than rounding errors is L*. NA with the reason if there is no such path, as from inside an
/// obstacle. Requires a shortest path.
Value closed_length(const MetricContext& context);

/// Integral along the traveled path of the distance to `reference` (m^2), which must not be empty.
double area_between(const Path& traveled, const Path& reference);

/// Integral of f along the path by arc length: trapezoidal rule on points at most 0.02 m apart.
template <typename Function>
double integrate_along(const Path& path, Function f) {
  constexpr double kSpacing = 0.02;  // m, well below a cell
  const Path points = resample(path, kSpacing);
  if (points.empty()) return 0;
  double sum = 0, before = f(points[0]);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double here = f(points[i]);
    sum += 0.5 * (before + here) * distance_between(points[i], points[i - 1]);
    before = here;
  }
  return sum;
}

}  // namespace slalom
