// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "in_child.h"
#include "ompl_worlds.h"

#include <slalom/core/hash.h>
#include <slalom/core/text.h>
#include <slalom/ompl/ompl_planner.h>
#include <slalom/references/exact_shortest.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <sstream>

namespace slalom {
namespace {

References exact_of(const World& world) {
  const References exact = compute_references(problem_of(world), nullptr, 0.01, 1);
  if (!exact.shortest) throw std::runtime_error(exact.shortest_reason);
  return exact;
}

std::string path_hash(const Path& path) {
  Hasher hasher;
  for (const auto& p : path) hasher.add(p.x).add(p.y);
  return std::to_string(path.size()) + " points " + hasher.hex();
}

/// Plans in a child process; returns the path's hash or what is wrong with it.
std::string checked_plan(const World& world, const References& exact, const OmplOptions& options,
                         std::uint64_t seed) {
  return in_child([&]() -> std::string {
    std::string reason;
    const auto planner = make_ompl_planner(options);
    const auto path = planner->plan(problem_of(world), exact, seed, reason);
    if (!path) return "no path";
    const double path_length = length(*path);
    const PlanningProblem problem = problem_of(world);
    if (!is_free(world, *path, kRadius)) return "not free";
    if (path->front() != problem.start) return "does not begin at the start";
    if (path->back() != problem.goal) return "does not end at the goal";
    if (path_length < exact.shortest->certificate.lower_bound)
      return "shorter than the lower bound";
    if (path_length > 1.5 * exact.shortest->certificate.upper_bound) return "no short path";
    return path_hash(*path);
  });
}

OmplOptions options_of(const std::string& planner) {
  OmplOptions options;
  options.planner = planner;
  options.gap = 0.02;
  options.max_iterations = 4000;
  return options;
}

const char* const kPlanners[] = {"ABITstar",        "AITstar", "BITstar", "FMT",
                                 "InformedRRTstar", "PRMstar", "RRTstar"};

TEST(OmplPlanner, EveryPlannersPathIsFreeAndNotBelowTheLowerBound) {
  const World world = disc_world();
  const References exact = exact_of(world);
  world.distance_field();
  for (const std::string name : kPlanners) {
    const std::string answer = checked_plan(world, exact, options_of(name), 5);
    EXPECT_NE(answer.find(" points "), std::string::npos) << name << ": " << answer;
  }
}

TEST(OmplPlanner, TheSameSeedInTwoProcessesGivesTheSamePath) {
  const World world = disc_world();
  const References exact = exact_of(world);
  for (const std::string name : {"InformedRRTstar", "BITstar", "RRTstar"}) {
    const std::string first = checked_plan(world, exact, options_of(name), 11);
    EXPECT_NE(first.find(" points "), std::string::npos) << name << ": " << first;
    EXPECT_EQ(checked_plan(world, exact, options_of(name), 11), first) << name;
    EXPECT_NE(checked_plan(world, exact, options_of(name), 12), first) << name;
  }
}

TEST(OmplPlanner, StopsWithinTheGapOfTheLowerBound) {
  const World world = disc_world();
  const References exact = exact_of(world);
  OmplOptions options = options_of("InformedRRTstar");
  options.gap = 0.05;
  const std::string answer = in_child([&] {
    std::string reason;
    const auto path = make_ompl_planner(options)->plan(problem_of(world), exact, 3, reason);
    return path ? std::to_string(length(*path)) : "no path";
  });
  const double path_length = std::strtod(answer.c_str(), nullptr);
  EXPECT_GE(path_length, exact.shortest->certificate.lower_bound) << answer;
  EXPECT_LE(path_length, 1.05 * exact.shortest->certificate.lower_bound + 1e-6);
}

TEST(OmplPlanner, AcceptsSeedsOfAnySize) {
  const World world = disc_world();
  const References exact = exact_of(world);
  for (const std::uint64_t seed : {0ULL, 0xfffffffeULL, ~0ULL}) {
    const std::string first = checked_plan(world, exact, options_of("RRTstar"), seed);
    EXPECT_NE(first.find(" points "), std::string::npos) << seed << ": " << first;
    EXPECT_EQ(checked_plan(world, exact, options_of("RRTstar"), seed), first) << seed;
  }
}

TEST(OmplPlanner, ReturnsNoPathIfThereIsNone) {
  const World world = divided_world();
  References references;
  references.shortest = ShortestPath{{}, 9, {8, 9}, "exact", ""};
  EXPECT_EQ(in_child([&]() -> std::string {
              const auto planner = make_ompl_planner(options_of("RRTstar"));
              std::string reason;
              return planner->plan(problem_of(world), references, 1, reason) ? "a path" : "no path";
            }),
            "no path");
}

/// Plans for a robot in a child process; returns the points of the path as text, or an error.
std::string planned_for(const RobotModel& robot, const World& world, const References& exact,
                        OmplOptions options) {
  options.max_pose_iterations = robot.min_turning_radius > 0 ? 300 : 3000;
  return in_child([&]() -> std::string {
    PlanningProblem problem = problem_of(world);
    problem.robot_radius = robot.shape().inscribed_radius();
    std::string reason;
    const auto path = make_ompl_planner(options, robot)->plan(problem, exact, 7, reason);
    if (!path) return "no path";
    std::string text;
    for (const auto& p : *path) text += format_number(p.x) + " " + format_number(p.y) + " ";
    return text;
  });
}

Path path_from(const std::string& text) {
  std::istringstream numbers(text);
  Path path;
  for (double x = 0, y = 0; numbers >> x >> y;) path.emplace_back(x, y);
  return path;
}

/// Largest turn between adjacent segments per length: the curvature of a finely sampled path.
double max_curvature(const Path& path) {
  double curvature = 0;
  for (std::size_t i = 2; i < path.size(); ++i) {
    const auto a = path[i - 1] - path[i - 2], b = path[i] - path[i - 1];
    if (a.norm() < 1e-6 || b.norm() < 1e-6) continue;
    const double turn = std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
    curvature = std::max(curvature, std::abs(turn) / std::max(a.norm(), b.norm()));
  }
  return curvature;
}

TEST(OmplPlanner, ACarLikeRobotGetsAFeasiblePath) {
  const World world = disc_world();
  RobotModel robot;
  robot.radius = kRadius;
  robot.min_turning_radius = 0.5;
  const Path path = path_from(planned_for(robot, world, exact_of(world), options_of("RRTstar")));
  ASSERT_GT(path.size(), 10U);
  EXPECT_TRUE(is_free(world, path, kRadius - 1e-3));
  EXPECT_LE(max_curvature(path), 1 / 0.5 + 0.1) << "sharper than the turning radius";
  // The path starts in the direction of the initial heading, 0.
  EXPECT_NEAR(std::atan2(path[1].y - path[0].y, path[1].x - path[0].x), 0, 0.06);
}

TEST(OmplPlanner, NeitherForwardOnlyNorReversingPathsAreShorterThanTheLowerBound) {
  const World world = disc_world();
  RobotModel robot;
  robot.radius = kRadius;
  robot.min_turning_radius = 0.8;
  const References exact = exact_of(world);
  const double forward = length(path_from(planned_for(robot, world, exact, options_of("RRTstar"))));
  EXPECT_GE(forward, exact.shortest->certificate.lower_bound - 1e-6);
  robot.forward_only = false;
  const Path both = path_from(planned_for(robot, world, exact, options_of("RRTstar")));
  ASSERT_GT(both.size(), 10U);
  EXPECT_GE(length(both), exact.shortest->certificate.lower_bound - 1e-6);
}

TEST(OmplPlanner, APolygonIsPlannedAsAPolygon) {
  // A gap of 1.02 m: the rectangle, 0.4 m wide, fits through lengthwise; its enclosing disc does
  // not.
  Primitives walls;
  walls.polygons.push_back({{{0, 3.8}, {3.49, 3.8}, {3.49, 4.2}, {0, 4.2}}});
  walls.polygons.push_back({{{4.51, 3.8}, {8, 3.8}, {8, 4.2}, {4.51, 4.2}}});
  const World world(Scenario::continuous("gap", {0, 0, 8, 8}, walls, {4, 1, 1.57}, {4, 7}), 0.05);
  RobotModel robot;
  robot.footprint = "0.6,0.2; -0.6,0.2; -0.6,-0.2; 0.6,-0.2";
  robot.radius = robot.shape().enclosing_radius();
  PlanningProblem problem = problem_of(world);
  problem.robot_radius = robot.shape().inscribed_radius();
  const References exact = compute_references(problem, nullptr, 0.01, 1);
  ASSERT_TRUE(exact.shortest.has_value());
  OmplOptions options = options_of("RRTstar");
  options.gap = 0.2;
  const Path path = path_from(planned_for(robot, world, exact, options));
  ASSERT_GE(path.size(), 2U);
  EXPECT_GE(length(path), exact.shortest->certificate.lower_bound - 1e-6);
  EXPECT_TRUE(is_free(world, path, problem.robot_radius));
}

TEST(OmplPlanner, WithTheClearanceObjectiveItProvidesTheSafestPath) {
  const World world = disc_world();
  const References exact = exact_of(world);
  OmplOptions options = options_of("PRMstar");
  options.objective = ReferencePlanner::Objective::Clearance;
  options.gap = 0.1;
  const Path path = path_from(planned_for({}, world, exact, options));
  ASSERT_GE(path.size(), 2U);
  EXPECT_LE(bottleneck_of(world, path), exact.safest->bottleneck + 1e-6)
      << "wider than the safest path";
  EXPECT_GE(bottleneck_of(world, path), 0.7 * exact.safest->bottleneck);
}

TEST(OmplPlanner, HasTheNameOfThePlannerAndIsNullForExact) {
  EXPECT_EQ(make_ompl_planner(options_of("BITstar"))->name(), "BITstar");
  EXPECT_EQ(make_ompl_planner(options_of("exact")), nullptr);
}

std::string refusal(const std::string& line) {
  const IniFile ini = IniFile::from_text("[reference]\n" + line + "\n", "campaign.ini");
  return error_text(ErrorKind::Usage, [&] { read_options<OmplOptions>(ini, "reference"); });
}

TEST(OmplOptions, AnUnknownPlannerIsRefusedWithTheKnownOnes) {
  const std::string text = refusal("planner = InformedRRT");
  EXPECT_EQ(text.rfind("campaign.ini:2: [reference] planner: ", 0), 0U) << text;
  EXPECT_NE(text.find("InformedRRT'"), std::string::npos) << text;
  EXPECT_NE(text.find("exact"), std::string::npos) << text;
  for (const std::string name : kPlanners) EXPECT_NE(text.find(name), std::string::npos) << text;
}

TEST(OmplOptions, RefusesValuesOutOfRangeAndUnknownKeys) {
  EXPECT_EQ(refusal("planner = exact"), "(no error)");
  EXPECT_EQ(refusal("gap = 0").rfind("campaign.ini:2: [reference] gap: ", 0), 0U);
  EXPECT_EQ(refusal("max_iterations = 0").rfind("campaign.ini:2: [reference] max_iterations: ", 0),
            0U);
  EXPECT_NE(refusal("max_iteration = 9").find("max_iterations"), std::string::npos);
}

TEST(OmplVersion, IsAVersion) {
  EXPECT_EQ(ompl_version().find_first_not_of("0123456789."), std::string::npos);
  EXPECT_GE(std::strtod(ompl_version().c_str(), nullptr), 1.5);
}

}  // namespace
}  // namespace slalom
