// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/campaign/scenario_sources.h>
#include <slalom/evaluate.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

std::vector<std::string> hashes_of(const std::vector<Scenario>& scenarios) {
  std::vector<std::string> hashes;
  for (const Scenario& scenario : scenarios) hashes.push_back(scenario.hash());
  return hashes;
}

TEST(Generate, GivesTheScenariosOfAProgramWithTheSameOptions) {
  MazeOptions maze;
  maze.columns = 5;
  maze.start_goal.min_distance = 4;
  const std::vector<Scenario> scenarios = generate(maze, 6, 3);
  const IniFile ini = IniFile::from_text(
      "[scenarios]\ngenerator = maze\ncount = 6\n"
      "[generator.maze]\ncolumns = 5\nmin_distance = 4\n");
  const auto progress = make_silent_progress();
  const std::vector<Scenario> expected =
      collect_scenarios(read_scenario_sources(ini, {0.25, {}, 0.05, 3, 1}, {}), {}, *progress);
  ASSERT_EQ(scenarios.size(), 6U);
  EXPECT_EQ(hashes_of(scenarios), hashes_of(expected));
  EXPECT_EQ(scenarios[0].name(), expected[0].name());
}

TEST(Generate, IsTheSameWithAnyNumberOfWorkers) {
  RandomGeneratorOptions family;
  family.obstacles.max_obstacles = 10;
  Options options;
  options.workers = 3;
  EXPECT_EQ(hashes_of(generate(family, 5, 1, options)), hashes_of(generate(family, 5, 1)));
  options.workers = 0;
  EXPECT_EQ(hashes_of(generate(family, 5, 1, options)), hashes_of(generate(family, 5, 1)));
  EXPECT_NE(hashes_of(generate(family, 5, 2)), hashes_of(generate(family, 5, 1)));
}

TEST(Generate, RejectsInvalidOptionsOfTheFamily) {
  RandomGeneratorOptions family;
  family.width = -1;
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "generator.random.width: ",
                           {"'-1'", "expected a number > 0"}, [&] { generate(family, 5, 1); }));
  family.width = 12;
  family.obstacles.min_obstacles = 50;
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "generator.random.max_obstacles: ",
                           {"less than min_obstacles"}, [&] { generate(family, 5, 1); }));
}

}  // namespace
}  // namespace slalom
