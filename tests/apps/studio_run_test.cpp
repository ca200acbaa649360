// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"
#include "planted_failure.h"
#include "studio_fixture.h"

namespace slalom {
namespace {

/// A room with one obstacle, and a campaign of two MRPT methods.
constexpr char kRoom[] = R"(name: "room"
representation: continuous
bounds: [0, 0, 6, 6]
start: [1, 1, 0]
goal: [5, 5]
discs:
  - [3, 1.5, 0.4]
polygons: []
)";
constexpr char kRoomCampaign[] = R"([campaign]
name        = rooms
seed        = 5
repetitions = 2
methods     = nd, vff
[scenarios]
list = room.scenarios
[method.nd]
adapter = mrpt_holonomic
class   = CHolonomicND
[method.vff]
adapter = mrpt_holonomic
class   = CHolonomicVFF
[record]
rawlog = all
)";

/// "mine" does what `fault` names after one second.
std::string faulty_campaign(const std::string& fault,
                            const std::string& plugin = kBuild +
                                                        "/tests/faults/libfaulty_method.so") {
  return "[campaign]\nname = faulty\nmethods = mine\n[scenarios]\nlist = none.scenarios\n"
         "[method.mine]\nadapter = library\nplugin = " +
         plugin + "\nfault = " + fault + "\n";
}

class StudioRun : public StudioTest {
 protected:
  void SetUp() override {
    StudioTest::SetUp();
    if (IsSkipped()) return;
    make_once([this] {
      write("room.scenario.yaml", kRoom);
      ASSERT_EQ(run("slalom-scenarios import room.scenario.yaml -o room.scenarios").status, 0);
    });
    std::filesystem::create_directory(folder_ / "tmp");
  }
  void TearDown() override {
    if (!IsSkipped()) {
      EXPECT_EQ(processes_of_folder(), "");
      EXPECT_TRUE(std::filesystem::is_empty(folder_ / "tmp"));
    }
    StudioTest::TearDown();
  }
  std::string expect_played_here(const std::string& script, const std::string& arguments) const {
    write("script.txt", "wait idle\n" + script);
    const ProgramResult result =
        run("TMPDIR='" + (folder_ / "tmp").string() + "' " + environment() +
            "slalom-studio room.scenarios " + arguments + " --script script.txt");
    EXPECT_EQ(result.status, 0) << result.err << result.out;
    return result.out;
  }
  void make_results() const {
    write("rooms.ini", kRoomCampaign);
    ASSERT_EQ(run("slalom-evaluate rooms.ini -o out --quiet").status, 0);
  }
  /// The command lines of running processes that name the test's folder.
  std::string processes_of_folder() const {
    std::string found;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
      const std::string command = read_text(entry.path() / "cmdline");
      if (command.find(folder_.string()) != std::string::npos) found += command + "\n";
    }
    return found;
  }
};

TEST_F(StudioRun, OpensTheDemoWithItsRuns) {
  const std::string cache = "XDG_CACHE_HOME='" + (folder_ / "cache").string() + "' ";
  const std::string script =
      "do help.demo\nwait idle\n"
      "expect list contains \"70 scenarios\"\n"
      "expect results contains \"Results: runs.results\"\n"
      "expect runs contains \"nd: shown, success\"\n";
  write("script.txt", script);
  for (const char* of : {"made", "kept"}) {
    const ProgramResult result = run("TMPDIR='" + (folder_ / "tmp").string() + "' " + cache +
                                     environment() + "slalom-studio --script script.txt");
    EXPECT_EQ(result.status, 0) << of << result.err << result.out;
  }
}

TEST_F(StudioRun, ShowsTheRunsOnAnEditedScenarioAndLeavesTheOpenResults) {
  make_results();
  const std::string before = read("out/runs.results");
  expect_played_here(
      "expect results contains \"Results: runs.results\"\n"
      "do tool.goal\n"
      "click view \"at 5 3\"\n"
      "wait idle\n"
      "expect runs contains \"no runs of this scenario\"\n"
      "key F9\n"
      "wait idle\n"
      "expect status contains \"4 runs on room: \"\n"
      "expect results contains \"Run here, campaign rooms\"\n"
      "expect runs contains \"nd 1: shown, \"\n"
      "expect view contains \"trajectory vff 0, \"\n"
      "expect replay contains \" of \"\n"
      "key Ctrl+Z\n"
      "wait idle\n"
      "expect results contains \"Results: runs.results\"\n"
      "key Ctrl+Y\n"
      "wait idle\n"
      "expect results contains \"Run here, campaign rooms\"\n"
      "expect view contains \"trajectory vff 0, \"\n"
      "do generate.discard\n"
      "wait idle\n"
      "expect runs contains \"no runs of this scenario\"\n",
      "--results out/runs.results");
  EXPECT_EQ(read("out/runs.results"), before);
}

TEST_F(StudioRun, RepeatsTheRecordedRunsOnTheScenarioOfTheCampaign) {
  make_results();
  const std::string shown = expect_played_here(
      "print runs\n"
      "do generate.run\n"
      "wait idle\n"
      "expect results contains \"Run here\"\n"
      "print runs\n",
      "--results out/runs.results");
  ASSERT_FALSE(shown.empty());
  EXPECT_EQ(shown.substr(0, shown.size() / 2), shown.substr(shown.size() / 2));
}

TEST_F(StudioRun, TakesTheCampaignOfAnIniOrOfTheForm) {
  write("rooms.ini", kRoomCampaign);
  expect_played_here(
      "key F9\n"
      "wait idle\n"
      "expect results contains \"Run here, campaign rooms\"\n"
      "expect view contains \"trajectory nd 0, \"\n",
      "-c rooms.ini --set campaign.repetitions=1");
  expect_played_here(
      "key F9\n"
      "expect status contains \"no campaign is open: open results, or choose an .ini by\"\n"
      "do generate.campaign\n"
      "click dialog \"field campaign\"\n"
      "type none.ini\n"
      "click dialog ok\n"
      "expect dialog contains \"none.ini: does not exist\"\n"
      "click dialog \"field campaign\"\n"
      "key Ctrl+A\n"
      "type rooms.ini\n"
      "click dialog ok\n"
      "key F9\n"
      "wait idle\n"
      "expect view contains \"trajectory nd 1, \"\n",
      "");
}

TEST_F(StudioRun, ExecutesALibraryOfResultsOnlyIfTheyAreTrusted) {
  write("planted.ini", kPlantedCampaign);
  ASSERT_EQ(
      run("slalom-evaluate planted.ini --set scenarios.list=room.scenarios -o out --quiet").status,
      0);
  expect_played_here(
      "key F9\n"
      "wait idle\n"
      "expect status contains \"would execute\"\n"
      "expect dialog contains \"would execute\"\n"
      "click dialog cancel\n"
      "expect results contains \"Results: runs.results\"\n"
      "do generate.campaign\n"
      "click dialog \"field trust\"\n"
      "click dialog ok\n"
      "key F9\n"
      "wait idle\n"
      "expect results contains \"Run here, campaign planted\"\n",
      "--results out/runs.results");
}

TEST_F(StudioRun, TrustsResultsAtTheQuestionAndRuns) {
  write("planted.ini", kPlantedCampaign);
  ASSERT_EQ(
      run("slalom-evaluate planted.ini --set scenarios.list=room.scenarios -o out --quiet").status,
      0);
  expect_played_here(
      "key F9\n"
      "wait idle\n"
      "expect dialog contains \"would execute\"\n"
      "click dialog ok\n"
      "wait idle\n"
      "expect results contains \"Run here, campaign planted\"\n",
      "--results out/runs.results");
}

TEST_F(StudioRun, SaysThatAPluginIsMissing) {
  write("faulty.ini", faulty_campaign("none", "missing.so"));
  expect_played_here(
      "key F9\n"
      "wait idle\n"
      "expect status contains \"library 'missing.so' not found\"\n"
      "expect dialog contains \"library 'missing.so' not found\"\n",
      "-c faulty.ini");
}

TEST_F(StudioRun, ShowsTheRunOfAMethodThatCrashes) {
  write("faulty.ini", faulty_campaign("crash"));
  expect_played_here(
      "key F9\n"
      "wait idle\n"
      "expect status contains \"1 run on room: 1 method_crash; the line below\"\n"
      "expect runs contains \"mine: shown, method_crash\"\n"
      "expect view contains \"trajectory mine 0, method_crash\"\n",
      "-c faulty.ini");
}

TEST_F(StudioRun, EndsAMethodAtTheLimitOfTheCampaign) {
  write("faulty.ini", faulty_campaign("hang") + "[limits]\nrun_wall_time = 0.5\n");
  expect_played_here(
      "key F9\n"
      "wait idle\n"
      "expect status contains \"1 run on room: 1 method_deadline\"\n",
      "-c faulty.ini");
}

TEST_F(StudioRun, IsCanceledWhileTheWindowIsUsedAndLeavesNoProcessWhenItIsClosed) {
  write("faulty.ini", faulty_campaign("hang"));
  expect_played_here(
      "key F9\n"
      "wait until status contains \"Run methods on room\"\n"
      "do tool.goal\n"
      "click view \"at 5 3\"\n"
      "expect view contains \"goal 5.\"\n"
      "key F9\n"
      "expect status contains \"methods are running\"\n"
      "click status cancel\n"
      "wait idle\n"
      "expect status contains \"canceled\"\n"
      "key F9\n"
      "wait until status contains \"Run methods on room\"\n"
      "do file.quit\n",
      "-c faulty.ini");
}

}  // namespace
}  // namespace slalom
