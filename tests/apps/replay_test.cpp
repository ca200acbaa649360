// SPDX-License-Identifier: BSD-3-Clause
#include "../adapters/formats/bags/message_bytes.h"
#include "occurrences.h"
#include "program_run.h"

#include <nlohmann/json.hpp>

namespace slalom {
namespace {

using Json = nlohmann::json;

const std::string kDatasets = "/usr/share/mrpt/datasets/";

/// Noise and drift, so that the recorded data cannot be recomputed without the rawlog.
const char* const kNoisy = R"(
[sensor]
noise_sigma = 0.01
latency     = 0.05
[odometry]
distance_sigma = 0.02
turn_sigma     = 0.02
[record]
rawlog = all
)";

/// A campaign whose runs are all recorded.
class Replay : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("small.ini", std::string(kSmallCampaign) + kNoisy);
    const ProgramResult result = run("slalom-simulate run -c small.ini -o runs.results --quiet");
    ASSERT_EQ(result.status, 0) << result.err;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "runs.rawlogs"))
      logs_.push_back("runs.rawlogs/" + entry.path().filename().string());
    std::sort(logs_.begin(), logs_.end());
    ASSERT_EQ(logs_.size(), 8U);  // two methods in four scenarios
  }

  /// The first run of a method.
  std::string log_of(const std::string& method) const {
    for (const std::string& log : logs_)
      if (log.find("_" + method + "_") != std::string::npos) return log;
    return "none";
  }

  std::vector<std::string> logs_;
};

TEST_F(Replay, RawlogEditOpensARun) {
  const ProgramResult result = run("rawlog-edit --info -i " + log_of("nd"));
  ASSERT_EQ(result.status, 0) << result.err;
  for (const char* label : {"command", "ground_truth", "odometry", "range_finder"})
    EXPECT_NE(result.out.find(label), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("Observations format               : Yes"), std::string::npos);
}

TEST_F(Replay, CheckPassesOnUnchangedRuns) {
  for (const std::string& log : logs_) {
    const ProgramResult result = run("slalom-replay check " + log);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("reproduces all"), std::string::npos) << result.out;
  }
}

TEST_F(Replay, CheckFailsForAnotherMethodOrParameter) {
  expect_failure("slalom-replay check " + log_of("nd") + " --method gap", 1,
                 {log_of("nd"), "cycle ", "recorded", "replayed"});
  expect_failure("slalom-replay check " + log_of("nd") + " --set method.nd.turn_gain=1.7", 1,
                 {"cycle ", "w = "});
  write("other.ini", read("small.ini") + "[robot]\nmax_w = 0.05\n");
  expect_failure("slalom-replay check " + log_of("nd") + " -c other.ini", 1, {"cycle "});
  EXPECT_EQ(run("slalom-replay check " + log_of("nd") + " -c small.ini").status, 0);
}

TEST_F(Replay, CheckRejectsAnotherSensor) {
  expect_failure("slalom-replay check " + log_of("nd") + " --set sensor.rays=91", 2,
                 {"rays", "181"});
}

TEST_F(Replay, MetricsEqualTheResultFile) {
  std::istringstream dump(run("slalom-analyze dump runs.results").out);
  std::map<std::string, Json> stored;  // by scenario and method
  for (std::string line; std::getline(dump, line);) {
    Json json = Json::parse(line);
    json["descriptors"] = Json::object();  // the rawlog of a run does not compute them
    stored[json["scenario"]["hash"].get<std::string>() + json["method"].get<std::string>()] = json;
  }
  for (const std::string& log : logs_) {
    const ProgramResult result = run("slalom-replay metrics --json --results runs.results " + log);
    ASSERT_EQ(result.status, 0) << result.err;
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json, stored.at(json["scenario"]["hash"].get<std::string>() +
                              json["method"].get<std::string>()));
  }
}

TEST_F(Replay, MetricsAmongPeopleEqualTheResultFile) {
  // "all" contains the metrics about movers and people in both scenarios.
  const std::string room =
      "representation: continuous\nbounds: [0, 0, 8, 6]\nstart: [1, 3, 0]\ngoal: [7, 3]\ndiscs: "
      "[]\npolygons: []\n";
  write("still.scenario.yaml", "name: still\n" + room);
  write("walked.scenario.yaml", "name: walked\n" + room +
                                    "people:\n  - id: anna\n    radius: 0.25\n    speed: 1.3\n"
                                    "    start: [6, 3]\n    route: [[2, 3]]\n");
  ASSERT_EQ(run("slalom-scenarios import still.scenario.yaml walked.scenario.yaml -o two.scenarios")
                .status,
            0);
  write("two.ini",
        "[campaign]\nmethods = nd\n[scenarios]\nlist = two.scenarios\n[record]\nrawlog = all\n"
        "[method.nd]\nadapter = mrpt_holonomic\nclass = CHolonomicND\n");
  ASSERT_EQ(run("slalom-simulate run -c two.ini -o two.results --quiet").status, 0);
  int hindered = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "two.rawlogs")) {
    const ProgramResult result =
        run("slalom-replay metrics --json --results two.results " + entry.path().string());
    ASSERT_EQ(result.status, 0) << result.err;
    const Json hindrance = Json::parse(result.out)["metrics"]["people_hindrance"];
    hindered += hindrance.contains("value") && hindrance["value"].get<double>() > 0 ? 1 : 0;
    EXPECT_EQ(hindrance.value("na", "no people"), "no people");
  }
  EXPECT_EQ(hindered, 1);
}

TEST_F(Replay, MetricsOfAnotherCampaignDiffer) {
  ASSERT_EQ(run("slalom-simulate run -c small.ini -o other.results --quiet --set robot.max_v=0.7 "
                "--set record.rawlog=none")
                .status,
            0);
  expect_failure("slalom-replay metrics --results other.results " + log_of("nd"), 1,
                 {log_of("nd"), "stored value"});
}

TEST_F(Replay, PlayWritesImagesAtAnInterval) {
  const std::string log = log_of("gap");
  const ProgramResult all = run("slalom-replay play " + log + " --png all");
  ASSERT_EQ(all.status, 0) << all.err;
  ASSERT_EQ(run("slalom-replay play " + log + " --png some --every 10 --size 200").status, 0);
  const auto count = [&](const std::string& folder) {
    const auto files = std::filesystem::directory_iterator(folder_ / folder);
    return std::distance(begin(files), end(files));
  };
  const std::string check = run("slalom-replay check " + log).out;
  const std::size_t at = check.find("reproduces all ") + 15;
  const int cycles = std::stoi(check.substr(at));
  EXPECT_EQ(count("all"), cycles + 1);              // each cycle and the last sample
  EXPECT_EQ(count("some"), (cycles + 9) / 10 + 1);  // cycles 0, 10, 20, ... and the last sample
  EXPECT_EQ(read("all/frame_000000.png").substr(1, 3), "PNG");
  EXPECT_NE(read("all/frame_000000.png"), read("all/frame_000010.png"));
}

TEST_F(Replay, OpenLoopReadsLogsOfRealRobots) {
  for (const auto& [name, scans] :
       {std::pair{"localization_demo.rawlog", 37},
        std::pair{"2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog", 225}}) {
    const std::string log = "'" + kDatasets + name + "'";
    const ProgramResult result =
        run("slalom-replay openloop " + log + " --method nd -c small.ini --json --each");
    ASSERT_EQ(result.status, 0) << result.err;
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["scans"], scans);
    EXPECT_EQ(json["commands"], scans);
    EXPECT_EQ(json["answers"].size(), static_cast<std::size_t>(scans));
    // ND avoids the obstacles of the scan.
    EXPECT_EQ(json["contact"]["stopping"], 0);
    EXPECT_GT(json["mean_v"].get<double>(), 0.3);
    const Json& log_velocities = json["log_velocities"];
    EXPECT_GE(log_velocities["compared"], scans - 2) << "one scan has no odometry yet";
    // Drives of less than 1 m/s; ND commands 0.3 to 1 m/s.
    EXPECT_GT(log_velocities["difference_v"].get<double>(), 0);
    EXPECT_LT(log_velocities["difference_v"].get<double>(), 1);
    // A robot as wide as the corridor touches the walls.
    const ProgramResult wide = run("slalom-replay openloop " + log +
                                   " --method nd -c small.ini --json --set robot.radius=1.5");
    const Json contact = Json::parse(wide.out)["contact"];
    const int contacts = contact["already"].get<int>() + contact["stopping"].get<int>();
    EXPECT_GT(contacts, 0) << wide.out;
    run("slalom-replay openloop " + log +
        " --method nd -c small.ini --picture drive.svg --set robot.radius=1.5");
    EXPECT_EQ(count(read("drive.svg"), ": collision</title>"), 2U * static_cast<unsigned>(contacts))
        << "line and cross of each contact, not only of one per 0.25 m";
    EXPECT_EQ(count(read("drive.svg"), "<title>driven</title>"), 1U) << "no outcome: it is no run";
    EXPECT_EQ(count(read("drive.svg"), ": success</title>"), 0U);
  }
}

TEST_F(Replay, APictureDoesNotReplaceTheLog) {
  const std::string log = kDatasets + "localization_demo.rawlog";
  ASSERT_EQ(run("cp " + log + " plain.rawlog.gz && gzip -d plain.rawlog.gz").status, 0);
  const std::string before = read("plain.rawlog");
  expect_failure(
      "slalom-replay openloop plain.rawlog --method nd -c small.ini --picture "
      "./plain.rawlog",
      2, {"--picture ./plain.rawlog", "is also an input", "different"});
  EXPECT_EQ(read("plain.rawlog"), before);
}

TEST_F(Replay, IdentifyPrintsKeysOfTheCampaign) {
  ASSERT_EQ(run("slalom-simulate run -c small.ini -o slow.results --quiet --set robot.delay=0.12 "
                "--set robot.delay_tau=0.3 --set robot.max_accel_v=0.5")
                .status,
            0);
  const std::string log = "slow" + log_of("nd").substr(4);
  for (const std::string config : {"", " -c small.ini --set robot.max_accel_v=0.5"}) {
    const ProgramResult result = run("slalom-replay identify --json " + log + config);
    ASSERT_EQ(result.status, 0) << result.err;
    const Json estimates = Json::parse(result.out)["estimates"];
    EXPECT_NEAR(estimates["delay"]["value"].get<double>(), 0.12, 0.05 * 0.12) << result.out;
    EXPECT_NEAR(estimates["delay_tau"]["value"].get<double>(), 0.3, 0.05 * 0.3) << result.out;
    EXPECT_NEAR(estimates["v_bias"]["value"].get<double>(), 1, 0.05);
    EXPECT_NE(estimates["noise_sigma"]["na"].get<std::string>().find("stationary"),
              std::string::npos);
  }
  // The fragment is valid in a campaign.
  const std::string text = run("slalom-replay identify " + log).out;
  write("pasted.ini", kSmallCampaign + text.substr(text.find("[robot]")));
  EXPECT_EQ(run("slalom-simulate run -c pasted.ini -o pasted.results --quiet").status, 0);
}

TEST_F(Replay, IdentifyNeedsVelocitiesOrAStationaryRobot) {
  expect_failure("slalom-replay identify '" + kDatasets + "localization_demo.rawlog'", 3,
                 {"localization_demo", "nothing can be estimated", "'command'", "expected"});
  expect_failure("slalom-replay identify " + log_of("nd") + " --command-label cmd", 3,
                 {"'cmd'", "the log has 'odometry', 'command'", "stationary"});
  expect_failure("slalom-replay identify small.ini", 3, {"small.ini", "object 1"});
  expect_failure("slalom-replay identify " + log_of("nd") + " -c missing.ini", 3, {"missing.ini"});
  expect_failure("slalom-replay identify " + log_of("nd") + " --set robot.max_v=1", 2,
                 {"--config"});
}

TEST_F(Replay, RejectsInvalidInput) {
  expect_failure("slalom-replay check small.ini", 3, {"small.ini", "object 1"});
  expect_failure("slalom-replay metrics nothing.rawlog", 3, {"nothing.rawlog", "cannot be read"});
  expect_failure(
      "slalom-replay openloop " + kDatasets + "RO-SLAM_demo.rawlog --method nd -c small.ini", 3,
      {"no 2D scan"});
  expect_failure("slalom-replay openloop " + log_of("nd") + " --method vfh -c small.ini", 2,
                 {"method.vfh"});
  expect_failure("slalom-replay play " + log_of("nd"), 2, {"--png"});
  expect_failure("slalom-replay play none.rawlog", 3, {"none.rawlog", "No such file"});
  write("cut.rawlog", read(log_of("nd")).substr(0, 5000));
  expect_failure("slalom-replay check cut.rawlog", 3, {"cut.rawlog", "truncated"});
}

TEST_F(Replay, PrintsHelp) {
  for (const std::string verb : {"", "play ", "check ", "metrics ", "openloop ", "identify "}) {
    const ProgramResult result = run("slalom-replay " + verb + "--help");
    EXPECT_EQ(result.status, 0);
    EXPECT_NE(result.out.find("Usage"), std::string::npos);
  }
  EXPECT_EQ(run("slalom-replay --version").out.substr(0, 14), "slalom-replay ");
}

/// A bag of a robot that drives 0.5 m/s towards a wall, and an .ini with a method.
class ReplayBag : public ProgramTest {
 protected:
  void SetUp() override {
    using testing::kSecond;
    constexpr auto kCdr = testing::Layout::CdrLittle;
    ProgramTest::SetUp();
    testing::McapWriter bag;
    const auto laser = testing::pose_numbers(0.25, 0, 0);
    bag.add({"/tf_static", "tf2_msgs/TFMessage", 0,
             testing::transform_bytes(kCdr, 0, "base_link", "laser", laser)});
    for (int i = 1; i < 10; ++i) {
      const std::int64_t time = i * kSecond / 10;
      bag.add({"/odom", "nav_msgs/Odometry", time,
               testing::odometry_bytes(kCdr, time, "base_link",
                                       testing::pose_numbers(0.05 * i, 0, 0), 0.5, 0)});
      bag.add({"/scan", "sensor_msgs/LaserScan", time,
               testing::scan_bytes(kCdr, time, "laser", -1, 0.02F, 8,
                                   std::vector<float>(101, 3.0F - 0.05F * float(i)))});
    }
    write("drive.mcap", bag.bytes());
    write("small.ini", kSmallCampaign);
  }
};

TEST_F(ReplayBag, OpenLoopAnswersABagAsItsRawlog) {
  const ProgramResult imported = run("slalom-replay import drive.mcap -o drive.rawlog");
  ASSERT_EQ(imported.status, 0) << imported.err;
  EXPECT_NE(imported.out.find("drive.rawlog: 18 observations"), std::string::npos) << imported.out;
  EXPECT_NE(imported.err.find("laser 'laser' is at (0.250, 0.000, 0.000) m"), std::string::npos);
  const std::string options = " -c small.ini --method nd --each --json";
  const ProgramResult bag = run("slalom-replay openloop drive.mcap" + options);
  const ProgramResult rawlog = run("slalom-replay openloop drive.rawlog" + options);
  ASSERT_EQ(bag.status, 0) << bag.err;
  Json of_bag = Json::parse(bag.out), of_rawlog = Json::parse(rawlog.out);
  EXPECT_EQ(of_bag["scans"], 9);
  EXPECT_EQ(of_bag["with_odometry"], 9);
  of_bag.erase("log");
  of_rawlog.erase("log");
  EXPECT_EQ(of_bag, of_rawlog);
}

TEST_F(ReplayBag, ABagIsNotOverwritten) {
  expect_failure("slalom-replay import drive.mcap -o drive.mcap", 2,
                 {"drive.mcap", "is also an input"});
  EXPECT_EQ(run("slalom-replay info drive.mcap").status, 0);
  expect_failure("slalom-replay import small.ini -o a.rawlog", 3,
                 {"small.ini", "is not a bag", ".mcap"});
  expect_failure("slalom-replay openloop drive.mcap -c small.ini --method nd --scan /scam", 3,
                 {"no topic '/scam'", "'/scan'"});
}

TEST_F(ReplayBag, InfoListsTopics) {
  const ProgramResult info = run("slalom-replay info drive.mcap --json");
  ASSERT_EQ(info.status, 0) << info.err;
  EXPECT_EQ(Json::parse(info.out)["topics"].size(), 3U);
}

}  // namespace
}  // namespace slalom
