// SPDX-License-Identifier: BSD-3-Clause
// Campaigns with nodes of ROS 2, in a private network namespace if permitted.
#include "places.h"
#include "private_network.h"
#include "program_run.h"

#include <nlohmann/json.hpp>

#include <map>

namespace slalom {
namespace {

using Json = nlohmann::json;

class Ros2ProgramTest : public ProgramTest {
 protected:
  static void SetUpTestSuite() { enter_private_network(); }

  /// The small campaign with nodes on Cyclone DDS. A slow machine does not reach their limits.
  void write_campaign(const std::string& methods, const std::string& sections) const {
    std::string text = kSmallCampaign;
    text.replace(text.find("nd, gap"), 7, methods);
    write("small.ini", text + sections);
  }
  static std::string section(const std::string& name, const std::string& arguments,
                             const std::string& keys = "") {
    return "[method." + name + "]\nadapter = ros2\nlaunch = exec " + kCyclonePeer + " " +
           arguments + "\ndeadline = 100\nstartup_time = 100\n" + keys;
  }

  /// The runs by scenario and method, without the name of the method.
  std::map<std::string, std::map<std::string, Json>> runs(const std::string& jobs) const {
    const ProgramResult result =
        run("slalom-evaluate small.ini --quiet -o out" + jobs + " -j " + jobs);
    EXPECT_EQ(result.status, 0) << result.err;
    std::istringstream lines(run("slalom-analyze dump out" + jobs + "/runs.results").out);
    std::map<std::string, std::map<std::string, Json>> runs;
    for (std::string line; std::getline(lines, line);) {
      Json record = Json::parse(line);
      const std::string method = record.at("method");
      record.erase("method");
      runs[record.at("scenario").dump()][method] = record;
    }
    return runs;
  }

  /// Processes that execute the node in this network: those of other tests are not counted.
  static int running_nodes() {
    int count = 0;
    std::error_code error;
    const auto network = std::filesystem::read_symlink("/proc/self/ns/net", error);
    for (const auto& process : std::filesystem::directory_iterator("/proc"))
      if (std::filesystem::read_symlink(process.path() / "exe", error) == kCyclonePeer &&
          std::filesystem::read_symlink(process.path() / "ns/net", error) == network)
        ++count;
    return count;
  }
};

TEST_F(Ros2ProgramTest, ACampaignHasTheSameResultsForAnyNumberOfWorkersAndBothModes) {
  write_campaign("scan, timer", section("scan", "--stamped") +
                                    section("timer", "--stamped --timer", "barrier = method\n"));
  const auto one = runs("1");
  EXPECT_EQ(one, runs("2"));
  ASSERT_EQ(one.size(), 4U);
  for (const auto& [scenario, by_method] : one)
    EXPECT_EQ(by_method.at("scan"), by_method.at("timer")) << scenario;
  EXPECT_EQ(running_nodes(), 0);
}

TEST_F(Ros2ProgramTest, ParametersOfNodesAreTuned) {
  write("node.ini",
        "[campaign]\nmethods = node\n[scenarios]\ngenerator = passage\n"
        "[simulation]\nstuck_time = 1\n" +
            section("node", "", "parameter_set = method.count=3; method.speed=0\n") +
            "[tune]\nmethod.speed = 0, 1\n");
  const std::string tune = "slalom-tune node.ini --quiet --method node ";
  const ProgramResult result = run(tune + "--runs 300 --sealed 200 -o out");
  ASSERT_EQ(result.status, 0) << result.err;
  const Json answer = Json::parse(read("out/tuned.json")).at("answer");
  EXPECT_EQ(answer.at("default").at("method.speed"), "0.0") << "a double, also in a file of ROS";
  // A robot that stands still never succeeds; this node passes some doors in front of it.
  EXPECT_GT(std::stod(answer.at("winner").at("method.speed").get<std::string>()), 0);
  EXPECT_NE(read("out/tuned.ini").find("parameter_set = method.count=3; method.speed=0."),
            std::string::npos);
  expect_failure(tune + "--set tune.method.speed=0,2 -o other", 2,
                 {"--set tune.method.speed = 0, 2: node refuses 2: ", "parameter_set",
                  "the node /method refuses speed = 2.0: it is beyond 1"});
  EXPECT_EQ(running_nodes(), 0);
}

TEST_F(Ros2ProgramTest, ACertificateIsOfTheParametersThatNodesAreGiven) {
  write("node.ini",
        "[campaign]\nmethods = node\n[scenarios]\ngenerator = passage\n"
        "[simulation]\nstuck_time = 1\n" +
            section("node", "", "parameter_set = method.speed=0\n"));
  const ProgramResult result = run(
      "slalom-certify risk node.ini --quiet --method node --outcome failure --budget 40 -o a.json");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("stuck  40"), std::string::npos) << result.out;
}

TEST_F(Ros2ProgramTest, TheCampaignOfNav2RunsWithBothOfItsLayouts) {
  for (const std::string layout : {"humble", "jazzy"}) {
    const ProgramResult result = run(
        "slalom-evaluate " + kConfigs + "/nav2.ini -o " + layout +
        " -j 1 --set scenarios.count=2 --set simulation.max_time=1 --set record.repeated_runs=0 "
        "--set 'method.nav2.launch=exec " +
        kCyclonePeer + " " + layout + "'");
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("nav2*      2        2\n"), std::string::npos) << result.out;
  }
  expect_failure("slalom-analyze table jazzy/runs.results --columns cycle_time_mean", 2,
                 {"metric 'cycle_time_mean'", "methods that follow the wall clock have none"});
}

TEST_F(Ros2ProgramTest, ACampaignGoesOnAfterNodesThatAreKilled) {
  write_campaign("node", section("node", "killed"));
  const auto all = runs("2");
  ASSERT_EQ(all.size(), 4U);
  int killed = 0;
  for (const auto& [scenario, by_method] : all)
    if (by_method.at("node").at("outcome") == "method_error") ++killed;
  EXPECT_GT(killed, 0);
  EXPECT_LT(killed, 4);  // goals with y > 3 only
  EXPECT_EQ(running_nodes(), 0);
}

TEST_F(Ros2ProgramTest, StaleCommandsAreShownWithTheCampaignInTablesAndWithTheirRun) {
  write_campaign("node", section("node", "--stamped stale"));
  const ProgramResult evaluated = run("slalom-evaluate small.ini -o out1 -j 1");
  EXPECT_NE(evaluated.err.find("node: commands were stale ("), std::string::npos) << evaluated.err;
  EXPECT_NE(read("out1/report/report.json").find("node: commands were stale ("), std::string::npos);
  const ProgramResult table =
      run("slalom-analyze table out1/runs.results --columns success,commands_stale --csv");
  EXPECT_NE(table.out.find("commands_stale"), std::string::npos) << table.err;
  const ProgramResult shown = run("slalom-analyze show out1/runs.results --run random_0000/node/0");
  for (const char* const id : {"commands_stale", "commands_missing", "commands_late"})
    EXPECT_NE(shown.out.find(id), std::string::npos) << shown.out;
}

TEST_F(Ros2ProgramTest, NodesAreLaunchedOnceForTheCheckAndOnceForEachRunOnRequest) {
  write_campaign("node",
                 "[record]\nrepeated_runs = 0\n[method.node]\nadapter = ros2\n"
                 "launch = echo launched >> $COUNTED; exec " +
                     kCyclonePeer + "\nrestart = run\ndeadline = 100\nstartup_time = 100\n");
  const ProgramResult result =
      run("COUNTED=$PWD/launches slalom-evaluate small.ini --quiet -o out -j 1");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(read("launches"), "launched\nlaunched\nlaunched\nlaunched\nlaunched\n");
}

TEST_F(Ros2ProgramTest, TheLastErrorThatNodesPrintedIsNamedWithItsRun) {
  write_campaign("node",
                 "[method.node]\nadapter = ros2\nlaunch = echo '[ERROR] [1.0] [planner]: no "
                 "path'; exec " +
                     kCyclonePeer + " pauses\npatience = 0.02\nrestart = run\n");
  const std::string err = run("slalom-evaluate small.ini -o out -j 1 --set record.repeated_runs=0 "
                              "--set simulation.max_time=10")
                              .err;
  EXPECT_NE(err.find("node: what it printed: slalom-analyze show out/runs.results --run "),
            std::string::npos)
      << err;
  EXPECT_NE(err.find("; its last error: [ERROR] [1.0] [planner]: no path\n"), std::string::npos)
      << err;
  write_campaign("node",
                 "[method.node]\nadapter = ros2\nstartup_time = 2\n"
                 "launch = echo '[FATAL] [1.0] [server]: no plugin'; exec sleep 100\n");
  expect_failure("slalom-evaluate small.ini -o other", 2,
                 {"there is no reader of /scan",
                  "the last error that it printed: [FATAL] [1.0] [server]: no plugin"});
}

TEST_F(Ros2ProgramTest, ProgramsDoNotLoadDdsWithoutSuchAMethod) {
  for (const std::string program : {"slalom-evaluate", "slalom-simulate", "slalom-studio"})
    EXPECT_EQ(run("ldd \"$(command -v " + program + ")\"").out.find("ddsc"), std::string::npos);
}

TEST_F(Ros2ProgramTest, AMethodInADomainNeedsTheNetwork) {
  write_campaign("node", section("node", ""));
  expect_failure("slalom-evaluate small.ini -o out --set limits.network=false", 2,
                 {"network", "[method.node] communicates over the network", "expected true"});
}

}  // namespace
}  // namespace slalom
