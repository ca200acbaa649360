// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "io_sample.h"

#include <slalom/core/text.h>
#include <slalom/io/result_file.h>
#include <slalom/io/trajectory_file.h>

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

namespace slalom {
namespace {

using namespace std::string_literals;

TrajectoryFile read(const std::string& text, bool sideways = false) {
  return trajectory_from_text(text, "log", sideways);
}

testing::AssertionResult refused_log(const std::string& text, const std::string& where,
                                     std::initializer_list<std::string> words) {
  return throws_error(ErrorKind::File, where, words, [&] { read(text); });
}

TEST(TrajectoryFile, ReadsCsvColumnsInAnyOrder) {
  const TrajectoryFile file = read(
      "# from a robot\n\nphi,t,y,x,command_w,vy,w,v,command_v,command_vy\r\n"
      "0.1,10,2,1,7,5,4,3,6,8\r\n"
      "\n# a remark\n0.2, 11, 2.5, 1.5, 0.7, 0.5, 0.4, 0.3, 0.6, 0.8\n");
  ASSERT_EQ(file.trajectory.samples.size(), 2U);
  Sample first = file.trajectory.samples[0];
  EXPECT_TRUE(std::isnan(first.traveled)) << "not known from a log";
  first.traveled = 0;
  const std::array<double, Sample::kNumbers> expected = {10, 1, 2, 0.1, 3, 4, 6, 7, 5, 8, 0};
  EXPECT_EQ(first.numbers(), expected);
  EXPECT_TRUE(file.notes.empty());
}

TEST(TrajectoryFile, ReportsComputedAndMissingColumns) {
  const std::string csv = "t,x,y,phi\n0,0,0,0\n1,1,0,0\n";
  EXPECT_EQ(read(csv).notes, (std::vector<std::string>{"v and w computed from pose differences",
                                                       "no command_v and command_w"}));
  EXPECT_EQ(read(csv, true).notes[0], "v, w and vy computed from pose differences");
  EXPECT_TRUE(std::isnan(read(csv).trajectory.samples[0].command_v));
  EXPECT_EQ(read("t,x,y,phi,v,command_v,command_w\n0,0,0,0,1,1,0\n1,1,0,0,1,1,0\n").notes,
            (std::vector<std::string>{"w computed from pose differences"}));
}

/// A circle of radius 2 m at increasing speed, with analytically known derivatives.
std::string circle_csv(double direction) {
  std::string csv = "t,x,y,phi\n";
  for (double t = 0; t < 4; t += 0.05) {
    const double angle = 0.3 * t + 0.05 * t * t;  // rad; crosses +-pi as a heading
    csv += format_number(t) + "," + format_number(2 * std::cos(angle)) + "," +
           format_number(2 * std::sin(angle)) + "," +
           format_number(angle + direction + M_PI / 2 + 2 * M_PI) + "\n";
  }
  return csv;
}

TEST(TrajectoryFile, ComputesVelocitiesAlongTheHeading) {
  for (const auto& [direction, sign] : {std::pair(0.0, 1.0), std::pair(M_PI, -1.0)}) {
    const TrajectoryFile file = read(circle_csv(direction));
    for (const Sample& sample : file.trajectory.samples) {
      EXPECT_NEAR(sample.v, sign * 2 * (0.3 + 0.1 * sample.t), 1e-3) << sample.t;
      EXPECT_NEAR(sample.w, 0.3 + 0.1 * sample.t, 1e-6) << sample.t;
      EXPECT_EQ(sample.vy, 0);
    }
  }
}

TEST(TrajectoryFile, ComputesTheLateralVelocityOfAHolonomicRobot) {
  const TrajectoryFile file = read(circle_csv(-M_PI / 2), true);  // heading points outwards
  for (const Sample& sample : file.trajectory.samples) {
    EXPECT_NEAR(sample.v, 0, 3e-3) << sample.t;
    EXPECT_NEAR(sample.vy, 2 * (0.3 + 0.1 * sample.t), 1e-3) << sample.t;
  }
}

TEST(TrajectoryFile, ReadsTheYawOfTumQuaternions) {
  // Rotated by 90 degrees; and by 180 degrees about x, then by -90 degrees about z.
  const double h = std::sqrt(0.5);
  const TrajectoryFile file =
      read("# timestamp tx ty tz qx qy qz qw\n100 1 2 0.3 0 0 " + format_number(h) + " " +
           format_number(h) + "\n101\t1 3 0.3 0 0 1 0\n102 1 4 0.3  " + format_number(h) + " " +
           format_number(-h) + " 0 0\n");
  ASSERT_EQ(file.trajectory.samples.size(), 3U);
  const Sample& first = file.trajectory.samples[0];
  EXPECT_EQ(first.t, 100);
  EXPECT_EQ(first.pose.x, 1);
  EXPECT_EQ(first.pose.y, 2);
  EXPECT_NEAR(first.pose.phi, M_PI / 2, 1e-12);
  EXPECT_NEAR(first.v, 1, 1e-12);
  EXPECT_NEAR(std::abs(file.trajectory.samples[1].pose.phi), M_PI, 1e-12);
  EXPECT_NEAR(file.trajectory.samples[2].pose.phi, -M_PI / 2, 1e-12);
}

TEST(TrajectoryFile, RejectsDamagedCsvWithItsLine) {
  const std::string head = "t,x,y,phi\n0,0,0,0\n";
  EXPECT_TRUE(refused_log(head + "1,1,0\n", "log:3: ", {"3 fields", "expected 4 numbers"}));
  EXPECT_TRUE(refused_log(head + "1,1,0,0,5\n", "log:3: ", {"5 fields", "expected 4 numbers"}));
  EXPECT_TRUE(
      refused_log(head + "1,nan,0,0\n", "log:3: ", {"field 2", "expected a finite number"}));
  EXPECT_TRUE(refused_log(head + "1,1,,0\n", "log:3: ", {"field 3", "expected a finite number"}));
  EXPECT_TRUE(
      refused_log(head + "1,1,1e999,0\n", "log:3: ", {"field 3", "expected a finite number"}));
  EXPECT_TRUE(refused_log(head + "# gap\n-1,1,0,0\n",
                          "log:4: ", {"t = -1", "times that increase", "--to"}));
  EXPECT_TRUE(refused_log(head, "log:2: ", {"1 samples", "at least 2 samples"}));
  EXPECT_TRUE(refused_log(head + "1,1e9,0,0\n", "log:3: ", {"100 km", "meters"}));
}

/// Straight along x with 1 m/s; `rows` follow.
TrajectoryFile drive(double unit, const std::string& rows = "", const LogSpan& span = {}) {
  std::string text = "t,x,y,phi\n";
  for (int i = 0; i < 5; ++i) text += std::to_string(unit * i) + "," + std::to_string(i) + ",0,0\n";
  return trajectory_from_text(text + rows, "log", false, span);
}

std::string notes_of(const TrajectoryFile& file) {
  return join(file.notes, "\n");
}

TEST(TrajectoryFile, LeavesRepeatedTimesOutAndSaysSo) {
  const TrajectoryFile file = drive(1, "4,9,9,0\n4,4,0,0\n5,5,0,0\n");
  EXPECT_EQ(file.trajectory.samples.size(), 6U);
  EXPECT_EQ(file.trajectory.samples[4].pose.x, 4) << "the first of a time counts";
  EXPECT_TRUE(mentions(notes_of(file), {"2 rows left out: the time of the row before"}));
}

TEST(TrajectoryFile, ReadsAPartOfALog) {
  const TrajectoryFile file = drive(1, "", {1, 3});
  EXPECT_EQ(file.trajectory.samples.front().t, 1);
  EXPECT_EQ(file.trajectory.samples.back().t, 3);
  EXPECT_TRUE(mentions(notes_of(file), {"2 rows left out: not from --from to --to"}));
  const TrajectoryFile first = drive(1, "0,0,0,0\n1,7,0,0\n", {0, 4});
  EXPECT_EQ(first.trajectory.samples.size(), 5U);
  EXPECT_TRUE(mentions(notes_of(first), {"2 rows left out: the time goes back"}));
}

TEST(TrajectoryFile, SaysThatTheUnitOfTimeIsImplausible) {
  EXPECT_TRUE(mentions(notes_of(drive(1e8)), {"100000000 s apart", "nanoseconds"}));
  EXPECT_TRUE(mentions(notes_of(drive(1e5)), {"microseconds"}));
  EXPECT_TRUE(mentions(notes_of(drive(100)), {"samples are 100 s apart", "milliseconds"}));
  EXPECT_EQ(notes_of(drive(1)).find("apart"), std::string::npos);
}

TEST(TrajectoryFile, SaysThatADifferentialDriveMovesSideways) {
  const std::string degrees = "t,x,y,phi\n0,0,0,90\n1,0,1,90\n2,0,2,90\n";
  EXPECT_TRUE(mentions(notes_of(trajectory_from_text(degrees, "log", false)),
                       {"moves sideways to phi", "degrees"}));
  EXPECT_EQ(notes_of(trajectory_from_text(degrees, "log", true)).find("degrees"),
            std::string::npos);
  EXPECT_EQ(notes_of(drive(1)).find("degrees"), std::string::npos);
}

TEST(TrajectoryFile, RejectsInvalidHeadersAndSuggestsTheNearestName) {
  EXPECT_TRUE(refused_log("t,x,y,phi,comand_v\n0,0,0,0,0\n1,0,0,0,0\n",
                          "log:1: ", {"'comand_v'", "expected 'command_v'"}));
  EXPECT_TRUE(refused_log("t,x,y,v\n0,0,0,0\n", "log:1: ",
                          {"missing", "'phi'", "expected a header line with t, x, y, phi"}));
  EXPECT_TRUE(refused_log("t,x,y,phi,x\n0,0,0,0,0\n",
                          "log:1: ", {"duplicate", "'x'", "expected each column once"}));
  EXPECT_TRUE(refused_log("0,0,0,0\n", "log:1: ", {"unknown column '0'"}));
  EXPECT_TRUE(refused_log("", "log: ", {"empty"}));
  EXPECT_TRUE(refused_log(std::string(1000, '\0'), "log:1: ", {}));
}

TEST(TrajectoryFile, RejectsDamagedTum) {
  EXPECT_TRUE(refused_log("0 0 0 0 0 0 0 1\n1 0 0 0 0 0 0\n",
                          "log:2: ", {"7 fields", "expected 8 numbers"}));
  EXPECT_TRUE(refused_log("0 0 0 0 0 0 0 1\n1 0 0 0 0 0 1 1\n",
                          "log:2: ", {"1.4142135623730951", "expected a unit quaternion"}));
  EXPECT_TRUE(refused_log("0 0 0 0 0 0 0 0\n1 0 0 0 0 0 0 1\n",
                          "log:1: ", {" 0;", "expected a unit quaternion"}));
}

TEST(TrajectoryFile, ReadsTheCsvOfEuroc) {
  // A header that begins with '#', times in ns, w first in quaternions; ground truths have more
  // columns. Turned by 90 degrees.
  const std::string header = "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w []\n";
  for (const std::string rest : {"", ",7,7,7,7,7,7,7,7,7"}) {
    const TrajectoryFile file =
        read(header + "1403715524907143168,1,2,3,0.70710678,0,0,0.70710678" + rest + "\n" +
             "1403715525007143168,1,2.1,3,0.70710678,0,0,0.70710678" + rest + "\r\n");
    ASSERT_EQ(file.trajectory.samples.size(), 2U);
    const Sample &first = file.trajectory.samples[0], &last = file.trajectory.samples[1];
    EXPECT_NEAR(last.t - first.t, 0.1, 1e-6);
    EXPECT_EQ(first.pose.x, 1);
    EXPECT_EQ(last.pose.y, 2.1);
    EXPECT_NEAR(first.pose.phi, M_PI / 2, 1e-7);
    EXPECT_EQ(file.notes[0], "v and w computed from pose differences");
  }
  EXPECT_TRUE(refused_log(header + "1,0,0\n", "log:2: ", {"3 fields", "expected 8 numbers"}));
}

TEST(TrajectoryFile, ReadsColumnsSeparatedBySemicolonsOrTabs) {
  const auto expected = read("t,x,y,phi\n0,1,2,0.5\n1,1.5,2,0.5\n").trajectory.hash();
  EXPECT_EQ(read("t;x;y;phi\n0;1;2;0.5\n1;1.5;2;0.5\n").trajectory.hash(), expected);
  EXPECT_EQ(read("t\tx\ty\tphi\n0\t1\t2\t0.5\n1\t1.5\t2\t0.5\n").trajectory.hash(), expected);
}

TEST(TrajectoryFile, OfAnUnknownColumnAllNamesAreExpectedWhereNoneIsNear) {
  EXPECT_TRUE(refused_log("t,x,y,z,phi\n", "log:1: ", {"'z'", "names from t, x, y, phi"}));
}

TEST(TrajectoryFile, NamesBagsAndTheirConverter) {
  for (const auto& [content, name] : {std::pair("#ROSBAG V2.0\nE\0\0"s, "ROS 1 (.bag)"),
                                      std::pair("\x89MCAP0\r\n"s, "ROS 2 (.mcap)"),
                                      std::pair("SQLite format 3\0\x10"s, "ROS 2 (.db3)")})
    EXPECT_TRUE(refused_log(content, "log: ", {name, "slalom-analyze metrics"}));
}

TEST(TrajectoryFile, TruncatedFilesAreRejectedOrRead) {
  const std::string csv = circle_csv(0);
  for (std::size_t size = 0; size < csv.size(); size += 13) {
    const std::string text = error_text(ErrorKind::File, [&] { read(csv.substr(0, size)); });
    EXPECT_TRUE(text == "(no error)" || text.compare(0, 3, "log") == 0) << text;
  }
}

TEST(TrajectoryFile, ReportsAMissingFile) {
  const TemporaryFolder folder;
  EXPECT_TRUE(throws_error(ErrorKind::File, folder / "none.csv", {},
                           [&] { load_trajectory_file(folder / "none.csv", false); }));
  write_file_atomically(folder / "log.csv", circle_csv(0));
  EXPECT_EQ(load_trajectory_file(folder / "log.csv", false).trajectory.hash(),
            read(circle_csv(0)).trajectory.hash());
}

}  // namespace
}  // namespace slalom
