// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "io_sample.h"

#include <slalom/io/scenario_list.h>
#include <slalom/io/scenario_yaml.h>

#include <gtest/gtest.h>

#include <initializer_list>

namespace slalom {
namespace {

testing::AssertionResult refused(const std::string& yaml, const std::string& where,
                                 std::initializer_list<std::string> words) {
  return throws_error(ErrorKind::File, where, words, [&] { scenario_from_yaml(yaml, "f.yaml"); });
}

constexpr char kHead[] =
    "name: x\nrepresentation: grid\nbounds: [0, 0, 3, 2]\nstart: [0.5, 0.5, 0]\ngoal: [2.5, 1.5]\n";

TEST(ScenarioYaml, RestoresEveryRepresentationWithItsHash) {
  for (const Representation representation :
       {Representation::Continuous, Representation::Grid, Representation::Points}) {
    const Scenario scenario = sample_as(representation).renamed("a \"name\": with # signs");
    const Scenario back = scenario_from_yaml(scenario_to_yaml(scenario), "test");
    EXPECT_EQ(back.hash(), scenario.hash()) << to_string(representation);
    EXPECT_EQ(back.name(), scenario.name());
  }
}

TEST(ScenarioYaml, RestoresTheHeadingOfAGoal) {
  for (const Scenario& base :
       {sample_as(Representation::Grid), sample_with_path(Representation::Continuous)}) {
    const Scenario scenario = base.with_goal_heading(-2.0 / 3);
    const Scenario back = scenario_from_yaml(scenario_to_yaml(scenario), "test");
    EXPECT_EQ(back.goal_heading(), scenario.goal_heading());
    EXPECT_EQ(back.hash(), scenario.hash());
    const Scenario unpacked = deserialize_scenario(serialize(scenario), "test");
    EXPECT_EQ(unpacked.goal_heading(), scenario.goal_heading());
    EXPECT_EQ(unpacked.hash(), scenario.hash());
    EXPECT_EQ(unpacked.published_path() != nullptr, base.published_path() != nullptr);
  }
  EXPECT_TRUE(
      refused("name: x\nrepresentation: points\nbounds: [0, 0, 3, 2]\n"
              "start: [0.5, 0.5, 0]\ngoal: [2.5, 1.5, 0, 0]\npoints: []\n",
              "f.yaml:5: ", {"expected [2 numbers]"}));
}

TEST(ScenarioYaml, RestoresAPublishedPath) {
  const Scenario scenario = sample_with_path(Representation::Continuous);
  const Scenario back = scenario_from_yaml(scenario_to_yaml(scenario), "test");
  ASSERT_NE(back.published_path(), nullptr);
  EXPECT_EQ(*back.published_path(), *scenario.published_path());
}

TEST(ScenarioYaml, ReportsErrorsInAPublishedPathWithTheirLine) {
  const std::string cells = std::string(kHead) + "resolution: 1\ncells: [\"...\", \"...\"]\n";
  EXPECT_TRUE(refused(cells + "published_path: 3\n", "f.yaml:8: ", {"expected keys and values"}));
  EXPECT_TRUE(refused(cells + "published_path:\n  feild: [0, 0, 1, 1]\n",
                      "f.yaml:9: ", {"'feild'", "expected 'field'"}));
  EXPECT_TRUE(refused(cells + "published_path:\n  field: [0, 0, 1, 1]\n  cell_size: 1\n  points:\n"
                              "    - [0, 1]\n    - [0]\n",
                      "f.yaml:13: ", {"expected [2 numbers]"}));
}

TEST(ScenarioYaml, RestoresMovers) {
  for (const Representation representation :
       {Representation::Continuous, Representation::Grid, Representation::Points}) {
    const Scenario scenario = sample_as(representation).with_movers(sample_movers());
    const Scenario back = scenario_from_yaml(scenario_to_yaml(scenario), "test");
    EXPECT_EQ(back.movers(), scenario.movers());
    EXPECT_EQ(back.hash(), scenario.hash());
  }
  EXPECT_EQ(scenario_to_yaml(sample_scenario(1)).find("movers"), std::string::npos);
}

TEST(ScenarioYaml, ReportsErrorsInMoversWithTheirLine) {
  const std::string cells = std::string(kHead) + "resolution: 1\ncells: [\"...\", \"...\"]\n";
  EXPECT_TRUE(refused(cells + "movers: 3\n", "f.yaml:8: ", {"'movers' is not a list"}));
  EXPECT_TRUE(refused(cells + "movers:\n  - 3\n", "f.yaml:9: ", {"expected keys and values"}));
  const std::string mover = cells + "movers:\n  - id: p\n    radius: 0.3\n";
  EXPECT_TRUE(refused(mover + "    aftr: stop\n", "f.yaml:11: ", {"'aftr'", "expected 'after'"}));
  EXPECT_TRUE(refused(mover + "    after: jump\n    waypoints: []\n",
                      "f.yaml:11: ", {"'jump'", "expected stop, loop or vanish"}));
  EXPECT_TRUE(refused(mover + "    after: stop\n    waypoints:\n      - [0, 1]\n",
                      "f.yaml:13: ", {"expected [3 numbers]"}));
  EXPECT_TRUE(refused(mover + "    after: stop\n    waypoints: [[1, 0, 0], [1, 2, 0]]\n",
                      "f.yaml:9: moving obstacle 'p'", {"waypoint 1", "increasing times"}));
}

TEST(ScenarioYaml, RestoresPeople) {
  for (const Representation representation :
       {Representation::Continuous, Representation::Grid, Representation::Points}) {
    const Scenario scenario =
        sample_as(representation).with_movers(sample_movers()).with_people(sample_people());
    const Scenario back = scenario_from_yaml(scenario_to_yaml(scenario), "test");
    EXPECT_EQ(back.people(), scenario.people());
    EXPECT_EQ(back.hash(), scenario.hash());
  }
  EXPECT_EQ(scenario_to_yaml(sample_scenario(1)).find("people"), std::string::npos);
}

TEST(ScenarioYaml, PeopleAreThereFromTheBeginningAndStayUnlessTheFileSaysOtherwise) {
  const Scenario scenario = scenario_from_yaml(
      std::string(kHead) +
          "resolution: 1\ncells: [\"...\", \"...\"]\npeople:\n"
          "  - {id: anna, radius: 0.25, speed: 1.3, start: [1, 1], route: [[2, 1], [2, 1.5]]}\n",
      "f.yaml");
  const People expected = {{"anna", 0.25, 1.3, {1, 1}, {{2, 1}, {2, 1.5}}, 0, PersonEnd::Stay}};
  EXPECT_EQ(scenario.people(), expected);
}

TEST(ScenarioYaml, ReportsErrorsInPeopleWithTheirLine) {
  const std::string cells = std::string(kHead) + "resolution: 1\ncells: [\"...\", \"...\"]\n";
  EXPECT_TRUE(refused(cells + "people: 3\n", "f.yaml:8: ", {"'people' is not a list"}));
  EXPECT_TRUE(refused(cells + "people:\n  - 3\n", "f.yaml:9: ", {"expected keys and values"}));
  const std::string anna = cells + "people:\n  - id: anna\n    radius: 0.25\n";
  EXPECT_TRUE(refused(anna, "f.yaml:9: ", {"missing key 'speed'"}));
  EXPECT_TRUE(refused(anna + "    sped: 1\n", "f.yaml:11: ", {"'sped'", "expected 'speed'"}));
  const std::string start = anna + "    speed: 1.3\n    start: [1, 1]\n";
  EXPECT_TRUE(refused(start + "    route: [[1]]\n", "f.yaml:13: ", {"expected [2 numbers]"}));
  EXPECT_TRUE(refused(start + "    route: []\n", "f.yaml:9: person 'anna'", {"no route"}));
  EXPECT_TRUE(refused(start + "    route: [[2, 1]]\n    after: jump\n",
                      "f.yaml:14: ", {"'jump'", "expected stay, vanish or return"}));
  EXPECT_TRUE(refused(start + "    route: [[2, 1]]\n    begin: soon\n", "f.yaml:14: ", {"number"}));
  EXPECT_TRUE(refused(start + "    route: [[2, 1], [9, 1]]\n", "x: person 'anna'",
                      {"point 1 of the route at (9, 1)"}));
  EXPECT_TRUE(
      refused(start + "    route: [[2, 1]]\n" +
                  "  - {id: ben, radius: 0.3, speed: 1, start: [1.5, 1], route: [[2, 1]]}\n",
              "x: person 'ben'", {"starts within person 'anna'"}));
}

TEST(ScenarioYaml, GridRowsAreInTopDownOrder) {
  const Scenario scenario = scenario_from_yaml(
      std::string(kHead) + "resolution: 1\ncells:\n  - \"#..\"\n  - \"..#\"\n", "f.yaml");
  const Occupancy cells = make_occupancy(scenario, 1);
  EXPECT_TRUE(cells.occupied(0, 1));
  EXPECT_TRUE(cells.occupied(2, 0));
  EXPECT_EQ(cells.count_occupied(), 2U);
}

TEST(ScenarioYaml, ReportsErrorsWithTheirLine) {
  EXPECT_TRUE(refused(std::string(kHead) + "resolutoin: 1\ncells: []\n",
                      "f.yaml:6: ", {"'resolutoin'", "expected 'resolution'"}));
  EXPECT_TRUE(refused(std::string(kHead) + "resolution: 1\ncells:\n  - \"...\"\n  - \"..\"\n",
                      "f.yaml:9: ", {"expected 3 of '.' and '#'"}));
  EXPECT_TRUE(refused("name: x\nrepresentation: cubes\n",
                      "f.yaml:2: ", {"'cubes'", "expected continuous, grid or points"}));
  EXPECT_TRUE(refused("name: [\n", "f.yaml", {"YAML"}));
  EXPECT_TRUE(refused("hello", "f.yaml", {"scenario"}));
  EXPECT_TRUE(refused("# caf\xc3\xa9\nname: caf\xe9\n", "f.yaml:2: ", {"not UTF-8"}));
  EXPECT_TRUE(refused("", "f.yaml", {"scenario"}));
}

TEST(ScenarioYaml, RejectsTruncatedFiles) {
  const std::string yaml = scenario_to_yaml(sample_as(Representation::Grid));
  for (std::size_t size = 0; size + 3 < yaml.size(); size += 37)
    EXPECT_TRUE(refused(yaml.substr(0, size), "f.yaml", {})) << size;
}

}  // namespace
}  // namespace slalom
