// SPDX-License-Identifier: BSD-3-Clause
#include "in_child.h"
#include "ompl_worlds.h"
#include "pose_motions.h"
#include "pose_roadmap.h"
#include "pose_smoothing.h"

#include <slalom/core/distance.h>
#include <slalom/core/text.h>
#include <slalom/ompl/ompl_planner.h>
#include <slalom/references/footprint_path.h>
#include <slalom/references/reference_codec.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPose2D;

RobotModel car(bool forward_only = true) {
  RobotModel robot;
  robot.min_turning_radius = 0.5;
  robot.forward_only = forward_only;
  return robot;
}

RobotModel rectangle(const std::string& corners = "0.3,0.15; -0.3,0.15; -0.3,-0.15; 0.3,-0.15") {
  RobotModel robot;
  robot.footprint = corners;
  robot.radius = robot.shape().enclosing_radius();
  return robot;
}

PlanningProblem problem_of(const World& world, const RobotModel& robot) {
  PlanningProblem problem = slalom::problem_of(world);
  problem.robot_radius = robot.shape().inscribed_radius();
  return problem;
}

/// In a child process, since OMPL seeds its random numbers once per process.
References references_of(const World& world, const RobotModel& robot, OmplOptions options = {}) {
  options.planner = kExactPlanner;
  options.max_pose_iterations = 200;
  const std::string bytes = in_child([&] {
    const auto planner = make_ompl_planner(options, robot);
    return to_bytes(compute_references(problem_of(world, robot), planner.get(), options.gap, 1));
  });
  return references_from_bytes(bytes, "child");
}

TEST(PosePlanner, BoundsOfACarAreCloseAndItsPathIsOneOfACar) {
  const World world = disc_world();
  for (const bool forward_only : {true, false}) {
    const References references = references_of(world, car(forward_only));
    ASSERT_TRUE(references.shortest.has_value());
    const ShortestPath& shortest = *references.shortest;
    EXPECT_EQ(shortest.planner, "RRTstar") << shortest.note;
    EXPECT_GE(shortest.certificate.lower_bound, shortest.exact_length * (1 - 0.011));
    EXPECT_LE(shortest.certificate.lower_bound, shortest.certificate.upper_bound);
    EXPECT_LT(shortest.certificate.gap(), 0.01);
    EXPECT_TRUE(is_free(world, shortest.path, kRadius));
    EXPECT_EQ(shortest.path.front(), problem_of(world, car()).start);
    EXPECT_EQ(shortest.path.back(), world.scenario().goal());
    if (!forward_only) continue;
    // Each chord lies on an arc of the turning radius or on a straight line: it turns by at most
    // half the sum of the angles of two chords.
    for (std::size_t i = 2; i < shortest.path.size(); ++i) {
      const auto a = shortest.path[i - 1] - shortest.path[i - 2];
      const auto b = shortest.path[i] - shortest.path[i - 1];
      const double turn = std::abs(std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y));
      EXPECT_LE(turn, 0.5 * (a.norm() + b.norm()) / 0.5 + 1e-4) << i;
    }
    const auto first = shortest.path[1] - shortest.path[0];
    EXPECT_NEAR(std::atan2(first.y, first.x), 0, 0.01) << "not in the initial heading";
  }
}

/// Whether the rectangle follows the polyline without contact: it rotates in place at the vertices.
bool follows(const World& world, const RobotModel& robot, const Path& path, double heading) {
  const auto motions = make_pose_motions(world, robot);
  TPose2D at(path[0].x, path[0].y, heading);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double direction = std::atan2(path[i].y - path[i - 1].y, path[i].x - path[i - 1].x);
    const TPose2D to(path[i].x, path[i].y, direction);
    if (!motions->is_free(at, to)) return false;
    for (double t = 0; t <= 1; t += 0.01) {  // by poses, independent of the check of motions
      const TPose2D pose(path[i - 1].x + t * (to.x - path[i - 1].x),
                         path[i - 1].y + t * (to.y - path[i - 1].y), direction);
      if (!motions->is_free_at(pose)) return false;
    }
    at = to;
  }
  return true;
}

TEST(PosePlanner, ARectangleRotatesInPlaceAndDrivesStraight) {
  const World world = disc_world();
  const References references = references_of(world, rectangle());
  const ShortestPath& shortest = references.shortest.value();
  EXPECT_LT(shortest.certificate.gap(), 0.01);
  EXPECT_GE(shortest.certificate.upper_bound, shortest.certificate.lower_bound);
  EXPECT_NEAR(shortest.certificate.lower_bound, shortest.exact_length, 0.01 * shortest.exact_length)
      << "the bound is that of the inscribed disc";
  EXPECT_TRUE(follows(world, rectangle(), shortest.path, 0));
}

TEST(PosePlanner, WithoutAPathOfTheRobotTheUpperBoundIsInfinite) {
  // A corridor of 0.8 m with a bend of 90 degrees, which a rectangle of 2.4 m x 0.3 m cannot take.
  Primitives walls;
  walls.polygons.push_back({{{0, 0.8}, {7.2, 0.8}, {7.2, 8}, {0, 8}}});
  const World world(Scenario::continuous("bend", {0, 0, 8, 8}, walls, {1.5, 0.4, 0}, {7.6, 6}),
                    0.05);
  const RobotModel robot = rectangle("1.2,0.15; -1.2,0.15; -1.2,-0.15; 1.2,-0.15");
  References references = references_of(world, robot);
  const ShortestPath& shortest = references.shortest.value();
  EXPECT_TRUE(std::isinf(shortest.certificate.upper_bound));
  EXPECT_EQ(shortest.note,
            "lattice found no path: no motion of the robot's shape leads from start to goal");
  EXPECT_GT(shortest.certificate.lower_bound, 10);

  refuse_obstructed(problem_of(world, robot), robot.shape(), 0.2, references);
  EXPECT_EQ(references.unsolvable_reason(), kObstructed);
  EXPECT_FALSE(references.shortest || references.safest);

  const RobotModel shorter = rectangle("0.4,0.15; -0.4,0.15; -0.4,-0.15; 0.4,-0.15");
  references = references_of(world, shorter);
  EXPECT_TRUE(std::isfinite(references.shortest->certificate.upper_bound));
  refuse_obstructed(problem_of(world, shorter), shorter.shape(), 0.2, references);
  EXPECT_EQ(references.unsolvable_reason(), "");
}

TEST(PosePlanner, WhereOnlyReversingLeadsToTheGoalTheNoteSaysSo) {
  // A corridor of 0.54 m that is closed in the east.
  Primitives walls;
  walls.polygons.push_back({{{2, 0}, {6, 0}, {6, 1.73}, {2, 1.73}}});
  walls.polygons.push_back({{{2, 2.27}, {6, 2.27}, {6, 4}, {2, 4}}});
  const World world(Scenario::continuous("blind", {0, 0, 6, 4}, walls, {5, 2, 0}, {1, 2}), 0.05);
  RobotModel robot = rectangle("0.4,0.2; -0.4,0.2; -0.4,-0.2; 0.4,-0.2");
  EXPECT_EQ(references_of(world, robot).shortest->note,
            "lattice found no path: a robot that reverses has one of 4 m");
  robot.forward_only = false;
  const References references = references_of(world, robot);
  EXPECT_EQ(references.shortest->note, "");
  EXPECT_NEAR(references.shortest->certificate.upper_bound, 4, 1e-6);

  robot.forward_only = true;
  const World beside(Scenario::continuous("beside", {0, 0, 6, 4}, walls, {5, 2, 0}, {2.5, 2.02}),
                     0.05);
  const std::string note = references_of(beside, robot).shortest->note;
  EXPECT_NE(note.find("a robot that reverses has one of 2.4"), std::string::npos) << note;
  EXPECT_NE(note.find(" m, which ends beside the goal"), std::string::npos) << note;
}

TEST(PosePlanner, AHolonomicPolygonMovesSidewaysWhereItCannotTurn) {
  // A corridor of 0.9 m, in which a rectangle of 0.84 m x 0.4 m stands across.
  Primitives walls;
  walls.polygons.push_back({{{0, 0}, {8, 0}, {8, 1.53}, {0, 1.53}}});
  walls.polygons.push_back({{{0, 2.47}, {8, 2.47}, {8, 4}, {0, 4}}});
  RobotModel robot = rectangle("0.42,0.2; -0.42,0.2; -0.42,-0.2; 0.42,-0.2");
  robot.kinematics = Kinematics::Holonomic;
  for (const double x : {5.9, 5.93, 5.96, 6.01}) {
    const World world(Scenario::continuous("across", {0, 0, 8, 4}, walls, {2, 2, M_PI / 2}, {x, 2}),
                      0.05);
    const References references = references_of(world, robot);
    EXPECT_EQ(references.shortest->note, "") << x;
    EXPECT_NEAR(references.shortest->certificate.upper_bound, x - 2, 1e-6);
  }
  robot.kinematics = Kinematics::DiffDrive;
  robot.forward_only = false;
  const World world(Scenario::continuous("across", {0, 0, 8, 4}, walls, {2, 2, M_PI / 2}, {6, 2}),
                    0.05);
  EXPECT_EQ(references_of(world, robot).shortest->note,
            "lattice found no path: a robot that moves sideways has one of 4 m; if it touches "
            "nothing, one that reverses can follow it as closely as it likes");
}

TEST(PosePlanner, TheSafestPathOfAPolygonIsSampledByDefault) {
  OmplOptions options;
  options.objective = ReferencePlanner::Objective::Clearance;
  const References references = references_of(disc_world(), rectangle(), options);
  ASSERT_TRUE(references.safest);
  EXPECT_TRUE(references.safest->planner == "RRTstar" ||
              references.safest->note.rfind("RRTstar found ", 0) == 0)
      << references.safest->planner << " " << references.safest->note;
}

TEST(PosePlanner, OmplStartsFromThePathOfTheRoadmapIfItIsNotWithinTheGap) {
  const World world = disc_world();
  OmplOptions options;
  options.gap = 1e-9;
  const double with_ompl = references_of(world, car(), options).shortest->certificate.upper_bound;
  options.gap = 0.01;
  const double without = references_of(world, car(), options).shortest->certificate.upper_bound;
  EXPECT_LE(with_ompl, without);
  EXPECT_EQ(references_of(world, car(), options).shortest->certificate.upper_bound, without);
}

TEST(PosePlanner, IsUsedByDefaultOnlyWhereTheHeadingMatters) {
  OmplOptions options;
  options.planner = kExactPlanner;
  EXPECT_EQ(make_ompl_planner(options, RobotModel()), nullptr);
  ASSERT_NE(make_ompl_planner(options, car()), nullptr);
  ASSERT_NE(make_ompl_planner(options, rectangle()), nullptr);
  options.planner = "BITstar";
  EXPECT_EQ(make_ompl_planner(options, rectangle())->name(), "BITstar");
}

TEST(PoseSmoothing, ShortensADetourToTheStraightLine) {
  const World world = disc_world();
  const auto motions = make_pose_motions(world, car());
  const std::vector<TPose2D> detour = {{1, 1, 0}, {2, 1.2, 0.3}, {3.5, 1, -0.3}, {5, 1, 0}};
  EXPECT_NEAR(length(*motions, smooth(*motions, detour)), 4, 1e-6);
  EXPECT_GT(length(*motions, detour), 4.01);
  EXPECT_TRUE(smooth(*motions, {}).empty());
}

TEST(PoseSmoothing, EveryMotionRemainsFree) {
  const World world = disc_world();
  for (const RobotModel& robot : {car(), rectangle()}) {
    const auto motions = make_pose_motions(world, robot);
    const auto found = path_on_roadmap(problem_of(world, robot), *motions);
    ASSERT_GE(found.size(), 2U);
    const auto smoothed = smooth(*motions, found);
    EXPECT_LE(length(*motions, smoothed), length(*motions, found) + 1e-6);
    for (std::size_t i = 1; i < smoothed.size(); ++i)
      EXPECT_TRUE(motions->is_free(smoothed[i - 1], smoothed[i])) << i;
    EXPECT_EQ(smoothed.front(), found.front());
    EXPECT_EQ(distance_between(smoothed.back(), world.scenario().goal()), 0);
  }
}

TEST(PoseMotions, AHolonomicPolygonTurnsWhileItMovesAndOthersDoNot) {
  const World world = disc_world();
  RobotModel robot = rectangle();
  robot.kinematics = Kinematics::Holonomic;
  const TPose2D from(1, 1, 0), to(1, 3, 0);
  EXPECT_DOUBLE_EQ(make_pose_motions(world, robot)->between(from, to, 0.5).phi, 0);
  robot.kinematics = Kinematics::DiffDrive;
  EXPECT_DOUBLE_EQ(make_pose_motions(world, robot)->between(from, to, 0.5).phi, M_PI / 2);
  robot.forward_only = false;
  const auto reverse = rotate_and_drive({1, 3, M_PI / 2}, {1, 1, M_PI / 2}, false);
  EXPECT_NEAR(reverse[1].phi, M_PI / 2, 1e-12) << "backs up instead of turning around twice";
}

}  // namespace
}  // namespace slalom
