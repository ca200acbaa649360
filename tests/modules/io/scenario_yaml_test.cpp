#include "io_sample.h"

#include <slalom/core/error.h>
#include <slalom/io/scenario_yaml.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

std::string message_for(const std::string& yaml) {
  try {
    scenario_from_yaml(yaml, "f.yaml");
  } catch (const Error& e) {
    EXPECT_EQ(e.exit_status(), 3);
    return e.what();
  }
  return "no error";
}

constexpr char kHead[] =
    "name: x\nrepresentation: grid\nbounds: [0, 0, 3, 2]\nstart: [0.5, 0.5, 0]\ngoal: [2.5, 1.5]\n";

TEST(ScenarioYaml, EveryRepresentationComesBackWithItsHash) {
  for (const Representation representation :
       {Representation::Continuous, Representation::Grid, Representation::Points}) {
    const Scenario scenario = sample_as(representation).renamed("a \"name\": with # signs");
    const Scenario back = scenario_from_yaml(scenario_to_yaml(scenario), "test");
    EXPECT_EQ(back.hash(), scenario.hash()) << to_string(representation);
    EXPECT_EQ(back.name(), scenario.name());
  }
}

TEST(ScenarioYaml, APublishedPathComesBack) {
  const Scenario scenario = sample_with_path(Representation::Continuous);
  const Scenario back = scenario_from_yaml(scenario_to_yaml(scenario), "test");
  ASSERT_NE(back.published_path(), nullptr);
  EXPECT_EQ(*back.published_path(), *scenario.published_path());
}

TEST(ScenarioYaml, MistakesInAPublishedPathAreNamedWithTheirLine) {
  const std::string cells = std::string(kHead) + "resolution: 1\ncells: [\"...\", \"...\"]\n";
  EXPECT_EQ(message_for(cells + "published_path: 3\n"),
            "f.yaml:8: is no path; expected keys and values");
  EXPECT_EQ(message_for(cells + "published_path:\n  feild: [0, 0, 1, 1]\n"),
            "f.yaml:9: unknown key 'feild'; expected 'field'");
  EXPECT_EQ(
      message_for(cells + "published_path:\n  field: [0, 0, 1, 1]\n  cell_size: 1\n  points:\n"
                          "    - [0, 1]\n    - [0]\n"),
      "f.yaml:13: has not the right form; expected [2 numbers]");
}

TEST(ScenarioYaml, GridsAreDrawnTopRowFirst) {
  const Scenario scenario = scenario_from_yaml(
      std::string(kHead) + "resolution: 1\ncells:\n  - \"#..\"\n  - \"..#\"\n", "f.yaml");
  const Occupancy cells = make_occupancy(scenario, 1);
  EXPECT_TRUE(cells.occupied(0, 1));
  EXPECT_TRUE(cells.occupied(2, 0));
  EXPECT_EQ(cells.count_occupied(), 2U);
}

TEST(ScenarioYaml, MistakesAreNamedWithTheirLine) {
  EXPECT_EQ(message_for(std::string(kHead) + "resolutoin: 1\ncells: []\n"),
            "f.yaml:6: unknown key 'resolutoin'; expected 'resolution'");
  EXPECT_EQ(message_for(std::string(kHead) + "resolution: 1\ncells:\n  - \"...\"\n  - \"..\"\n"),
            "f.yaml:9: is no row of the grid; expected 3 of '.' and '#'");
  EXPECT_EQ(message_for("name: x\nrepresentation: cubes\n"),
            "f.yaml:2: 'cubes' is unknown; expected continuous, grid or points");
  EXPECT_NE(message_for("name: [\n").find("is not YAML"), std::string::npos);
  EXPECT_NE(message_for("hello").find("is no scenario"), std::string::npos);
  EXPECT_NE(message_for("").find("is no scenario"), std::string::npos);
}

TEST(ScenarioYaml, TruncatedFilesAreRefusedNotHalfRead) {
  const std::string yaml = scenario_to_yaml(sample_as(Representation::Grid));
  for (std::size_t size = 0; size + 3 < yaml.size(); size += 37)
    EXPECT_NE(message_for(yaml.substr(0, size)), "no error") << size;
}

}  // namespace
}  // namespace slalom
