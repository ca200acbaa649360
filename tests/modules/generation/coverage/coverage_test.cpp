// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "mutation/scenario_sketch.h"

#include <slalom/core/error.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/generation/coverage.h>
#include <slalom/references/exact_shortest.h>
#include <slalom/references/footprint_path.h>
#include <slalom/scenario/grid_map.h>

#include <gtest/gtest.h>

#include <set>

namespace slalom {
namespace {

CoveragePlan plan_of(const std::string& keys, const std::string& generator = "") {
  return read_coverage_plan(
      IniFile::from_text("[coverage]\n" + keys + "[generator.random]\n" + generator, "c.ini"),
      {"random"});
}

CoverageResult fill(const CoveragePlan& plan, int jobs = 1, std::uint64_t seed = 3) {
  CoverageSettings settings;
  settings.seed = seed;
  settings.jobs = jobs;
  settings.resolution = 0.1;
  return cover(plan, settings, *make_silent_progress());
}

/// Small workspaces, so that tests are fast.
const std::string kSmall = "min_extent = 5\nmax_extent = 8\n";

Value measured(const Scenario& scenario, const std::string& id) {
  const World world(scenario, 0.1);
  return descriptor(id).compute({world, Footprint::disc(0.25), 8.0, {}});
}

TEST(Coverage, FillsFeasibleBinsWithCertifiedScenarios) {
  const auto result = fill(plan_of(kSmall + "descriptors = density\nbins = 5\nper_bin = 4\n"));
  ASSERT_EQ(result.bins.size(), 5u);
  for (const BinReport& bin : result.bins) {
    EXPECT_EQ(bin.verdict, BinVerdict::Full);
    EXPECT_EQ(bin.found, 4);
  }
  ASSERT_EQ(result.scenarios.size(), 20u);
  for (const CoveredScenario& covered : result.scenarios) {
    const World world(covered.scenario, 0.1);
    const auto& start = covered.scenario.start();
    std::string reason;
    EXPECT_TRUE(
        exact_shortest_path({world, 0.25, {start.x, start.y}, covered.scenario.goal()}, reason))
        << covered.scenario.name() << ": " << reason;
  }
}

TEST(Coverage, FillsBinsInWhichAPolygonHasAPathAndItsEnclosingDiscHasNone) {
  const Footprint rectangle = Footprint::parse("0.42,0.21; -0.42,0.21; -0.42,-0.21; 0.42,-0.21");
  CoverageSettings settings;
  settings.footprint = rectangle;
  settings.robot_radius = rectangle.enclosing_radius();
  const auto result = cover(plan_of(kSmall + "descriptors = bottleneck_width\nper_bin = 3\n"
                                             "edges.bottleneck_width = 0.3, 0.4, 0.6, 0.9\n"),
                            settings, *make_silent_progress());
  ASSERT_EQ(result.bins.size(), 3U);
  EXPECT_EQ(result.bins[0].reason, "the diameter of the disc inscribed in the robot is 0.42 m");
  EXPECT_EQ(result.bins[1].verdict, BinVerdict::Full);
  EXPECT_EQ(result.bins[2].verdict, BinVerdict::Full);
  for (const CoveredScenario& covered : result.scenarios) {
    const Scenario& scenario = covered.scenario;
    const World world(scenario, settings.resolution);
    EXPECT_EQ(descriptor("bottleneck_width").compute({world, rectangle, 8.0, {}}),
              covered.values[0].value);
    std::string reason;
    EXPECT_TRUE(
        find_footprint_path(world, rectangle, scenario.start(), scenario.goal(), 0.01, reason))
        << reason;
    EXPECT_FALSE(exact_shortest_path({world, rectangle.enclosing_radius() + 0.01,
                                      mrpt::math::TPoint2D(scenario.start()), scenario.goal()},
                                     reason));
  }
}

TEST(Coverage, StoredValuesAreReproducibleAndLieInTheBin) {
  const auto result =
      fill(plan_of(kSmall + "descriptors = density, clearness\nbins = 2, 3\n"
                            "range.clearness = 0.02, 0.14\nper_bin = 3\npatience = 200\n"));
  ASSERT_GT(result.scenarios.size(), 9u);
  for (const CoveredScenario& covered : result.scenarios) {
    const BinReport& bin = result.bins[covered.bin];
    ASSERT_EQ(covered.values.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
      const Value value = measured(covered.scenario, covered.values[i].key.id);
      EXPECT_EQ(value, covered.values[i].value);
      EXPECT_GE(value.number(), bin.intervals[i].first);
      EXPECT_LE(value.number(), bin.intervals[i].second);
    }
  }
}

TEST(Coverage, FillsBinsOfDescriptorsOfMoversWithWalkersThatKeepOffObstacles) {
  CoverageSettings settings;
  settings.resolution = 0.1;
  settings.walkers.count = 3;
  const auto plan = plan_of(kSmall +
                            "descriptors = survivability\nrange.survivability = 6, 12\n"
                            "bins = 2\nper_bin = 4\n");
  const auto result = cover(plan, settings, *make_silent_progress());
  ASSERT_EQ(result.scenarios.size(), 8U);
  for (const CoveredScenario& covered : result.scenarios) {
    const World world(covered.scenario, 0.1);
    ASSERT_EQ(covered.scenario.movers().size(), 3U);
    EXPECT_EQ(measured(covered.scenario, "survivability"), covered.values[0].value);
    for (const Mover& mover : covered.scenario.movers()) {
      EXPECT_EQ(mover.id.substr(0, 7), "walker_");
      for (double t = 0; t < mover.waypoints.back().t; t += 0.05)
        ASSERT_GE(world.distance_field().clearance(mover.position(t)), mover.radius - 1e-9);
    }
  }
}

TEST(Coverage, FillsBinsAmongPeopleWithRoomAndWays) {
  CoverageSettings settings;
  settings.resolution = 0.1;
  settings.people.count = 2;
  const auto plan = plan_of(kSmall + "descriptors = density\nbins = 3\nper_bin = 4\n");
  const auto result = cover(plan, settings, *make_silent_progress());
  ASSERT_EQ(result.scenarios.size(), 12U);
  for (const CoveredScenario& covered : result.scenarios) {
    EXPECT_EQ(covered.scenario.people().size(), 2U);
    const World world(covered.scenario, 0.1);
    EXPECT_EQ(problem_of_people(world, settings.robot_radius), "");
    EXPECT_EQ(measured(covered.scenario, "density"), covered.values[0].value);
  }
}

TEST(Coverage, LargeWorkspacesAreMeasuredAtFullResolution) {
  // 90 m at 0.1 m are 810,000 cells, above the 400,000 that are evaluated directly.
  const auto result =
      fill(plan_of("min_extent = 90\nmax_extent = 90\ndescriptors = clearness\n"
                   "edges.clearness = 0, 0.6, 1\nper_bin = 2\n"));
  ASSERT_EQ(result.scenarios.size(), 4u);
  for (const CoveredScenario& covered : result.scenarios) {
    EXPECT_EQ(measured(covered.scenario, "clearness"), covered.values[0].value);
    EXPECT_EQ(covered.values[0].key.parameters, "sensor_range=8;resolution=0.1");
  }
}

TEST(Coverage, TheResultIsTheSameForAnyNumberOfThreads) {
  const auto plan = plan_of(kSmall +
                            "descriptors = density, confinement\nbins = 3, 2\n"
                            "range.confinement = 0.6, 1\nper_bin = 3\npatience = 100\n");
  const auto one = fill(plan, 1), three = fill(plan, 3), other = fill(plan, 1, 4);
  const auto hashes = [](const CoverageResult& result) {
    std::vector<std::string> all;
    for (const CoveredScenario& covered : result.scenarios)
      all.push_back(covered.scenario.name() + covered.scenario.hash());
    return all;
  };
  EXPECT_EQ(hashes(one), hashes(three));
  EXPECT_EQ(render_coverage(plan, one), render_coverage(plan, three));
  EXPECT_NE(hashes(one), hashes(other));
}

TEST(Coverage, AllScenariosAreDistinctAndDiffer) {
  const auto result = fill(plan_of(kSmall + "descriptors = density\nbins = 2\nper_bin = 15\n"
                                            "min_difference = 0.3\n"));
  std::set<std::string> hashes, names;
  std::vector<ScenarioSketch> sketches;
  for (const CoveredScenario& covered : result.scenarios) {
    hashes.insert(covered.scenario.hash());
    names.insert(covered.scenario.name());
    const ScenarioSketch own = sketch(World(covered.scenario, 0.1));
    for (const ScenarioSketch& other : sketches) EXPECT_GE(difference(own, other), 0.3);
    sketches.push_back(own);
  }
  EXPECT_EQ(hashes.size(), 30u);
  EXPECT_EQ(names.size(), 30u);
}

TEST(Coverage, ImpossibleBinsReceiveAProofAndNoEffort) {
  // 2 r D + pi r^2 = 0.5 * 4 + 0.196 = 2.196 m^2 of at most (6 + 0.25)^2 = 39.06 m^2: density is at
  // most 0.944.
  const auto result =
      fill(plan_of("min_extent = 6\nmax_extent = 6\nmin_distance = 4\ndescriptors = density\n"
                   "edges.density = 0, 0.1, 0.95, 1, 1.5\nper_bin = 1\npatience = 50\n"));
  EXPECT_EQ(result.bins[0].verdict, BinVerdict::Full);
  EXPECT_EQ(result.bins[1].verdict, BinVerdict::Full);
  EXPECT_EQ(result.bins[2].verdict, BinVerdict::Impossible);
  EXPECT_EQ(result.bins[2].effort, 0);
  EXPECT_TRUE(mentions(result.bins[2].reason, {"radius 0.25 m", "4 m", "at most 0.9438", "6 m"}));
  EXPECT_EQ(result.bins[3].verdict, BinVerdict::Impossible);
  EXPECT_TRUE(mentions(result.stopped, {"no open bin"}));
}

TEST(Coverage, ReportsTheEffortOfIncompleteBinsWithinTheBudget) {
  // An empty square of 8 m has clearness 8/6/8 = 0.167, and no free space below 68 m^2 above 0.2 (a
  // disc: sqrt(68 / pi) / 24 = 0.194 and 0.012 for cells): 0.19 is neither found nor proved
  // impossible.
  const std::string keys = kSmall + "descriptors = clearness\nedges.clearness = 0.19, 0.2\n";
  const auto spent = fill(plan_of(keys + "budget_evaluations = 60\n"));
  EXPECT_EQ(spent.evaluations, 60);
  EXPECT_EQ(spent.bins[0].effort, 60);
  EXPECT_EQ(spent.bins[0].verdict, BinVerdict::Incomplete);
  EXPECT_TRUE(mentions(spent.stopped, {"budget", "60 evaluations"}));
  const auto patient = fill(plan_of(keys + "patience = 40\n"));
  EXPECT_LE(patient.bins[0].effort, 40 + 24) << "at most one more batch";
  EXPECT_TRUE(mentions(patient.bins[0].reason, {"no new scenario", "evaluations"}));
}

TEST(Coverage, ReportsThatTheWallClockLimitEndedTheSearch) {
  const auto plan =
      plan_of(kSmall + "descriptors = density\nper_bin = 10000\nbudget_time = 0.001\n");
  const auto result = fill(plan);
  EXPECT_FALSE(result.repeatable);
  EXPECT_TRUE(mentions(render_coverage(plan, result), {"wall-clock limit ended the search"}));
}

TEST(CoveragePlan, ReportsInvalidConfigurationsWithFileAndLine) {
  const auto rejects = [](const std::string& keys, const std::string& where,
                          std::initializer_list<std::string> words) {
    return throws_error(ErrorKind::Usage, where, words, [&] { plan_of(keys); });
  };
  EXPECT_TRUE(
      rejects("bins = 3\n", "c.ini: [coverage] descriptors:", {"0 ids", "expected one to three"}));
  EXPECT_TRUE(rejects("descriptors = densty\n", "c.ini:2: [coverage] descriptors:",
                      {"unknown id 'densty'", "expected 'density'"}));
  EXPECT_TRUE(rejects("descriptors = density, density\n",
                      "c.ini:2: [coverage] descriptors:", {"duplicate", "'density'"}));
  EXPECT_TRUE(rejects("descriptors = density\nbins = 2, 3\n",
                      "c.ini:3: [coverage] bins:", {"2 numbers", "expected one", "1 descriptors"}));
  EXPECT_TRUE(rejects("descriptors = density\nbins = 0\n",
                      "c.ini:3: [coverage] bins:", {"'0'", "expected integers from 1 to 10000"}));
  EXPECT_TRUE(rejects(
      "descriptors = density\nedges.density = 0, 0.5, 0.4\n",
      "c.ini:3: [coverage] edges.density:", {"'0.4'", "0.5", "expected ascending numbers"}));
  EXPECT_TRUE(rejects(
      "descriptors = density\nedges.clearness = 0, 1\n", "c.ini:3: [coverage] edges.clearness:",
      {"unknown key",
       "expected one of descriptors, bins, per_bin, min_difference, budget_evaluations, "
       "budget_time, "
       "patience, fresh_fraction, min_extent, max_extent, min_distance, max_obstacles, "
       "edges.density, range.density"}));
  EXPECT_TRUE(rejects("descriptors = detour_ratio\n", "c.ini: [coverage] range.detour_ratio:",
                      {"missing", "edge, or edges.detour_ratio"}));
  EXPECT_TRUE(rejects("descriptors = density, clearness, confinement\nbins = 100\n",
                      "c.ini:3: [coverage] bins:", {"1000000 bins", "expected at most 100000"}));
  EXPECT_TRUE(rejects("descriptors = density\nmin_extent = 20\nmax_extent = 10\n",
                      "c.ini:4: [coverage] max_extent:", {"min_extent", "expected at least 20"}));
  EXPECT_TRUE(rejects("descriptors = density\nmin_distance = 90\n", "c.ini:3:", {"min_distance"}));
}

TEST(Coverage, RejectsInvalidGeneratorOptionsImmediately) {
  const auto plan = plan_of("descriptors = density\n", "min_size = 2\nmax_size = 1\n");
  EXPECT_THROW(fill(plan), Error);
}

TEST(Coverage, KeepsGivenGeneratorOptions) {
  // Every scenario is as generated if there are no mutations: discs only, in the given workspace.
  const auto result = fill(
      plan_of("descriptors = density\nedges.density = 0, 0.2\nper_bin = 4\nfresh_fraction = 1\n",
              "width = 7\nheight = 6\npolygon_fraction = 0\nmin_distance = 3\n"));
  ASSERT_EQ(result.scenarios.size(), 4u);
  for (const CoveredScenario& covered : result.scenarios) {
    EXPECT_EQ(covered.scenario.bounds(), (Bounds{0, 0, 7, 6}));
    EXPECT_TRUE(covered.scenario.primitives().polygons.empty());
  }
}

TEST(Coverage, ReadsEachMapOnce) {
  const auto ini = IniFile::from_text(
      "[coverage]\ndescriptors = density\nedges.density = 0, 0.5\nper_bin = 6\nfresh_fraction = 1\n"
      "[generator.crop]\nmap = hall.map\nwidth = 6\nheight = 6\nmin_distance = 3\n",
      "c.ini");
  int reads = 0;
  CoverageSettings settings;
  settings.load_map = [&](const std::string&) {
    ++reads;
    auto map = make_grid_map(200, 200, 0.1, {0, 0});
    for (int i = 40; i < 160; i += 20) map.setCell(i, i, 0.0f);
    return map;
  };
  const auto result = cover(read_coverage_plan(ini, {"crop"}), settings, *make_silent_progress());
  EXPECT_EQ(result.scenarios.size(), 6u);
  EXPECT_EQ(reads, 1);
}

}  // namespace
}  // namespace slalom
