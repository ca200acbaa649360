// SPDX-License-Identifier: BSD-3-Clause
#include "planted_failure.h"
#include "studio_fixture.h"

namespace slalom {
namespace {

/// A run that collides and one that reaches the goal, of a list with one scenario.
class StudioShrink : public StudioTest {
 protected:
  void SetUp() override {
    StudioTest::SetUp();
    if (IsSkipped()) return;
    make_once([this] {
      write("planted.ini", kPlantedCampaign);
      write("passage.scenario.yaml", kPlantedPassage);
      ASSERT_EQ(run("slalom-scenarios import passage.scenario.yaml -o passage.scenarios").status,
                0);
      ASSERT_EQ(
          run("slalom-evaluate planted.ini --set scenarios.list=passage.scenarios -o out --quiet")
              .status,
          0);
    });
  }
  ProgramResult shrink(const std::string& script) const {
    return play("wait idle\n" + script, "passage.scenarios --results out/runs.results");
  }
};

TEST_F(StudioShrink, AddsTheSmallestScenarioOfAFailedRunUndoably) {
  const ProgramResult result = shrink(
      "click runs \"row squeeze\" right\n"
      "expect run_menu contains Shrink...\n"
      "expect run_menu lacks (\n"
      "click run_menu shrink\n"
      "expect dialog contains \"squeeze ends as collision\"\n"
      "click dialog \"field folder\"\n"
      "key Ctrl+A\n"
      "type small\n"
      "click dialog \"field trust\"\n"
      "click dialog ok\n"
      "wait idle\n"
      "expect dialog contains \"minimal: each obstacle was removed alone\"\n"
      "expect dialog contains \"Report: small/index.html\"\n"
      "click dialog ok\n"
      "expect status contains \"1 scenario added to passage.scenarios\"\n"
      "expect list contains \"squeeze_collision_1\"\n"
      "expect list contains \"tags collision\"\n"
      "key Ctrl+Z\n"
      "expect list lacks \"squeeze_collision_1\"\n"
      "key Ctrl+Y\n");
  ASSERT_EQ(result.status, 0) << result.err << result.out;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "small/index.html"));
  EXPECT_EQ(run("slalom-scenarios show passage.scenarios squeeze_collision_1").status, 0);
}

TEST_F(StudioShrink, SearchesFailuresOfAMethod) {
  const ProgramResult result = shrink(
      "click menu Generate\n"
      "click popup generate.search\n"
      "click dialog \"field campaign\"\n"
      "type planted.ini\n"
      "click dialog \"field method\"\n"
      "type squeeze\n"
      "click dialog \"field folder\"\n"
      "key Ctrl+A\n"
      "type found\n"
      "click dialog \"field runs\"\n"
      "key Ctrl+A\n"
      "type 200\n"
      "click dialog \"field failures\"\n"
      "key Ctrl+A\n"
      "type 1\n"
      "click dialog ok\n"
      "wait idle\n"
      "expect dialog contains \"kept      1 failure\"\n"
      "click dialog ok\n"
      "expect list contains \"squeeze_collision_1\"\n");
  ASSERT_EQ(result.status, 0) << result.err << result.out;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "found/index.html"));
}

TEST_F(StudioShrink, IsRefusedForAReachedGoalAnUntrustedLibraryAndByTheOtherProgram) {
  const ProgramResult result = shrink(
      "click runs \"row base\" right\n"
      "expect run_menu contains \"the robot reached the goal in this run\"\n"
      "key Escape\n"
      "click menu Generate\n"
      "expect popup contains \"Shrink run... (the robot reached the goal in this run)\"\n"
      "key Escape\n"
      "click runs \"row squeeze\" right\n"
      "click run_menu shrink\n"
      "click dialog \"field folder\"\n"
      "key Ctrl+A\n"
      "type small\n"
      "click dialog ok\n"
      "wait idle\n"
      "expect dialog contains \"would execute\"\n"
      "click dialog ok\n"
      "expect list lacks squeeze_collision\n"
      "click runs \"row squeeze\" right\n"
      "click run_menu shrink\n"
      "click dialog \"field folder\"\n"
      "key Ctrl+A\n"
      "type passage.scenarios/small\n"  // below a file
      "click dialog \"field trust\"\n"
      "click dialog ok\n"
      "wait idle\n"
      "expect dialog contains \"passage.scenarios/small\"\n"
      "click dialog ok\n"
      "expect list lacks squeeze_collision\n");
  EXPECT_EQ(result.status, 0) << result.err;
}

}  // namespace
}  // namespace slalom
