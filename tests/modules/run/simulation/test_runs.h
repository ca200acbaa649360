// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/random.h>
#include <slalom/simulation/simulate.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace slalom::testing {

/// A method that is a function of the observation.
class FunctionMethod : public Method {
 public:
  using Function = std::function<Command(const Observation&)>;
  explicit FunctionMethod(Function function) : function_(std::move(function)) {}
  void reset(const NavigationTask&) override {}
  Command step(const Observation& observation) override { return function_(observation); }

 private:
  Function function_;
};

/// Random commands within the limits, drawn from the task's seed.
class RandomMethod : public Method {
 public:
  explicit RandomMethod(const RobotModel& robot) : robot_(robot) {}
  void reset(const NavigationTask& task) override { random_ = RandomEngine(task.seed); }
  Command step(const Observation&) override {
    return {uniform_real(random_, 0, robot_.max_v),
            uniform_real(random_, -robot_.max_w, robot_.max_w)};
  }

 private:
  RobotModel robot_;
  RandomEngine random_;
};

inline FunctionMethod constant_method(double v, double w) {
  return FunctionMethod([=](const Observation&) { return Command{v, w}; });
}

/// Rotates in place towards a point, then moves to it.
inline Command head_for(const mrpt::math::TPoint2D& in_robot, const RobotModel& robot) {
  const double bearing = std::atan2(in_robot.y, in_robot.x);
  const double w = std::clamp(3 * bearing, -robot.max_w, robot.max_w);
  const double v = std::clamp(std::hypot(in_robot.x, in_robot.y), 0.1, robot.max_v);
  return {std::abs(bearing) < 0.05 ? v : 0, w};
}

/// A square of 10 m x 10 m, empty or with these obstacles.
inline World square_world(const mrpt::math::TPose2D& start, const mrpt::math::TPoint2D& goal,
                          const Primitives& obstacles = {}) {
  return {Scenario::continuous("square_world", {0, 0, 10, 10}, obstacles, start, goal), 0.05};
}

inline SimulationResult run(const World& world, Method& method,
                            const SimulationOptions& options = {}, const RobotModel& robot = {},
                            std::uint64_t seed = 1) {
  return simulate(world, {robot, {}, {}, options, {}}, seed, method);
}

/// A grid with about this fraction of occupied cells, free around the start in its center.
inline World random_cells(RandomEngine& random, double fraction) {
  constexpr int kCells = 60;
  constexpr double kResolution = 0.1;  // m
  mrpt::maps::COccupancyGridMap2D map(0, kCells * kResolution, 0, kCells * kResolution,
                                      static_cast<float>(kResolution));
  map.fill(1.0F);
  for (int y = 0; y < kCells; ++y)
    for (int x = 0; x < kCells; ++x)
      if (std::hypot(x - 30, y - 30) > 6 && uniform_real(random, 0, 1) < fraction)
        map.setCell(x, y, 0.0F);
  const double middle = 0.5 * kCells * kResolution;
  return {Scenario::grid("cells", map, {middle, middle, uniform_real(random, -3, 3)}, {0.01, 0.01}),
          kResolution};
}

}  // namespace slalom::testing
