#include "scenario_sketch.h"

#include <slalom/core/error.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/generation/coverage.h>
#include <slalom/references/exact_shortest.h>
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
  CoverageTask task;
  task.seed = seed;
  task.jobs = jobs;
  task.resolution = 0.1;
  return cover(plan, task, *make_silent_progress());
}

/// Small floors, so that tests are quick.
const std::string kSmall = "min_floor = 5\nmax_floor = 8\n";

Value measured(const Scenario& scenario, const std::string& id) {
  const World world(scenario, 0.1);
  return descriptor(id).compute({world, Footprint::disc(0.25), 8.0, {}});
}

TEST(Coverage, FillsEveryBinThatItCanWithCertifiedScenarios) {
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
        exact_shortest_path({world, 0.25, {start.x, start.y}, covered.scenario.goal()}, 1, reason))
        << covered.scenario.name() << ": " << reason;
  }
}

TEST(Coverage, ValuesMeasuredAnewAreThoseKeptAndLieInTheBin) {
  const auto result =
      fill(plan_of(kSmall + "descriptors = density, clearness\nbins = 2, 3\n"
                            "range.clearness = 0.02, 0.14\nper_bin = 3\npatience = 200\n"));
  ASSERT_GT(result.scenarios.size(), 9u);
  for (const CoveredScenario& covered : result.scenarios) {
    const BinReport& bin = result.bins[covered.bin];
    ASSERT_EQ(covered.values.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
      const Value value = measured(covered.scenario, covered.values[i].id);
      EXPECT_EQ(value, covered.values[i].value);
      EXPECT_GE(value.number(), bin.intervals[i].first);
      EXPECT_LE(value.number(), bin.intervals[i].second);
    }
  }
}

TEST(Coverage, LargeFloorsAreMeasuredOnTheirTrueCells) {
  // 90 m at 0.1 m are 810,000 cells, above the 400,000 that are looked at directly.
  const auto result =
      fill(plan_of("min_floor = 90\nmax_floor = 90\ndescriptors = clearness\n"
                   "edges.clearness = 0, 0.6, 1\nper_bin = 2\n"));
  ASSERT_EQ(result.scenarios.size(), 4u);
  for (const CoveredScenario& covered : result.scenarios) {
    EXPECT_EQ(measured(covered.scenario, "clearness"), covered.values[0].value);
    EXPECT_EQ(covered.values[0].parameters, "sensor_range=8;resolution=0.1");
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

TEST(Coverage, ImpossibleBinsGetNoEffortAndAProof) {
  // 2 r D + pi r^2 = 0.5 * 4 + 0.196 = 2.196 m^2 of at most (6 + 0.25)^2 = 39.06 m^2: density is at
  // most 0.944.
  const auto result =
      fill(plan_of("min_floor = 6\nmax_floor = 6\nmin_distance = 4\ndescriptors = density\n"
                   "edges.density = 0, 0.1, 0.95, 1, 1.5\nper_bin = 1\npatience = 50\n"));
  EXPECT_EQ(result.bins[0].verdict, BinVerdict::Full);
  EXPECT_EQ(result.bins[1].verdict, BinVerdict::Full);
  EXPECT_EQ(result.bins[2].verdict, BinVerdict::Impossible);
  EXPECT_EQ(result.bins[2].effort, 0);
  EXPECT_EQ(result.bins[2].why,
            "a robot of radius 0.25 m that goes 4 m leaves at most 0.9438 of a floor of 6 m to "
            "obstacles");
  EXPECT_EQ(result.bins[3].verdict, BinVerdict::Impossible);
  EXPECT_EQ(result.stopped, "nothing is left to be filled");
}

TEST(Coverage, StarvedBinsAreToldWithTheirEffortWithinTheBudget) {
  // An empty square of 8 m has clearness 8/6/8 = 0.167, and no free space below 68 m^2 above 0.2
  // (a disc: sqrt(68 / pi) / 24 = 0.194 and 0.012 for cells): 0.19 is neither found nor disproved.
  const std::string keys = kSmall + "descriptors = clearness\nedges.clearness = 0.19, 0.2\n";
  const auto spent = fill(plan_of(keys + "budget_evaluations = 60\n"));
  EXPECT_EQ(spent.evaluations, 60);
  EXPECT_EQ(spent.bins[0].effort, 60);
  EXPECT_EQ(spent.bins[0].verdict, BinVerdict::Starved);
  EXPECT_EQ(spent.stopped, "the budget of 60 evaluations is used up");
  const auto patient = fill(plan_of(keys + "patience = 40\n"));
  EXPECT_LE(patient.bins[0].effort, 40 + 24) << "a batch more at most";
  EXPECT_EQ(patient.bins[0].why.rfind("nothing new in ", 0), 0u) << patient.bins[0].why;
}

TEST(Coverage, TheClockMayEndItAndThenSaysSo) {
  const auto plan =
      plan_of(kSmall + "descriptors = density\nper_bin = 10000\nbudget_time = 0.001\n");
  const auto result = fill(plan);
  EXPECT_FALSE(result.repeatable);
  EXPECT_NE(render_coverage(plan, result).find("The clock ended the search"), std::string::npos);
}

TEST(CoveragePlan, WrongConfigurationsAreToldWithTheirPlace) {
  const auto message = [](const std::string& keys) -> std::string {
    try {
      plan_of(keys);
    } catch (const Error& e) {
      EXPECT_EQ(e.exit_status(), 2);
      return e.what();
    }
    return "no error";
  };
  EXPECT_EQ(message("bins = 3\n"),
            "c.ini: [coverage] descriptors: names 0; expected one to three ids of descriptors");
  EXPECT_EQ(message("descriptors = densty\n"),
            "c.ini:2: [coverage] descriptors: unknown id 'densty'; expected 'density'");
  EXPECT_EQ(message("descriptors = density, density\n"),
            "c.ini:2: [coverage] descriptors: names 'density' twice; expected each once");
  EXPECT_EQ(message("descriptors = density\nbins = 2, 3\n"),
            "c.ini:3: [coverage] bins: gives 2 numbers; expected one, or one for each of 1 "
            "descriptors");
  EXPECT_EQ(message("descriptors = density\nbins = 0\n"),
            "c.ini:3: [coverage] bins: '0' is not valid; expected whole numbers from 1 to 10000");
  EXPECT_EQ(message("descriptors = density\nedges.density = 0, 0.5, 0.4\n"),
            "c.ini:3: [coverage] edges.density: '0.4' does not follow 0.5; expected ascending "
            "numbers");
  EXPECT_EQ(message("descriptors = density\nedges.clearness = 0, 1\n"),
            "c.ini:3: [coverage] edges.clearness: unknown key; expected one of descriptors, bins, "
            "per_bin, min_difference, budget_evaluations, budget_time, patience, fresh_share, "
            "min_floor, max_floor, min_distance, max_obstacles, edges.density, range.density");
  EXPECT_EQ(message("descriptors = detour_ratio\n"),
            "c.ini: [coverage] range.detour_ratio: is missing; expected the lowest and highest "
            "edge, or edges.detour_ratio");
  EXPECT_EQ(message("descriptors = density, clearness, confinement\nbins = 100\n"),
            "c.ini:3: [coverage] bins: make 1000000 bins; expected at most 100000");
  EXPECT_EQ(message("descriptors = density\nmin_floor = 20\nmax_floor = 10\n"),
            "c.ini:4: [coverage] max_floor: is less than min_floor; expected at least 20");
  EXPECT_EQ(message("descriptors = density\nmin_distance = 90\n").rfind("c.ini:3:", 0), 0u);
}

TEST(Coverage, WrongOptionsOfFamiliesAreToldAtOnce) {
  const auto plan = plan_of("descriptors = density\n", "min_size = 2\nmax_size = 1\n");
  EXPECT_THROW(fill(plan), Error);
}

TEST(Coverage, OptionsOfFamiliesThatAreGivenAreKept) {
  // Without mutations every scenario is as its family draws it: discs only, on the floor given.
  const auto result =
      fill(plan_of("descriptors = density\nedges.density = 0, 0.2\nper_bin = 4\nfresh_share = 1\n",
                   "width = 7\nheight = 6\npolygon_share = 0\nmin_distance = 3\n"));
  ASSERT_EQ(result.scenarios.size(), 4u);
  for (const CoveredScenario& covered : result.scenarios) {
    EXPECT_EQ(covered.scenario.bounds(), (Bounds{0, 0, 7, 6}));
    EXPECT_TRUE(covered.scenario.primitives().polygons.empty());
  }
}

TEST(Coverage, MapsOfFamiliesAreReadOnce) {
  const auto ini = IniFile::from_text(
      "[coverage]\ndescriptors = density\nedges.density = 0, 0.5\nper_bin = 6\nfresh_share = 1\n"
      "[generator.crop]\nmap = hall.map\nwidth = 6\nheight = 6\nmin_distance = 3\n",
      "c.ini");
  int reads = 0;
  CoverageTask task;
  task.load_map = [&](const std::string&) {
    ++reads;
    auto map = make_grid_map(200, 200, 0.1, {0, 0});
    for (int i = 40; i < 160; i += 20) map.setCell(i, i, 0.0f);
    return map;
  };
  const auto result = cover(read_coverage_plan(ini, {"crop"}), task, *make_silent_progress());
  EXPECT_EQ(result.scenarios.size(), 6u);
  EXPECT_EQ(reads, 1);
}

}  // namespace
}  // namespace slalom
