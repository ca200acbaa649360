#include "error_text.h"

#include <slalom/core/hash.h>
#include <slalom/ompl/ompl_planner.h>
#include <slalom/references/exact_shortest.h>

#include <gtest/gtest.h>

#include <functional>
#include <sys/wait.h>
#include <unistd.h>

namespace slalom {
namespace {

constexpr double kRadius = 0.25;  // m

/// Four discs between the corners of a room of 8 m.
World disc_world() {
  Primitives obstacles;
  obstacles.discs = {{{2.5, 2.2}, 0.6}, {{4.2, 4.4}, 0.8}, {{5.8, 3.4}, 0.5}, {{3.0, 5.8}, 0.5}};
  return {Scenario::continuous("discs", {0, 0, 8, 8}, obstacles, {0.6, 0.6, 0}, {7.4, 7.4}), 0.05};
}

/// A wall from side to side between start and goal.
World parted_world() {
  Primitives wall;
  wall.polygons.push_back({{{0, 3.8}, {8, 3.8}, {8, 4.2}, {0, 4.2}}});
  return {Scenario::continuous("parted", {0, 0, 8, 8}, wall, {1, 1, 0}, {7, 7}), 0.05};
}

PlanningProblem problem_of(const World& world) {
  const auto& start = world.scenario().start();
  return {world, kRadius, {start.x, start.y}, world.scenario().goal()};
}

ShortestPath exact_of(const World& world) {
  std::string reason;
  const auto exact = exact_shortest_path(problem_of(world), 0.01, reason);
  if (!exact) throw std::runtime_error(reason);
  return *exact;
}

/// What `action` returns in a child process: OMPL's seed is set once per process.
std::string in_child(const std::function<std::string()>& action) {
  int ends[2];
  if (pipe(ends) != 0) return "no pipe";
  const pid_t child = fork();
  if (child == 0) {
    const std::string answer = action();
    const auto written = write(ends[1], answer.data(), answer.size());
    _exit(written == static_cast<ssize_t>(answer.size()) ? 0 : 1);
  }
  close(ends[1]);
  std::string answer;
  char part[4096];
  for (ssize_t got; (got = read(ends[0], part, sizeof part)) > 0;)
    answer.append(part, static_cast<std::size_t>(got));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return status == 0 ? answer : "child died";
}

std::string path_hash(const Path& path) {
  Hasher hasher;
  for (const auto& p : path) hasher.add(p.x).add(p.y);
  return std::to_string(path.size()) + " points " + hasher.hex();
}

/// Plans in a child; the answer is the path's hash or what is wrong with it.
std::string checked_plan(const World& world, const ShortestPath& exact, const OmplOptions& options,
                         std::uint64_t seed) {
  return in_child([&]() -> std::string {
    const auto planner = make_ompl_planner(options);
    const auto path = planner->plan(problem_of(world), exact, seed);
    if (!path) return "no path";
    const double metres = length(*path);
    const PlanningProblem problem = problem_of(world);
    if (!is_free(world, *path, kRadius)) return "not free";
    if (path->front() != problem.start) return "does not begin at the start";
    if (path->back() != problem.goal) return "does not end at the goal";
    if (metres < exact.certificate.lower_bound) return "shorter than the lower bound";
    if (metres > 1.5 * exact.certificate.upper_bound) return "no short path";
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
  const ShortestPath exact = exact_of(world);
  world.distance_field();
  for (const std::string name : kPlanners) {
    const std::string answer = checked_plan(world, exact, options_of(name), 5);
    EXPECT_NE(answer.find(" points "), std::string::npos) << name << ": " << answer;
  }
}

TEST(OmplPlanner, TheSameSeedInTwoProcessesGivesTheSamePath) {
  const World world = disc_world();
  const ShortestPath exact = exact_of(world);
  for (const std::string name : {"InformedRRTstar", "BITstar", "RRTstar"}) {
    const std::string first = checked_plan(world, exact, options_of(name), 11);
    EXPECT_NE(first.find(" points "), std::string::npos) << name << ": " << first;
    EXPECT_EQ(checked_plan(world, exact, options_of(name), 11), first) << name;
    EXPECT_NE(checked_plan(world, exact, options_of(name), 12), first) << name;
  }
}

TEST(OmplPlanner, StopsWithinTheGapOfTheLowerBound) {
  const World world = disc_world();
  const ShortestPath exact = exact_of(world);
  OmplOptions options;
  options.gap = 0.05;
  const std::string answer = in_child([&] {
    const auto path = make_ompl_planner(options)->plan(problem_of(world), exact, 3);
    return path ? std::to_string(length(*path)) : "no path";
  });
  const double metres = std::strtod(answer.c_str(), nullptr);
  EXPECT_GE(metres, exact.certificate.lower_bound) << answer;
  EXPECT_LE(metres, 1.05 * exact.certificate.lower_bound + 1e-6);
}

TEST(OmplPlanner, ASeedOfAnySizeIsTaken) {
  const World world = disc_world();
  const ShortestPath exact = exact_of(world);
  for (const std::uint64_t seed : {0ULL, 0xfffffffeULL, ~0ULL}) {
    const std::string first = checked_plan(world, exact, options_of("RRTstar"), seed);
    EXPECT_NE(first.find(" points "), std::string::npos) << seed << ": " << first;
    EXPECT_EQ(checked_plan(world, exact, options_of("RRTstar"), seed), first) << seed;
  }
}

TEST(OmplPlanner, GivesNoPathWhereThereIsNone) {
  const World world = parted_world();
  ShortestPath claimed;
  claimed.certificate = {8, 9};
  EXPECT_EQ(in_child([&]() -> std::string {
              const auto planner = make_ompl_planner(options_of("RRTstar"));
              return planner->plan(problem_of(world), claimed, 1) ? "a path" : "no path";
            }),
            "no path");
}

TEST(OmplPlanner, KeepsItsNameAndLeavesExactToTheExactSearch) {
  EXPECT_EQ(make_ompl_planner(options_of("BITstar"))->name(), "BITstar");
  EXPECT_EQ(make_ompl_planner(options_of("exact")), nullptr);
}

std::string refusal(const std::string& line) {
  const IniFile ini = IniFile::from_text("[reference]\n" + line + "\n", "campaign.ini");
  return error_text(Culprit::Usage, [&] { read_options<OmplOptions>(ini, "reference"); });
}

TEST(OmplOptions, AnUnknownPlannerIsRefusedWithThoseThatThereAre) {
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
