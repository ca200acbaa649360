#include "io_sample.h"

#include <slalom/commands/scenario_sources.h>
#include <slalom/core/error.h>
#include <slalom/io/scenario_list.h>

#include <gtest/gtest.h>

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
  return collect_scenarios(IniFile::from_text(ini, "c.ini"), {}, empty_hall, *progress);
}

TEST(ScenarioSources, ListMapsAndGeneratorAreJoinedInThatOrder) {
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

TEST(ScenarioSources, MapsAreNamedAfterTheirFiles) {
  const auto name = [](const std::string& path) {
    return map_scenario(path, empty_hall(path)).name();
  };
  EXPECT_EQ(name("/a/b/willow-0.05.yaml"), "willow-0.05");
  EXPECT_EQ(name("x.simplemap.gz"), "x");
}

TEST(ScenarioSources, NoSourceOrAWrongOneIsRefused) {
  const auto status = [](const std::string& ini) {
    try {
      collect(ini);
    } catch (const Error& e) {
      return e.exit_status();
    }
    return 0;
  };
  EXPECT_EQ(status(""), 2);
  EXPECT_EQ(status("[scenarios]\ngenerator = nonsense\n"), 2);
  EXPECT_EQ(status("[scenarios]\nlits = x\n"), 2);
  EXPECT_EQ(status("[scenarios]\nlist = /nonexistent.scenarios\n"), 3);
}

}  // namespace
}  // namespace slalom
