// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/metrics/metric.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace slalom::testing {

/// A run with known values: an empty room of 28 m x 10 m, goal (8, 5), robot of 0.25 m. Far from
/// the walls on the left and right the clearance at (x, y) is min(y, 10 - y).
struct MeasuredRun {
  World world;
  RobotModel robot;
  Trajectory trajectory;
  Outcome outcome = Outcome::Success;
  References references;
  double safe_distance = 0.5;

  /// Samples at these points, one every 0.1 s.
  explicit MeasuredRun(const Path& points, const Primitives& obstacles = {},
                       const Movers& movers = {})
      : world(Scenario::continuous("room", {-10, 0, 18, 10}, obstacles, {2, 5, 0}, {8, 5})
                  .with_movers(movers),
              0.05) {
    for (const auto& p : points) {
      Sample sample;
      sample.t = 0.1 * static_cast<double>(trajectory.samples.size());
      sample.pose = {p.x, p.y, 0};
      trajectory.samples.push_back(sample);
    }
    set_shortest({{2, 5}, {8, 5}});
    set_safest({{2, 5}, {8, 5}});
  }

  void set_shortest(const Path& path) {
    const double l = length(path);
    references.shortest = ShortestPath{};
    references.shortest->path = path;
    references.shortest->length = references.shortest->exact_length = l;
    references.shortest->certificate = {l, l};
    references.shortest->planner = "exact";
  }
  void set_safest(const Path& path) {
    double bottleneck = world.distance_field().clearance(path.front());
    for (const auto& p : resample(path, 0.01))
      bottleneck = std::min(bottleneck, world.distance_field().clearance(p));
    references.safest = SafestPath{};
    references.safest->path = path;
    references.safest->bottleneck = bottleneck;
  }

  Value value(const std::string& id) const {
    return metric(id).compute(
        make_metric_context(world, robot, trajectory, outcome, references, 60, 0.2, safe_distance));
  }
  /// The number; NaN for NA.
  double number(const std::string& id) const {
    const Value v = value(id);
    return v.is_na() ? std::nan("") : v.number();
  }
  std::string reason(const std::string& id) const { return value(id).reason(); }
};

/// A run sampled from a function of time at `hz` from 0 s to `seconds`.
struct SampledRun : MeasuredRun {
  template <typename SampleAt>
  SampledRun(double seconds, double hz, SampleAt sample_at) : MeasuredRun(Path{}) {
    for (int i = 0; i <= std::lround(seconds * hz); ++i) {
      Sample sample = sample_at(i / hz);
      sample.t = i / hz;
      trajectory.samples.push_back(sample);
    }
  }
};

}  // namespace slalom::testing
