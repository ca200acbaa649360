// SPDX-License-Identifier: BSD-3-Clause
#include "planted_methods.h"
#include "temporary_folder.h"

#include <slalom/core/read_file.h>
#include <slalom/falsification/cluster_report.h>
#include <slalom/falsification/failure_files.h>
#include <slalom/io/scenario_list.h>
#include <slalom/io/scenario_yaml.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace slalom {
namespace {

Scenario room(double radius) {
  Primitives obstacles;
  obstacles.discs = {{{3, 3}, radius}};
  return Scenario::continuous("room", {0, 0, 6, 6}, obstacles, {1, 3, 0}, {5, 3});
}

/// A failure with two neighbors, one of them also a neighbor of all others.
Failure made_up(double radius, Outcome outcome) {
  Failure failure{"candidate 7", room(2 * radius), {room(radius), {}}};
  failure.small.trial.outcome = outcome;
  failure.small.parts_before = 4;
  failure.small.parts_after = 1;
  failure.small.minimal = true;
  failure.small.removals = {{"disc", "mine: success"}};
  failure.neighbors = {room(radius / 2), room(0.05)};
  return failure;
}

TEST(Failures, AreNamedByMethodOutcomeAndNumber) {
  std::vector<Failure> failures = {made_up(0.2, Outcome::Collision), made_up(0.3, Outcome::Stuck),
                                   made_up(0.4, Outcome::Collision)};
  name_failures(failures, "mine");
  EXPECT_EQ(failures[0].small.scenario.name(), "mine_collision_1");
  EXPECT_EQ(failures[1].small.scenario.name(), "mine_stuck_1");
  EXPECT_EQ(failures[2].small.scenario.name(), "mine_collision_2");
}

TEST(Failures, AreDescribedWithTheirOriginAndTheProofThatTheyAreMinimal) {
  const std::string text = failure_text(made_up(0.2, Outcome::Collision), planted_setup("squeeze"));
  for (const char* part : {"squeeze ends as collision", "candidate 7", "obstacles 4 -> 1",
                           "minimal", "without disc: mine: success", "no witness"})
    EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(Failures, AreWrittenAsAListAndAsFilesWithDescriptors) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "out");
  std::vector<Failure> failures = {made_up(0.2, Outcome::Collision)};
  name_failures(failures, "squeeze");
  DescribeOptions describe;
  describe.ids = {"density"};
  write_failures(failures, planted_setup("squeeze"), describe, folder / "out", R"({"seed": 5})");
  const std::string hash = failures[0].small.scenario.hash();
  const auto entries = ScenarioList::open(folder / "out/failures.scenarios").entries();
  ASSERT_EQ(entries.size(), 1U);
  EXPECT_EQ(entries[0].hash, hash);
  EXPECT_EQ(load_scenario_yaml(folder / "out/squeeze_collision_1.scenario.yaml").hash(), hash);
  EXPECT_TRUE(std::filesystem::exists(folder / "out/squeeze_collision_1.svg"));
  const auto document = nlohmann::json::parse(read_file(folder / "out/failures.json", "failures"));
  EXPECT_EQ(document["search"]["seed"], 5);
  const auto& failure = document["failures"].at(0);
  EXPECT_EQ(failure["found"], "candidate 7");
  EXPECT_EQ(failure["descriptors"].size(), 1U);
  EXPECT_TRUE(failure["descriptors"].contains("density"));
}

TEST(Failures, AreExaminedInEachScenarioOnce) {
  const std::vector<Failure> failures = {made_up(0.2, Outcome::Collision),
                                         made_up(0.3, Outcome::Collision)};
  const Examination examination = examination_of(failures, planted_setup("squeeze"), "out");
  // Two of each role and the neighbor that both have.
  EXPECT_EQ(examination.roles,
            (std::vector<std::string>{"failure", "original", "neighbor", "neighbor", "failure",
                                      "original", "neighbor"}));
  ASSERT_EQ(examination.scenarios.size(), examination.roles.size());
  ASSERT_EQ(examination.examined.failures.size(), 2U);
  const ExaminedFailure& second = examination.examined.failures[1];
  EXPECT_EQ(second.smallest, room(0.3).hash());
  EXPECT_EQ(second.neighbors, (std::vector<std::string>{room(0.15).hash(), room(0.05).hash()}));
  EXPECT_EQ(second.compared, second.smallest) << "the original is not compared";
}

}  // namespace
}  // namespace slalom
