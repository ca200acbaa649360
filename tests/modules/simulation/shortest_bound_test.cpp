#include "test_runs.h"

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
    while (next_ + 1 < path_.size() && length({{o.odometry.x, o.odometry.y}, path_[next_]}) < 0.03)
      ++next_;
    const TPoint2D to = path_[next_];
    const double c = std::cos(o.odometry.phi), s = std::sin(o.odometry.phi);
    const double dx = to.x - o.odometry.x, dy = to.y - o.odometry.y;
    return head_for({c * dx + s * dy, -s * dx + c * dy}, robot_);
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

/// A run extended to the goal is never shorter than the certified bound of the shortest path, even
/// if it follows the shortest path of a slightly larger robot.
TEST(Simulate, IsNeverShorterThanTheCertifiedShortestPath) {
  RandomEngine random(21);
  const RobotModel robot;
  int reached = 0;
  for (int i = 0; i < 15; ++i) {
    const World world = discs(random);
    const PlanningProblem problem{world, robot.radius, {1, 1}, {9, 9}};
    PlanningProblem wider = problem;
    wider.robot_radius = robot.radius + 0.04;
    std::string reason;
    const auto shortest = exact_shortest_path(problem, reason);
    const auto guide = exact_shortest_path(wider, reason);
    if (!shortest || !guide) continue;
    PathFollower method(guide->path, robot);
    const SimulationResult result = run(world, method);
    if (result.outcome != Outcome::Success) continue;
    ++reached;
    Path traveled = result.trajectory.path();
    traveled.push_back(world.scenario().goal());
    EXPECT_GE(length(traveled), shortest->certificate.lower_bound * (1 - 1e-9));
    EXPECT_LE(length(traveled), 1.1 * guide->length);
  }
  EXPECT_GE(reached, 8);
}

}  // namespace
}  // namespace slalom::testing
