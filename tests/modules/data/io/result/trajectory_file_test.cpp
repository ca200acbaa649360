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

TrajectoryFile read(const std::string& text, bool sideways = false,
                    const std::string& columns = "") {
  LogSelection selection;
  selection.columns = columns;
  return trajectory_from_text(text, "log", sideways, selection);
}

testing::AssertionResult refused_log(const std::string& text, const std::string& where,
                                     std::initializer_list<std::string> words,
                                     const std::string& columns = "") {
  return throws_error(ErrorKind::File, where, words, [&] { read(text, false, columns); });
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
  EXPECT_TRUE(refused_log(head + "1,1,,0\n", "log:3: ", {"field 3", "expected a finite number"}));
  EXPECT_TRUE(
      refused_log(head + "1,1,1e999,0\n", "log:3: ", {"field 3", "expected a finite number"}));
  EXPECT_TRUE(refused_log(head + "# gap\n-1,1,0,0\n",
                          "log:4: ", {"t = -1", "times that increase", "--to"}));
  EXPECT_TRUE(refused_log(head, "log:2: ", {"1 sample;", "at least 2 samples"}));
  EXPECT_TRUE(refused_log(head + "1,1e9,0,0\n", "log:3: ", {"100 km", "meters"}));
}

/// Straight along x with 1 m/s; `rows` follow.
TrajectoryFile drive(double unit, const std::string& rows = "", const LogSelection& span = {}) {
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
  EXPECT_TRUE(
      mentions(notes_of(file), {"2 rows left out: the time of the row before (first in line 7)"}));
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
  EXPECT_TRUE(
      mentions(notes_of(drive(1e8)), {"100000000 s apart", "nanoseconds", "--columns t=t*1e-09"}));
  EXPECT_TRUE(mentions(notes_of(drive(1e5)), {"microseconds"}));
  EXPECT_TRUE(mentions(notes_of(drive(100)), {"samples are 100 s apart", "milliseconds"}));
  EXPECT_EQ(notes_of(drive(1)).find("apart"), std::string::npos);
}

TEST(TrajectoryFile, SaysThatADifferentialDriveMovesSideways) {
  const std::string degrees = "t,x,y,phi\n0,0,0,20\n1,-1,2,20\n2,-2,4,20\n";
  EXPECT_TRUE(mentions(notes_of(trajectory_from_text(degrees, "log", false)),
                       {"moves sideways to phi", "degrees", "--columns phi=phi*0.017"}));
  EXPECT_EQ(notes_of(trajectory_from_text(degrees, "log", true)).find("degrees"),
            std::string::npos);
  EXPECT_EQ(notes_of(drive(1)).find("degrees"), std::string::npos);
}

TEST(TrajectoryFile, RejectsInvalidHeadersAndSuggestsTheNearestName) {
  EXPECT_TRUE(refused_log(
      "t,x,v\n0,0,0\n", "log:1: ",
      {"missing column 'y'", "a header line with t, x, y", "--columns y=COLUMN, one of t, x, v"}));
  EXPECT_TRUE(refused_log("t,x,y,phi,x\n0,0,0,0,0\n", "log:1: ",
                          {"duplicate column of x: 'x', 'x'", "expected each column once"}));
  EXPECT_TRUE(refused_log("t,/a/position/x,/b/position/x,y\n0,0,0,0\n",
                          "log:1: ", {"'/a/position/x', '/b/position/x'", "--columns x=COLUMN"}));
  EXPECT_TRUE(refused_log("0,0,0,0\n", "log:1: ", {"no header line before 4 fields", "TUM"}));
  EXPECT_TRUE(refused_log("0 0 0 0 0\n", "log:1: ", {"no header line before 5 fields"}));
  EXPECT_TRUE(refused_log("", "log: ", {"empty"}));
  EXPECT_TRUE(refused_log(std::string(1000, '\0'), "log: ", {"has an unknown format"}));
}

TEST(TrajectoryFile, TwoColumnsOfOneNameAreRefusedHoweverTheyAreNamed) {
  // Rotation and position of a motion capture system.
  const std::string text = "Time,X,Y,X,Y\n0,0,0,1000,2000\n1,0,0,1500,2000\n";
  LogSelection selection;
  for (const char* columns : {"t=Time,x=X*0.001,y=Y*0.001", "x=x*0.001"}) {
    selection.columns = columns;
    EXPECT_TRUE(throws_error(ErrorKind::File,
                             "log:1: ", {"columns 2 and 4 are both named 'X'", "a name of its own"},
                             [&] { trajectory_from_text(text, "log", false, selection); }))
        << columns;
  }
  selection.columns = "x=px";
  EXPECT_EQ(
      trajectory_from_text("t,px,y,note,note\n0,0,0,a,b\n1,1,0,a,b\n", "log", false, selection)
          .trajectory.samples.size(),
      2U)
      << "of columns that are not used";
}

TEST(TrajectoryFile, AHeaderBehindAHashIsThatOfTheColumnsOption) {
  LogSelection selection;
  selection.columns = "t=s_m,x=x_m*2,y=y_m";
  for (const char* hash : {"# ", "#", ""}) {
    const TrajectoryFile file = trajectory_from_text(
        std::string(hash) + "s_m; x_m; y_m\n0;1;2\n1;1.5;2\n", "log", false, selection);
    ASSERT_EQ(file.trajectory.samples.size(), 2U) << hash;
    EXPECT_EQ(file.trajectory.samples[1].pose.x, 3) << hash;
  }
  selection.columns = "t=s_m,x=x_m,y=z_m";
  EXPECT_TRUE(throws_error(ErrorKind::File, "log:2: ", {"no header line before 3 fields"}, [&] {
    trajectory_from_text("# s_m; x_m; y_m\n0;1;2\n", "log", false, selection);
  }));
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
  // Times in ns, with and without their unit; w first in quaternions; ground truths have more
  // columns. Turned by 90 degrees.
  const std::string pose =
      ",p_RS_R_x [m], p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []";
  for (const std::string time : {"#timestamp", "#timestamp [ns]", "# timestamp[ns]"})
    for (const bool more : {false, true}) {
      const std::string rest = more ? ",7,7" : "";
      const TrajectoryFile file =
          read(time + pose + (more ? ",v_RS_R_x [m s^-1],b_w_RS_S_x [rad s^-1]" : "") +
               "\n1403715524907143168,1,2,3,0.70710678,0,0,0.70710678" + rest +
               "\n1403715525007143168,1,2.1,3,0.70710678,0,0,0.70710678" + rest + "\r\n");
      ASSERT_EQ(file.trajectory.samples.size(), 2U);
      const Sample &first = file.trajectory.samples[0], &last = file.trajectory.samples[1];
      EXPECT_NEAR(last.t - first.t, 0.1, 1e-6);
      EXPECT_EQ(first.pose.x, 1);
      EXPECT_EQ(last.pose.y, 2.1);
      EXPECT_NEAR(first.pose.phi, M_PI / 2, 1e-7);
      EXPECT_EQ(file.notes[0],
                more ? "3 columns not used: p_RS_R_z [m], v_RS_R_x [m s^-1], b_w_RS_S_x [rad s^-1]"
                     : "1 column not used: p_RS_R_z [m]");
    }
  EXPECT_TRUE(refused_log("#timestamp [ns]" + pose + "\n1,0,0,0,1,0,0,0\n2,0,0\n",
                          "log:3: ", {"3 fields", "expected 8 numbers"}));
}

TEST(TrajectoryFile, SeparatorsAreDetectedFromTheHeader) {
  const auto expected = read("t,x,y,phi\n0,1,2,0.5\n1,1.5,2,0.5\n").trajectory.hash();
  EXPECT_EQ(read("t;x;y;phi\n0;1;2;0.5\n1;1.5;2;0.5\n").trajectory.hash(), expected);
  EXPECT_EQ(read("t\tx\ty\tphi\n0\t1\t2\t0.5\n1\t1.5\t2\t0.5\n").trajectory.hash(), expected);
  EXPECT_EQ(read("t  x y phi\n0 1  2 0.5\n1 1.5 2 0.5\n").trajectory.hash(), expected);
  EXPECT_EQ(read("# t x y phi\n0 1 2 0.5\n1\t1.5\t2\t0.5\n").trajectory.hash(), expected);
}

/// The first of two samples with t, x, y and a further column.
Sample sample_with(const std::string& column, const std::string& value) {
  return read("t,x,y," + column + "\n0,1,2," + value + "\n1,1.5,2," + value + "\n")
      .trajectory.samples[0];
}

TEST(TrajectoryFile, KnowsTheUsualNamesOfColumnsInAnyCase) {
  const auto expected = read("t,x,y,phi\n0,1,2,0.5\n1,1.5,2,0.5\n").trajectory.hash();
  for (const std::string header :
       {"Time,X,Y,Theta", "timestamp,tx,ty,yaw", "stamp,pose_x,pose_y,heading",
        "%time,field.x,field.y,field.theta", "__time,/odom/position/x,/odom/position/y,yaw [rad]",
        "field.header.stamp,field.pose.pose.position.x,field.pose.pose.position.y,PHI"}) {
    const TrajectoryFile file = read(header + "\n0,1,2,0.5\n1,1.5,2,0.5\n");
    EXPECT_EQ(file.trajectory.hash(), expected) << header;
    EXPECT_EQ(notes_of(file).find("not used"), std::string::npos) << header;
  }
  for (const std::string name : {"vx", "field.twist.twist.linear.x", "Linear_X"})
    EXPECT_EQ(sample_with(name, "0.25").v, 0.25) << name;
  for (const std::string name : {"wz", "omega", "/odom/twist/twist/angular/z"})
    EXPECT_EQ(sample_with(name, "0.25").w, 0.25) << name;
  for (const std::string name : {"cmd_v", "/cmd_vel/linear/x"})
    EXPECT_EQ(sample_with(name, "0.25").command_v, 0.25) << name;
}

TEST(TrajectoryFile, OfSeveralNamesForAQuantityTheFirstOfTheTableCounts) {
  const TrajectoryFile file = read("field.header.stamp,%time,x,y,phi\n7,0,1,2,0\n7,1,2,2,0\n");
  EXPECT_EQ(file.trajectory.samples[1].t, 1);
  EXPECT_EQ(file.notes[0], "1 column not used: field.header.stamp");
}

TEST(TrajectoryFile, UnitsInBracketsAreThoseOfTheColumn) {
  const TrajectoryFile file =
      read("time [ms],x (mm),y [m],yaw [deg]\n0,1000,2,90\n500,1000,2.5,90\n");
  const Sample& last = file.trajectory.samples[1];
  EXPECT_EQ(last.t, 0.5);
  EXPECT_EQ(last.pose.x, 1);
  EXPECT_EQ(last.pose.y, 2.5);
  EXPECT_NEAR(last.pose.phi, M_PI / 2, 1e-15);
}

TEST(TrajectoryFile, ReadsTheHeadingOfQuaternionsUnlessThereIsPhi) {
  // Turned by 60 degrees: qz = sin(30 deg), qw = cos(30 deg).
  const std::string qw = format_number(std::sqrt(3.0) / 2);
  const auto heading = [](const TrajectoryFile& file) {
    return file.trajectory.samples[0].pose.phi;
  };
  const TrajectoryFile two = read("t,x,y,qz,qw\n0,0,0,0.5," + qw + "\n1,1,0,0.5," + qw + "\n");
  EXPECT_NEAR(heading(two), M_PI / 3, 1e-15);
  const TrajectoryFile four =
      read("t,x,y,qw,qx,qy,qz\n0,0,0," + qw + ",0,0,0.5\n1,1,0," + qw + ",0,0,0.5\n");
  EXPECT_NEAR(heading(four), M_PI / 3, 1e-15);
  const TrajectoryFile both =
      read("t,x,y,phi,qz,qw\n0,0,0,0.1,0.5," + qw + "\n1,1,0,0.1,0.5," + qw + "\n");
  EXPECT_EQ(heading(both), 0.1);
  EXPECT_EQ(both.notes[0], "2 columns not used: qz, qw");
  EXPECT_TRUE(refused_log("t,x,y,qz,qw\n0,0,0,1,1\n", "log:2: ", {"unit quaternion"}));
}

TEST(TrajectoryFile, ColumnsThatAreNotUsedMayContainTextAndAreNamed) {
  const std::string rows = "\n0,odom,0,0,0,,-\n1,odom,1,0,0,,-\n";
  EXPECT_EQ(read("t,frame,x,y,phi,b,c" + rows).notes[0], "3 columns not used: frame, b, c");
  EXPECT_EQ(read("t,x,y,phi,a,b,c,d,e,f,comand_v\n0,0,0,0,1,1,1,1,1,1,1\n1,1,0,0,1,1,1,1,1,1,1\n")
                .notes[0],
            "7 columns not used: a, b, c, d, e and 2 others");
}

TEST(TrajectoryFile, ColumnsAreChosenWithFactors) {
  const std::string log =
      "%time,field.header.seq,pose.x,pose.y,a*b,deg\n1000000000,7,9,2,100,90\n"
      "1500000000,8,9,2,150,90\n";
  const TrajectoryFile file =
      read(log, false, "t=%time*1e-9, x=a*b*0.01,phi=DEG*0.017453292519943295");
  const Sample &first = file.trajectory.samples[0], &last = file.trajectory.samples[1];
  EXPECT_NEAR(first.t, 1, 1e-12);
  EXPECT_NEAR(last.t, 1.5, 1e-12);
  EXPECT_NEAR(first.pose.x, 1, 1e-12);
  EXPECT_EQ(first.pose.y, 2) << "by its usual name";
  EXPECT_NEAR(last.pose.phi, M_PI / 2, 1e-12);
  EXPECT_EQ(file.notes[0], "2 columns not used: field.header.seq, pose.x");
  EXPECT_NEAR(
      read("time [ms],x,y\n0,1,2\n500,1,3\n", false, "t=time [ms]*1").trajectory.samples[1].t, 500,
      1e-9)
      << "a factor takes the place of the unit";
  EXPECT_NEAR(read("0 1 2 3 0 0 0 1\n5000 1 3 3 0 0 0 1\n", false, "t=t*1e-3,y=z")
                  .trajectory.samples[1]
                  .pose.y,
              3, 0)
      << "the names of logs without header";
}

TEST(TrajectoryFile, RejectsColumnsThatAreNotThere) {
  const std::string log = "stamp,pos_east,pos_north\n0,1,2\n1,2,2\n";
  EXPECT_TRUE(refused_log(log, "log:1: ", {"no column 'pos_eest' for x", "expected 'pos_east'"},
                          "x=pos_eest"));
  EXPECT_TRUE(
      refused_log(log, "log:1: ", {"no column 'q' for x", "stamp, pos_east, pos_north"}, "x=q"));
  EXPECT_TRUE(refused_log(log, "log:1: ", {"missing column 'y'"}, "x=pos_east"));
  const auto refused_option = [&](const std::string& columns,
                                  std::initializer_list<std::string> words) {
    return throws_error(ErrorKind::Usage, "--columns: ", words, [&] { read(log, false, columns); });
  };
  EXPECT_TRUE(refused_option("x", {"no '=' in 'x'", "NAME=COLUMN*FACTOR"}));
  EXPECT_TRUE(refused_option("comand_v=stamp", {"'comand_v'", "'command_v'"}));
  EXPECT_TRUE(refused_option("x=pos_east*a", {"factor", "other than 0"}));
  EXPECT_TRUE(refused_option("x=pos_east*0", {"factor", "other than 0"}));
  EXPECT_TRUE(refused_option("x=pos_east,x=pos_north", {"two columns of 'x'"}));
}

TEST(TrajectoryFile, ComputesMissingHeadingsFromTheMotion) {
  // At rest with noise of 0.5 mm, along y, along -x, at rest.
  const TrajectoryFile file = read("t,x,y\n0,1,1\n1,1,1.0005\n2,1,2\n3,0,2\n4,0,2\n5,0,2.0005\n");
  const auto& samples = file.trajectory.samples;
  EXPECT_NEAR(samples[0].pose.phi, M_PI / 2, 1e-12);
  EXPECT_NEAR(samples[1].pose.phi, M_PI / 2, 1e-12);
  for (std::size_t i = 2; i < samples.size(); ++i)
    EXPECT_NEAR(std::abs(samples[i].pose.phi), M_PI, 1e-12) << i;
  EXPECT_EQ(file.notes[0], "phi computed from the direction of motion");
  EXPECT_EQ(read("t,x,y\n0,1,1\n1,1,1\n").trajectory.samples[0].pose.phi, 0) << "without motion";
}

TEST(TrajectoryFile, SaysThatTheUnitOfHeadingsIsImplausible) {
  const std::string degrees = "t,x,y,yaw\n0,0,0,90\n1,0,1,90\n2,0,2,90\n";
  for (const bool sideways : {false, true}) {
    const TrajectoryFile file = read(degrees, sideways);
    EXPECT_TRUE(mentions(notes_of(file), {"phi is up to 90 rad", "degrees",
                                          "--columns phi=yaw*0.017453292519943295"}));
    EXPECT_NEAR(file.trajectory.samples[0].pose.phi, 90 - 28 * M_PI, 1e-12) << "is not changed";
  }
  EXPECT_EQ(notes_of(read(degrees, false, "phi=yaw*0.017453292519943295")).find("degrees"),
            std::string::npos);
  EXPECT_EQ(notes_of(read("t,x,y,phi\n0,0,0,0\n1,1,0,25\n", true)).find("degrees"),
            std::string::npos)
      << "a robot may turn four times";
}

TEST(TrajectoryFile, ReadsLinesOfNumbersOfMrpt) {
  const TrajectoryFile four = read("0 1 2 0.5\n1 1.5 2 0.5\n");
  EXPECT_EQ(four.trajectory.hash(), read("t,x,y,phi\n0,1,2,0.5\n1,1.5,2,0.5\n").trajectory.hash());
  EXPECT_EQ(four.notes[0], "no header line: read as t x y phi");
  const TrajectoryFile seven = read("0 1 2 9 0.5 8 8\n1 1.5 2 9 0.5 8 8\n");
  EXPECT_EQ(seven.trajectory.hash(), four.trajectory.hash());
  EXPECT_EQ(seven.notes[0], "no header line: read as t x y z yaw pitch roll");
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

TEST(TrajectoryFile, PosesOfKittiAreThoseOfACameraAtAConstantRate) {
  // Forward 2 m at 10 Hz; then a turn to the left by 90 degrees about the camera's y axis, which
  // points down: the optical axis becomes -x of the first camera.
  const std::string poses =
      "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1 2\n0 0 -1 -3 0 1 0 0 1 0 0 2\n";
  LogSelection selection;
  selection.rate = 10;
  const TrajectoryFile file = trajectory_from_text(poses, "log", false, selection);
  ASSERT_EQ(file.trajectory.samples.size(), 3u);
  const Sample& last = file.trajectory.samples[2];
  EXPECT_DOUBLE_EQ(last.t, 0.2);
  EXPECT_EQ(file.trajectory.samples[1].pose.x, 2);
  EXPECT_EQ(last.pose.x, 2);
  EXPECT_EQ(last.pose.y, 3) << "to the left";
  EXPECT_NEAR(last.pose.phi, M_PI / 2, 1e-12);
  EXPECT_TRUE(mentions(notes_of(file), {"poses of KITTI", "10 Hz"}));
  EXPECT_TRUE(refused_log(poses, "log:1: ", {"without times (KITTI)", "--rate HZ"}));
  EXPECT_TRUE(throws_error(ErrorKind::File, "log:2", {"3 fields", "12 numbers"}, [&] {
    trajectory_from_text("1 0 0 0 0 1 0 0 0 0 1 0\n1 2 3\n", "log", false, selection);
  }));
  EXPECT_TRUE(throws_error(ErrorKind::File, "log:1", {"looks up or down"}, [&] {
    trajectory_from_text("1 0 0 0 0 0 1 0 0 1 0 0\n", "log", false, selection);
  }));
  selection.columns = "t=a";
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "--columns", {"poses of KITTI"},
                           [&] { trajectory_from_text(poses, "log", false, selection); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "--rate", {"has times"}, [&] {
    trajectory_from_text("t,x,y\n0,0,0\n1,1,1\n", "log", false, selection);
  }));
}

TEST(TrajectoryFile, PosesOfMrptWithoutTimesAreAtAConstantRate) {
  const std::string poses =
      "% Columns are: x(m) y(m) z(m) yaw(rad) pitch(rad) roll(rad)\n% by MRPT\n\n%-----\n"
      "1 2 0.5 0.1 0 0\n1.5 2 0.5 0.2 0 0\n";
  LogSelection selection;
  selection.rate = 2;
  const TrajectoryFile file = trajectory_from_text(poses, "log", false, selection);
  ASSERT_EQ(file.trajectory.samples.size(), 2u);
  EXPECT_EQ(file.trajectory.samples[1].t, 0.5);
  EXPECT_EQ(file.trajectory.samples[1].pose, mrpt::math::TPose2D(1.5, 2, 0.2));
  EXPECT_TRUE(mentions(notes_of(file), {"poses of MRPT", "x y z yaw pitch roll", "2 Hz"}));
  EXPECT_TRUE(refused_log(poses, "log:5: ", {"without times (MRPT)", "--rate HZ"}));
  EXPECT_TRUE(refused_log("% nothing else\n", "log: ", {"only comments"}));
}

/// A header tells logs with times from poses without, which have as many numbers.
TEST(TrajectoryFile, ALogWithTimesMayHaveSixOrTwelveColumns) {
  const std::string six = read("# t x y phi v w\n0 0 0 0 1 0\n1 1 0 0 1 0\n").trajectory.hash();
  EXPECT_EQ(read("t,x,y,phi,v,w\n0,0,0,0,1,0\n1,1,0,0,1,0\n").trajectory.hash(), six);
  EXPECT_EQ(read("# t x y phi v w a b c d e f\n0 0 0 0 1 0 1 1 1 1 1 1\n1 1 0 0 1 0 1 1 1 1 1 1\n")
                .trajectory.hash(),
            six);
}

TEST(TrajectoryFile, LeavesRowsOfALostRobotOut) {
  const std::string rows = "0 0 0 0 0 0 0 1\n1 nan nan nan nan nan nan nan\n";
  const TrajectoryFile tum = read(rows + "2 1 0 0 0 0 0 1\n3 NaN NaN NaN NaN NaN NaN NaN\n");
  ASSERT_EQ(tum.trajectory.samples.size(), 2u);
  EXPECT_EQ(tum.trajectory.samples[1].t, 2);
  EXPECT_TRUE(mentions(notes_of(tum), {"2 rows left out: nan (first in line 2)"}));
  // A command that is missing in one row only.
  const TrajectoryFile csv = read("t,x,y,phi,command_v\n0,0,0,0,0.5\n1,0.5,0,0,nan\n2,1,0,0,0.4\n");
  ASSERT_EQ(csv.trajectory.samples.size(), 3u);
  EXPECT_TRUE(std::isnan(csv.trajectory.samples[1].command_v));
  EXPECT_TRUE(refused_log(rows, "log:2: ", {"only 1 sample;"}));
}

TEST(TrajectoryFile, ReportsAMissingFile) {
  const TemporaryFolder folder;
  EXPECT_TRUE(throws_error(ErrorKind::File, folder / "none.csv", {},
                           [&] { load_trajectory_file(folder / "none.csv", false); }));
  write_file_atomically(folder / "log.csv", circle_csv(0));
  EXPECT_EQ(load_trajectory_file(folder / "log.csv", false).trajectory.hash(),
            read(circle_csv(0)).trajectory.hash());
}

/// An Odometry as `ros2 topic echo --csv` prints it: 89 fields.
std::string echoed_odometry(const std::string& sec, const std::string& nanosec, double x, double v,
                            double w) {
  const std::string zeros = [] {
    std::string text;
    for (int i = 0; i < 36; ++i) text += ",0.0";
    return text;
  }();
  return sec + "," + nanosec + ",odom,base_link," + format_number(x) + ",2.0,0.0,0.0,0.0,0.6,0.8" +
         zeros + "," + format_number(v) + ",0.1,0.0,0.0,0.0," + format_number(w) + zeros + "\n";
}

TEST(TrajectoryFile, ReadsMessagesThatRos2TopicEchoPrintsWithoutNames) {
  const std::string odometry = echoed_odometry("100", "250000000", 1, 0.5, 0.2) +
                               echoed_odometry("100", "750000000", 1.25, 0.6, 0.3);
  const TrajectoryFile file = read(odometry, true);
  ASSERT_EQ(file.trajectory.samples.size(), 2U);
  const Sample& second = file.trajectory.samples[1];
  EXPECT_DOUBLE_EQ(second.t, 100.75);
  EXPECT_EQ(second.pose.x, 1.25);
  EXPECT_EQ(second.pose.y, 2);
  EXPECT_NEAR(second.pose.phi, 2 * std::atan2(0.6, 0.8), 1e-15);
  EXPECT_EQ(second.v, 0.6);
  EXPECT_EQ(second.vy, 0.1);
  EXPECT_EQ(second.w, 0.3);
  EXPECT_EQ(file.notes[0], "read as Odometry of ros2 topic echo --csv");

  const std::string pose = "7,500000000,map,1.0,2.0,0.0,0.0,0.0,0.0,1.0\n";
  const std::string estimate =
      pose.substr(0, pose.size() - 1) +
      odometry.substr(odometry.find(",0.0,0.0,0.0,0.0,0.0,0.0,0.0"), std::size_t{36} * 4) + "\n";
  for (const std::string& line : {pose, estimate}) {
    const Trajectory read_poses = read(line + "8" + line.substr(1)).trajectory;
    EXPECT_EQ(read_poses.samples[0].t, 7.5) << line;
    EXPECT_EQ(read_poses.samples[1].t, 8.5);
    EXPECT_EQ(read_poses.samples[0].pose.x, 1);
    EXPECT_EQ(read_poses.samples[0].pose.phi, 0);
  }
}

TEST(TrajectoryFile, ScalesTheTimeOfAMessageIfItIsAsked) {
  const std::string pose = ",500000000,map,1.0,2.0,0.0,0.0,0.0,0.0,1.0\n";
  const auto samples =
      read("7" + pose + "9" + pose, false, "t=header.stamp.sec*2").trajectory.samples;
  EXPECT_EQ(samples[0].t, 14);
  EXPECT_EQ(samples[1].t, 18);
}

TEST(TrajectoryFile, NamesTheMessagesThatItReadsWhereOneHasNoPose) {
  const std::string twist = "7,500000000,base_link,0.1,0.0,0.0,0.0,0.0,0.2\n";
  EXPECT_TRUE(refused_log(twist, "log:1: ", {"no header line before 9 fields", "Odometry (89)"}));
}

std::string echoed_pose(const std::string& sec, double x, const std::string& more = "") {
  return "header:\n  stamp:\n    sec: " + sec +
         "\n    nanosec: 500000000\n  frame_id: map\npose:\n  pose:\n    position:\n      x: " +
         format_number(x) +
         "\n      y: 2.0\n      z: 0.0\n    orientation:\n      x: 0.0\n      y: 0.0\n      z: "
         "1.0\n "
         "     w: 0.0\n  covariance:\n  - 0.1\n  - '...'\n" +
         more + "---\n";
}

TEST(TrajectoryFile, ReadsTheYamlThatTopicEchoPrints) {
  const Trajectory poses = read(echoed_pose("7", 1) + echoed_pose("8", 0.5)).trajectory;
  ASSERT_EQ(poses.samples.size(), 2U);
  EXPECT_EQ(poses.samples[1].t, 8.5);
  EXPECT_EQ(poses.samples[1].pose.x, 0.5);
  EXPECT_NEAR(std::abs(poses.samples[1].pose.phi), M_PI, 1e-15);
  EXPECT_EQ(poses.samples[1].v, 0.5) << "computed from the poses";

  const std::string twist =
      "twist:\n  twist:\n    linear:\n      x: 0.7\n      y: 0.1\n      z: 0.0\n"
      "    angular:\n      x: 0.0\n      y: 0.0\n      z: 0.3\n";
  const Sample sample =
      read(echoed_pose("7", 1, twist) + echoed_pose("8", 0.5, twist), true).trajectory.samples[0];
  EXPECT_EQ(sample.v, 0.7);
  EXPECT_EQ(sample.vy, 0.1);
  EXPECT_EQ(sample.w, 0.3);

  const std::string of_ros1 =
      "header:\n  stamp:\n    secs: 3\n    nsecs: 250000000\n"
      "pose: {position: {x: 1, y: 2}, orientation: {x: 0, y: 0, z: 0, w: 1}}\n";
  EXPECT_EQ(read(of_ros1 + "---\n" + echoed_pose("8", 1)).trajectory.samples[0].t, 3.25);
}

TEST(TrajectoryFile, LeavesOutAnEchoedMessageThatWasCutOff) {
  const std::string cut = echoed_pose("9", 2).substr(0, 90);
  EXPECT_EQ(read(echoed_pose("7", 1) + echoed_pose("8", 1) + cut).trajectory.samples.size(), 2U);
  EXPECT_TRUE(refused_log(echoed_pose("7", 1) + cut + "---\n" + echoed_pose("8", 1), "log",
                          {"message 2 has no time and pose", "Odometry"}));
  // Digits that are missing would be another pose.
  std::string digits = echoed_pose("9", 2);
  digits.erase(digits.find("w: 0.0") + 4);
  EXPECT_EQ(read(echoed_pose("7", 1) + echoed_pose("8", 1) + digits).trajectory.samples.size(), 2U);
  EXPECT_TRUE(refused_log("header:\n  stamp: [[\n", "log", {"message 1"}));
  EXPECT_TRUE(refused_log(echoed_pose("7", 1), "log (messages):", {"only 1 sample;"}));
}

}  // namespace
}  // namespace slalom
