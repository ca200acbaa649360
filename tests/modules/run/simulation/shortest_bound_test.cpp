// SPDX-License-Identifier: BSD-3-Clause
#include "test_runs.h"

#include <slalom/references/disc_path.h>
#include <slalom/references/exact_shortest.h>

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

using mrpt::math::TPoint2D;

/// Moves to the vertices of a path, one after the other.
class PathFollower : public Method {
 public:
  PathFollower(Path path, const RobotModel& robot) : path_(std::move(path)), robot_(robot) {}
  void reset(const NavigationTask&) override { next_ = 1; }
  Command step(const Observation& o) override {
    while (next_ + 1 < path_.size() && length({{o.odometry.x, o.odometry.y}, path_[next_]}) < 0.3)
      ++next_;
    const TPoint2D to = path_[next_];
    const double c = std::cos(o.odometry.phi), s = std::sin(o.odometry.phi);
    const double dx = to.x - o.odometry.x, dy = to.y - o.odometry.y;
    const double bearing = std::atan2(-s * dx + c * dy, c * dx + s * dy);
    const double w = std::clamp(2 * bearing, -robot_.max_w, robot_.max_w);
    return {std::abs(bearing) < 0.8 ? 0.5 * robot_.max_v : 0, w};
  }

 private:
  Path path_;
  RobotModel robot_;
  std::size_t next_ = 1;
};

World discs(RandomEngine& random) {
  Primitives obstacles;
  for (int i = 0; i < 12; ++i) {
    const TPoint2D at(uniform_real(random, 0, 10), uniform_real(random, 0, 10));
    if (length({at, {1, 1}}) > 1.2 && length({at, {9, 9}}) > 1.2)
      obstacles.discs.push_back({at, uniform_real(random, 0.2, 0.8)});
  }
  return square_world({1, 1, 0}, {9, 9}, obstacles);
}

/// The distance driven, extended to the goal, is never below the certified bound of the shortest
/// path, even if the run follows the shortest path of a slightly larger robot in wide arcs, with
/// few control cycles, and ends far from the goal.
TEST(Simulate, IsNeverShorterThanTheCertifiedShortestPath) {
  RandomEngine random(21);
  RobotModel robot;
  robot.max_accel_v = robot.max_accel_w = 10;
  SimulationOptions options;
  options.control_period = 0.4;
  options.goal_tolerance = 1;
  int reached = 0;
  for (int i = 0; i < 40; ++i) {
    const World world = discs(random);
    const PlanningProblem problem{world, robot.radius, {1, 1}, {9, 9}};
    PlanningProblem wider = problem;
    wider.robot_radius = robot.radius + 0.04;
    std::string reason;
    const auto shortest = exact_shortest_path(problem, reason);
    const auto guide = exact_shortest_path(wider, reason);
    if (!shortest || !guide) continue;
    PathFollower method(guide->path, robot);
    const SimulationResult result = run(world, method, options, robot);
    if (result.outcome != Outcome::Success) continue;
    ++reached;
    const auto& end = result.trajectory.samples.back().pose;
    const auto rest =
        shortest_disc_path(world.occupancy(), robot.radius, {end.x, end.y}, {9, 9}, reason);
    ASSERT_TRUE(rest.has_value()) << reason;
    const double closed = result.trajectory.traveled() + rest->length;
    EXPECT_GE(closed, shortest->certificate.lower_bound * (1 - 1e-9));
    EXPECT_LE(closed, 1.2 * guide->length);
  }
  EXPECT_GE(reached, 8);
}

}  // namespace
}  // namespace slalom::testing
