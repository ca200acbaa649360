// SPDX-License-Identifier: BSD-3-Clause
#include "../adapters/formats/bags/message_bytes.h"
#include "program_run.h"

#include <slalom/core/text.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace slalom {
namespace {

/// A robot's log in a room of 10 m x 6 m with a column of 1 m diameter at its center.
class MetricsOfALog : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("room.yaml",
          "name: room\nrepresentation: continuous\nbounds: [0, 0, 10, 6]\nstart: [1, 3, 0]\n"
          "goal: [9, 3]\ndiscs:\n  - [5, 3, 0.5]\npolygons: []\n");
    // Around the column: up to y = 4.5 at x = 5 and down again, at 1 m/s with samples every 0.5 m.
    std::string csv = "t,x,y,phi\n", tum;
    const double slope = 1.5 / 4, half_length = std::hypot(4, 1.5);
    for (int i = 0; i <= 2 * std::floor(half_length / 0.5) + 1; ++i) {
      const double s = 0.5 * i, x = 1 + s * 4 / half_length,
                   y = 3 + slope * (x < 5 ? x - 1 : 9 - x);
      const double phi = std::atan(x < 5 ? slope : -slope);
      const std::string at = std::to_string(s) + " " + std::to_string(x) + " " + std::to_string(y);
      std::string comma = at + " " + std::to_string(phi);
      std::replace(comma.begin(), comma.end(), ' ', ',');
      csv += comma + "\n";
      tum += at + " 0 0 0 " + std::to_string(std::sin(phi / 2)) + " " +
             std::to_string(std::cos(phi / 2)) + "\n";
    }
    write("log.csv", csv);
    write("log.tum", "# timestamp tx ty tz qx qy qz qw\n" + tum);
  }

  nlohmann::json metrics(const std::string& options) const {
    const ProgramResult result =
        run("slalom-analyze metrics --scenario room.yaml --json " + options);
    EXPECT_EQ(result.status, 0) << result.err;
    return nlohmann::json::parse(result.out);
  }
  static double value(const nlohmann::json& json, const std::string& id) {
    return json.at("metrics").at(id).at("value").get<double>();
  }
};

/// A table of logs of two methods in two scenarios.
class MetricsOfManyLogs : public MetricsOfALog {
 protected:
  void SetUp() override {
    MetricsOfALog::SetUp();
    std::filesystem::create_directories(folder_ / "logs");
    std::filesystem::create_directories(folder_ / "rooms");
    write("rooms/room.yaml", read("room.yaml"));
    std::string wide = read("room.yaml");
    write("rooms/wide_room.yaml", wide.replace(wide.find("room"), 4, "wide_room"));
    log_ = read("log.csv");
    for (const char* name : {"dwb_room_1", "dwb_wide_room_1", "mppi_room_1", "mppi_room_2"})
      write("logs/" + std::string(name) + ".csv", log_);
    write("logs/remarks.md", "two of the robots were new\n");
  }
  static constexpr const char* kPattern =
      " --name-pattern '{method}_{scenario}_{repetition}.csv' --scenarios rooms";
  std::string log_;
};

TEST_F(MetricsOfManyLogs, AreATableThatCanBeRead) {
  const ProgramResult made =
      run("slalom-analyze metrics logs -o table.csv" + std::string(kPattern));
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_NE(made.err.find("and 3 other runs: v and w computed"), std::string::npos) << made.err;
  EXPECT_NE(made.err.find("1 file left out"), std::string::npos) << made.err;
  const std::string table = read("table.csv");
  for (const char* row :
       {"log,method,scenario,repetition,outcome,", "\nlogs/dwb_room_1.csv,dwb,room,1,success,",
        "\nlogs/dwb_wide_room_1.csv,dwb,wide_room,1,success,",
        "\nlogs/mppi_room_2.csv,mppi,room,2,success,"})
    EXPECT_NE(table.find(row), std::string::npos) << row;
  const auto single = metrics("--trajectory log.csv");
  const ProgramResult read_again =
      run("slalom-analyze table table.csv --csv --columns path_length --method dwb");
  EXPECT_EQ(read_again.status, 0) << read_again.err;
  EXPECT_NE(read_again.out.find("," + format_number(value(single, "path_length")) + ","),
            std::string::npos)
      << read_again.out;
}

TEST_F(MetricsOfManyLogs, OneBadLogDoesNotEndTheOthers) {
  write("logs/dwb_room_2.csv", "t,x\n0,1\n");
  write("logs/dwb_attic_1.csv", log_);
  const ProgramResult made = run("slalom-analyze metrics logs --quiet" + std::string(kPattern));
  EXPECT_EQ(made.status, 1);
  EXPECT_NE(made.err.find("2 of 6 logs refused"), std::string::npos) << made.err;
  for (const char* row :
       {"\nlogs/mppi_room_2.csv,mppi,room,2,success,", "\nlogs/dwb_room_2.csv,dwb,room,2,,",
        "missing column 'y'", "no scenario 'attic'"})
    EXPECT_NE(made.out.find(row), std::string::npos) << row;
}

TEST_F(MetricsOfManyLogs, ALogWhoseTimeGoesBackIsSeveralRuns) {
  const std::string rows = log_.substr(log_.find('\n') + 1);
  write("double.csv", log_ + rows + "0,1,3,0\n");
  const ProgramResult split =
      run("slalom-analyze metrics double.csv --split --scenario room.yaml --quiet");
  EXPECT_EQ(split.status, 0) << split.err;
  EXPECT_NE(split.out.find("\ndouble.csv,room,1,success,"), std::string::npos) << split.out;
  EXPECT_NE(split.out.find("\ndouble.csv,room,2,success,"), std::string::npos) << split.out;
  EXPECT_EQ(split.out.find("\ndouble.csv,room,3,"), std::string::npos) << "one sample";
  expect_failure("slalom-analyze metrics --trajectory double.csv --scenario room.yaml", 3,
                 {"goes back", "--split several runs"});
}

TEST_F(MetricsOfManyLogs, WrongArgumentsAreRefused) {
  expect_failure("slalom-analyze metrics --scenario room.yaml", 2, {"no log", "--trajectory LOG"});
  expect_failure("slalom-analyze metrics log.csv", 2, {"--scenario", "--scenarios FOLDER or LIST"});
  expect_failure("slalom-analyze metrics --trajectory log.csv --split --scenario room.yaml", 2,
                 {"without --trajectory"});
  expect_failure("slalom-analyze metrics log.csv --scenarios rooms", 2, {"{scenario}"});
  expect_failure("slalom-analyze metrics rooms --scenario room.yaml", 3, {"rooms: no logs"});
  const std::string log = "slalom-analyze metrics log.csv --scenario room.yaml --name-pattern ";
  for (const char* pattern :
       {"'{method}{scenario}'", "'{metho}'", "log", "'{method'", "'{method}_{method}'"})
    expect_failure(log + pattern, 2, {"--name-pattern", "at most once"});
  expect_failure(log + "'{method}_{scenario}'", 2, {"does not match log.csv"});
  write("a_b_c.csv", log_);
  expect_failure(
      "slalom-analyze metrics a_b_c.csv --scenario room.yaml --name-pattern '{method}_{scenario}'",
      2, {"2 ways", "method a, scenario b_c", "a folder for each method"});
}

TEST_F(MetricsOfALog, AreComputedUpToTheGoal) {
  const auto json = metrics("--trajectory log.csv");
  EXPECT_EQ(json["outcome"], "success");
  EXPECT_EQ(value(json, "success"), 1);
  // The path has 2 hypot(4, 1.5) m and ends within 0.2 m of the goal.
  EXPECT_NEAR(value(json, "path_length"), 2 * std::hypot(4, 1.5) - 0.2, 0.03);
  EXPECT_NEAR(value(json, "time_to_goal"), 2 * std::hypot(4, 1.5) - 0.2, 0.03);
  EXPECT_GT(value(json, "optimality"), 0.9);
  EXPECT_LT(value(json, "optimality"), 0.99);
  EXPECT_EQ(json["metrics"]["command_variation_v"]["na"], "no commands are recorded");
  EXPECT_EQ(json["notes"][0], "v and w computed from pose differences");
}

TEST_F(MetricsOfALog, AreTheSameForCsvAndTum) {
  const auto csv = metrics("--trajectory log.csv"), tum = metrics("--trajectory log.tum");
  for (const auto& [id, entry] : csv["metrics"].items()) {
    ASSERT_EQ(entry.contains("na"), tum["metrics"][id].contains("na")) << id;
    if (entry.contains("na")) continue;
    const double expected = value(csv, id);
    EXPECT_NEAR(value(tum, id), expected, 1e-3 * (1 + std::abs(expected))) << id;
  }
}

TEST_F(MetricsOfALog, AreComputedUpToACollision) {
  // The radius of 1 m plus that of the column exceed the distance of the path.
  const auto json = metrics("--trajectory log.csv --robot-radius 1");
  EXPECT_EQ(json["outcome"], "collision");
  EXPECT_EQ(value(json, "spl"), 0);
  EXPECT_EQ(json["metrics"]["optimality"]["na"], "outcome: collision");
  EXPECT_NEAR(value(json, "min_clearance"), 0, 1e-6);
  EXPECT_GT(value(json, "impact_speed"), 0);
  EXPECT_LE(value(json, "impact_speed"), 1.01);
  const auto given = metrics("--trajectory log.csv --robot-radius 1 --outcome success");
  EXPECT_EQ(value(given, "success"), 1);
  EXPECT_GT(value(given, "path_length"), 8);
}

/// The same log as `rostopic echo -p` writes it: ns, further columns, the heading as a quaternion.
TEST_F(MetricsOfALog, AreTheSameForColumnsOfRos) {
  std::istringstream tum(read("log.tum"));
  std::string header, csv =
                          "%time,field.header.frame_id,field.pose.pose.position.x,"
                          "field.pose.pose.position.y,field.pose.pose.orientation.z,"
                          "field.pose.pose.orientation.w\n";
  std::getline(tum, header);
  double t, x, y, z, qx, qy, qz, qw;
  while (tum >> t >> x >> y >> z >> qx >> qy >> qz >> qw)
    csv += std::to_string(std::llround(t * 1e9)) + ",odom," + std::to_string(x) + "," +
           std::to_string(y) + "," + std::to_string(qz) + "," + std::to_string(qw) + "\n";
  write("ros.csv", csv);
  const auto expected = metrics("--trajectory log.tum");
  const auto json = metrics("--trajectory ros.csv --columns t=%time*1e-9");
  EXPECT_EQ(json["notes"][0], "1 column not used: field.header.frame_id");
  EXPECT_EQ(json["outcome"], "success");
  for (const char* id : {"path_length", "time_to_goal", "optimality"})
    EXPECT_NEAR(value(json, id), value(expected, id), 1e-6) << id;
  const ProgramResult plain =
      run("slalom-analyze metrics --scenario room.yaml --trajectory ros.csv");
  EXPECT_NE(plain.err.find("is t in nanoseconds instead of s? --columns t=%time*1e-09"),
            std::string::npos)
      << plain.err;
}

TEST_F(MetricsOfALog, UseTheCampaignsRobotAndOptions) {
  write("campaign.ini", std::string(kSmallCampaign) +
                            "[robot]\nmax_v = 2\n[metrics]\nenabled = time_ratio, "
                            "risk_time_ratio\nsafe_distance = 5\n");
  const auto json = metrics("--trajectory log.csv -c campaign.ini");
  EXPECT_EQ(json["metrics"].size(), 2U);
  EXPECT_EQ(value(json, "risk_time_ratio"), 1);
  EXPECT_NEAR(value(json, "time_ratio"), 2 * value(metrics("--trajectory log.csv"), "time_ratio"),
              0.05);
}

TEST_F(MetricsOfALog, ArePrintedAsTextWithNotes) {
  const ProgramResult result =
      run("slalom-analyze metrics --scenario room.yaml --trajectory log.csv");
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out.find("outcome                       success (goal reached at"), 0U);
  EXPECT_NE(result.out.find("impact_speed v1               NA (outcome: success)"),
            std::string::npos);
  EXPECT_NE(result.err.find("log.csv: no command_v and command_w"), std::string::npos);
  EXPECT_EQ(run("slalom-analyze metrics --scenario room.yaml --trajectory log.csv --quiet").err,
            "");
}

TEST_F(MetricsOfALog, RejectInvalidInput) {
  const std::string verb = "slalom-analyze metrics --scenario room.yaml --trajectory ";
  write("bad.csv", "t,x,y,phi\n0,1,3,0\n1,2,three,0\n");
  expect_failure(verb + "bad.csv", 3, {"bad.csv:3", "field 3", "number"});
  expect_failure(verb + "none.csv", 3, {"none.csv"});
  expect_failure(verb + "log.csv --outcome sucess", 2, {"--outcome", "sucess", "success"});
  expect_failure(verb + "log.csv --columns x=z", 3, {"log.csv:1", "no column 'z' for x", "phi"});
  expect_failure(verb + "log.csv --columns x", 2, {"--columns", "NAME=COLUMN"});
  expect_failure(verb + "log.csv --robot-radius 0", 2, {"robot.radius", "> 0"});
  expect_failure(verb + "log.csv --set metrics.safe=1", 2, {"metrics", "safe_distance"});
  expect_failure("slalom-analyze metrics --scenario log.csv --trajectory log.csv", 3, {"log.csv"});
}

TEST_F(MetricsOfALog, OfABagAreThoseOfItsPoses) {
  testing::McapWriter bag;
  for (int i = 0; i <= 40; ++i) {
    const double time = 0.25 * i, y = 3 + 1.2 * std::sin(M_PI * time / 10);
    const auto stamp = std::int64_t(1e9 * time) + 1;
    bag.add({"/pose", "geometry_msgs/PoseStamped", stamp,
             testing::ByteList(testing::Layout::CdrLittle)
                 .header(stamp, "map")
                 .doubles(testing::pose_numbers(1 + 0.8 * time, y, 0))
                 .bytes()});
  }
  write("drive.mcap", bag.bytes());
  const auto json = metrics("--trajectory drive.mcap");
  EXPECT_EQ(json["outcome"], "success");
  EXPECT_EQ(json["notes"][0], "poses of '/pose' in frame 'map'");
  const std::string verb = "slalom-analyze metrics --scenario room.yaml --trajectory ";
  expect_failure(verb + "drive.mcap --topic /odom", 3, {"drive.mcap", "no topic '/odom'"});
  expect_failure(verb + "log.csv --topic /odom", 2, {"--topic", "log.csv is not a bag"});
}

}  // namespace
}  // namespace slalom
