// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "io_sample.h"

#include <slalom/campaign/scenario_sources.h>
#include <slalom/generation/maze.h>
#include <slalom/io/scenario_list.h>

#include <gtest/gtest.h>

#include <initializer_list>

namespace slalom {
namespace {

mrpt::maps::COccupancyGridMap2D empty_hall(const std::string&) {
  mrpt::maps::COccupancyGridMap2D map(0, 12, 0, 12, 0.1F);
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 120; ++x) map.setCell(x, y, 1.0F);
  return map;
}

std::vector<Scenario> collect(const std::string& ini) {
  const auto progress = make_silent_progress();
  return collect_scenarios(read_scenario_sources(IniFile::from_text(ini, "c.ini"), {}, empty_hall),
                           empty_hall, *progress);
}

TEST(ScenarioSources, CombinesListMapsAndGeneratorInThisOrder) {
  const TemporaryFolder folder;
  ScenarioList::create(folder / "a.scenarios").add(sample_scenario(1, "listed"));
  const auto scenarios = collect("[scenarios]\nlist = " + (folder / "a.scenarios") +
                                 "\nmaps = /data/hall.gridmap.gz\npairs_per_map = 2\n"
                                 "generator = random\ncount = 3\n");
  ASSERT_EQ(scenarios.size(), 6U);
  EXPECT_EQ(scenarios[0].name(), "listed");
  EXPECT_EQ(scenarios[1].name(), "hall_0000");
  EXPECT_EQ(scenarios[2].name(), "hall_0001");
  EXPECT_EQ(scenarios[3].name(), "random_0000");
}

TEST(ScenarioSources, AreValuesThatAProgramCanFillIn) {
  ScenarioSources sources;
  sources.section.count = 2;
  sources.families.push_back({make_generator(MazeOptions()), 1, 7, "m"});
  const auto progress = make_silent_progress();
  const auto scenarios = collect_scenarios(sources, {}, *progress);
  ASSERT_EQ(scenarios.size(), 2U);
  EXPECT_EQ(scenarios[1].name(), "m_0001");
}

TEST(ScenarioSources, MapsAreNamedAfterTheirFiles) {
  const auto name = [](const std::string& path) {
    return map_scenario(path, empty_hall(path)).name();
  };
  EXPECT_EQ(name("/a/b/willow-0.05.yaml"), "willow-0.05");
  EXPECT_EQ(name("x.simplemap.gz"), "x");
}

TEST(ScenarioSources, MissingAndInvalidSourcesAreRejected) {
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "c.ini", {"[scenarios]", "list, maps or generator"},
                           [] { collect(""); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "c.ini", {"nonsense"},
                           [] { collect("[scenarios]\ngenerator = nonsense\n"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "c.ini:2", {"lits", "list"},
                           [] { collect("[scenarios]\nlits = x\n"); }));
  EXPECT_TRUE(throws_error(ErrorKind::File, "/nonexistent.scenarios", {},
                           [] { collect("[scenarios]\nlist = /nonexistent.scenarios\n"); }));
  EXPECT_TRUE(throws_error(ErrorKind::File, "/nonexistent.yaml: ",
                           {"a scenario list (.scenarios), or maps = /nonexistent.yaml for a map"},
                           [] { collect("[scenarios]\nlist = /nonexistent.yaml\n"); }));
}

TEST(ScenarioSources, SeveralFamiliesShareTheCount) {
  const auto scenarios = collect(
      "[scenarios]\ngenerator = random, traps\nweights = 3, 1\ncount = 8\n"
      "representation = points\nresolution = 0.1\n");
  ASSERT_EQ(scenarios.size(), 8U);
  int traps = 0;
  for (const Scenario& scenario : scenarios) {
    traps += scenario.name().rfind("traps_000", 0) == 0 ? 1 : 0;
    EXPECT_EQ(scenario.representation(), Representation::Points);
  }
  EXPECT_EQ(traps, 2);
}

TEST(ScenarioSources, FamiliesScaleWithTheRobot) {
  const auto progress = make_silent_progress();
  SourceContext context;
  context.robot_radius = 0.5;
  const auto width = [&](const std::string& scaled) {
    const IniFile ini =
        IniFile::from_text("[scenarios]\ngenerator = maze\ncount = 1\nscale_by_robot = " + scaled);
    return collect_scenarios(read_scenario_sources(ini, context, {}), {}, *progress)
        .at(0)
        .bounds()
        .width();
  };
  // 8 cells of a passage and a wall; twice as large for a robot radius of 0.5 m.
  EXPECT_NEAR(width("false"), 8 * (1.2 + 0.15), 1e-9);
  EXPECT_NEAR(width("true"), 16 * (1.2 + 0.15), 1e-9);
  // A polygon passes where half its width does.
  RobotModel robot;
  robot.footprint = "0.6,0.25; -0.6,0.25; -0.6,-0.25; 0.6,-0.25";
  robot.set_radius_of_footprint("robot");
  context = source_context(robot, 0.05);
  EXPECT_NEAR(width("true"), 8 * (1.2 + 0.15), 1e-9);
}

TEST(ScenarioSources, WalkersAreAddedToTheSameScenarios) {
  const std::string family = "[scenarios]\ngenerator = random\ncount = 3\n";
  const auto still = collect(family), moving = collect(family + "walkers = 2\n");
  ASSERT_EQ(moving.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(moving[i].movers().size(), 2U);
    EXPECT_EQ(moving[i].with_movers({}).hash(), still[i].hash());
  }
  EXPECT_NE(moving[0].movers(), moving[1].movers());
}

TEST(ScenarioSources, PeopleAreAddedToTheSameScenarios) {
  const std::string family = "[scenarios]\ngenerator = random\ncount = 3\nwalkers = 1\n";
  const auto still = collect(family), walked = collect(family + "people = 4\n");
  ASSERT_EQ(walked.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(walked[i].people().size(), 4U);
    EXPECT_EQ(walked[i].with_people({}).hash(), still[i].hash());
  }
  EXPECT_NE(walked[0].people(), walked[1].people());
}

TEST(ScenarioSources, InvalidWalkersAreRejectedWithTheirLine) {
  const std::string family = "[scenarios]\ngenerator = random\ncount = 1\n";
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "c.ini:4", {"walkers", "1000"},
                           [&] { collect(family + "walkers = -1\n"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "c.ini:4", {"walker_max_radius", "at most 0.4 m"},
                           [&] { collect(family + "walker_min_radius = 0.5\n"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "c.ini:4", {"walker_max_speed", "at most 1 m/s"},
                           [&] { collect(family + "walker_min_speed = 2\n"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "c.ini:3", {"walkers", "generated scenarios"},
                           [] { collect("[scenarios]\nlist = x.scenarios\nwalkers = 1\n"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "c.ini:4", {"person_max_speed", "at most 1.5 m/s"},
                           [&] { collect(family + "person_min_speed = 2\n"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "c.ini:3", {"people", "generated scenarios"},
                           [] { collect("[scenarios]\nlist = x.scenarios\npeople = 1\n"); }));
}

TEST(ScenarioSources, FamiliesOnMapsUseTheLoader) {
  const auto scenarios = collect(
      "[scenarios]\ngenerator = clutter\ncount = 2\n[generator.clutter]\nmap = x.yaml\n"
      "min_occupied = 0\nwidth = 8\n");
  ASSERT_EQ(scenarios.size(), 2U);
  EXPECT_NEAR(scenarios[0].bounds().width(), 8, 1e-5);
}

TEST(ScenarioSources, InvalidMixesAreRejectedWithTheirLine) {
  const auto refused = [](const std::string& ini, const std::string& where,
                          std::initializer_list<std::string> words) {
    return throws_error(ErrorKind::Usage, where, words, [&] { collect("[scenarios]\n" + ini); });
  };
  EXPECT_TRUE(refused("generator = random, maze\nweights = 1\n", "c.ini:3: [scenarios] weights: ",
                      {"'1'", "positive number for each generator"}));
  EXPECT_TRUE(
      refused("generator = random\nweights = 0\n", "c.ini:3: [scenarios] weights: ", {"'0'"}));
  EXPECT_TRUE(refused("generator = maze, maze\n", "c.ini:2: [scenarios] generator: ",
                      {"duplicate", "maze", "expected each family once"}));
  EXPECT_TRUE(refused("generator = maze\n[generator.mase]\n",
                      "c.ini:3: [generator.mase]: ", {"'mase'", "expected 'maze'"}));
  EXPECT_TRUE(refused("generator = maze\nrepresentation = mesh\n",
                      "c.ini:3: [scenarios] representation: ", {"mesh"}));
}

}  // namespace
}  // namespace slalom
