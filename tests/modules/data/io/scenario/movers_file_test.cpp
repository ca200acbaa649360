// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/core/error.h>
#include <slalom/io/movers_file.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

testing::AssertionResult refuses(const std::string& text, const std::string& message,
                                 const MoversFileOptions& options = {}) {
  return throws_error(ErrorKind::File, message, {}, [&] { movers_from_text(text, "f", options); });
}

TEST(MoversFile, HasAMoverForEachIdInTheOrderOfTheFile) {
  const Movers movers = movers_from_text(
      "# recorded by hand\n\nid, t, x, y, r\nb,0,1,2,0.25\na,0.5,5,5,0.4\nb,2,3,2,0.25\n", "f");
  ASSERT_EQ(movers.size(), 2U);
  const Mover b = {"b", 0.25, {{0, {1, 2}}, {2, {3, 2}}}, MoverEnd::Vanish};
  const Mover a = {"a", 0.4, {{0.5, {5, 5}}}, MoverEnd::Vanish};
  EXPECT_EQ(movers[0], b);
  EXPECT_EQ(movers[1], a);
}

TEST(MoversFile, ColumnsMayBeInAnyOrderAndTheRadiusMissing) {
  MoversFileOptions options;
  options.radius = 0.2;
  const Movers movers = movers_from_text("y,x,t,id\n2,1,0,7\n2,4,3,7\n", "f", options);
  const Mover expected = {"7", 0.2, {{0, {1, 2}}, {3, {4, 2}}}, MoverEnd::Vanish};
  EXPECT_EQ(movers, Movers{expected});
}

TEST(MoversFile, TheRunBeginsAtTheGivenTimeOfTheFile) {
  MoversFileOptions options;
  options.begin = 11;
  const Movers movers = movers_from_text(
      "id,t,x,y\ngone,1,0,0\nhere,9,0,0\nhere,10,1,0\nhere,12,3,0\nlater,14,5,5\non_time,10,0,1\n"
      "on_time,11,2,1\non_time,12,3,1\n",
      "f", options);
  ASSERT_EQ(movers.size(), 3U);
  // Halfway between (1, 0) at 10 s and (3, 0) at 12 s.
  EXPECT_EQ(movers[0].waypoints[0].position, TPoint2D(2, 0));
  EXPECT_EQ(movers[0].waypoints[0].t, 0);
  EXPECT_EQ(movers[0].waypoints[1].t, 1);
  EXPECT_EQ(movers[1].waypoints[0].t, 3);
  EXPECT_EQ(movers[2].waypoints.size(), 2U);
  EXPECT_EQ(movers[2].waypoints[0].position, TPoint2D(2, 1));
}

TEST(MoversFile, FramesOfObsmatAreTimesByTheFrameRate) {
  MoversFileOptions options;
  options.frame_rate = 15;
  const Movers movers = movers_from_text(
      "  7.8e+02 1.0e+00 8.5e+00 0 3.6e+00 1.7 0 0.1\n 7.86e+02 1 9.1 0 3.7 1.7 0 0.1\n", "f",
      options);
  ASSERT_EQ(movers.size(), 1U);
  EXPECT_EQ(movers[0].id, "1");
  EXPECT_EQ(movers[0].radius, 0.3);
  EXPECT_DOUBLE_EQ(movers[0].waypoints[0].t, 52);
  EXPECT_DOUBLE_EQ(movers[0].waypoints[1].t, 52.4);
  EXPECT_EQ(movers[0].waypoints[1].position, TPoint2D(9.1, 3.7));
}

TEST(MoversFile, FramesOfPredictionBenchmarksAreTimesByTheFrameRate) {
  MoversFileOptions options;
  options.frame_rate = 25;
  const Movers expected = {{"3", 0.3, {{0.4, {1, 2}}, {0.8, {1.5, 2}}}, MoverEnd::Vanish},
                           {"4", 0.3, {{0.8, {7, 8}}}, MoverEnd::Vanish}};
  EXPECT_EQ(movers_from_text("10.0\t3.0\t1\t2\n20\t3\t1.5\t2\n20\t4\t7\t8\n", "f", options),
            expected);
  EXPECT_EQ(movers_from_text("10 3 1 2\n20 3 1.5 2\n20 4 7 8\n", "f", options), expected);
  EXPECT_EQ(movers_from_text("frame,id,x,y\n10,3,1,2\n20,3,1.5,2\n20,4,7,8\n", "f", options),
            expected);
  EXPECT_EQ(movers_from_text("frame,id,x,y,type\n10,3,1,2,ped\n20,3,1.5,2,ped\n20,4,7,8,ped\n", "f",
                             options),
            expected);
}

TEST(MoversFile, ALineOfNamesStatesTheOrderOfItsFields) {
  // Two persons of 1 m/s at 10 frames per second, as JuPedSim and PedPy write them.
  MoversFileOptions options;
  options.frame_rate = 10;
  const Movers expected = {{"1", 0.3, {{0.5, {0, 2}}, {0.6, {0.1, 2}}}, MoverEnd::Vanish},
                           {"2", 0.3, {{0.5, {7, 8}}, {0.6, {7.1, 8}}}, MoverEnd::Vanish}};
  for (const char* text :
       {"# framerate: 10\n# PersID\tFrame\tx/m\ty/m\n1 5 0 2\n1 6 0.1 2\n2 5 7 8\n2 6 7.1 8\n",
        "# id frame x y z\n1 5 0 2 1.7\n1 6 0.1 2 1.7\n2 5 7 8 1.6\n2 6 7.1 8 1.6\n",
        "#ID FR X Y Z A\n1 5 0 2 0 9\n1 6 0.1 2 0 9\n2 5 7 8 0 9\n2 6 7.1 8 0 9\n",
        "# id frame x y\n1 5 0 2 1.7\n1 6 0.1 2 1.7\n2 5 7 8 1.6\n2 6 7.1 8 1.6\n",
        "# id frame x [m] y [m]\n1 5 0 2\n1 6 0.1 2\n2 5 7 8\n2 6 7.1 8\n",
        "PersID Frame x y\n1 5 0 2\n1 6 0.1 2\n2 5 7 8\n2 6 7.1 8\n",
        "# frame id x y\n5 1 0 2\n5 2 7 8\n6 1 0.1 2\n6 2 7.1 8\n",
        "# id,frame,x/mm,y/mm\n1,5,0,2000\n1,6,100,2000\n2,5,7000,8000\n2,6,7100,8000\n"})
    EXPECT_EQ(movers_from_text(text, "f", options), expected) << text;
  EXPECT_TRUE(refuses("# id frame x/ft y/ft\n1 5 0 2\n", "f:2: unknown unit of x and y", options));
  EXPECT_TRUE(refuses("# id frame x y x\n1 5 0 2 3\n", "f:2: two columns of 'x'", options));
  EXPECT_TRUE(refuses("# id frame x y z\n1 5 0 2\n",
                      "f:2: 4 fields; expected 5 as the line of names has", options));
}

TEST(MoversFile, LinesInTheOppositeOrderAreRefusedWithTheLineThatNamesIt) {
  MoversFileOptions options;
  options.frame_rate = 10;
  // One person after the other: each "id" is a frame, with one position.
  EXPECT_TRUE(refuses("1 5 0 2\n1 6 0.1 2\n2 7 4 2\n2 8 4.1 2\n",
                      "f: each id has one position only; expected lines of frame id x y, or a line "
                      "'# id frame x y'",
                      options));
  // Two persons at the same time, 0.4 m apart: within the speed of people at 10 frames per second.
  EXPECT_TRUE(refuses(
      "1 5 0 2\n1 6 0.1 2\n2 5 0 2.4\n2 6 0.1 2.4\n",
      "f: the positions of an id are 0.40 m apart, in the order id frame x y 0.10 m", options));
  EXPECT_EQ(movers_from_text("5 1 0 2\n5 2 0 2.4\n6 1 0.1 2\n6 2 0.1 2.4\n", "f", options).size(),
            2U);
  EXPECT_TRUE(refuses("7 1 0 2\n7 1 5 2\n",
                      "f:2: a time of '1' that does not follow the one before it; expected times "
                      "that increase, or a line '# id frame x y' before lines in this order",
                      options));
}

TEST(MoversFile, VelocitiesOfACsvCheckItsFrameRate) {
  // 1.5 m/s along y, 0.06 m a frame: 25 frames per second. Columns as those of DUT.
  const std::string walker =
      "id,frame,label,x_est,y_est,vx_est,vy_est\n0,1,ped,5,1,0,1.5\n0,2,ped,5,1.06,0,1.5\n";
  MoversFileOptions options;
  options.frame_rate = 25;
  const Movers movers = movers_from_text(walker, "f", options);
  ASSERT_EQ(movers.size(), 1U);
  EXPECT_DOUBLE_EQ(movers[0].waypoints[1].t, 2.0 / 25);
  EXPECT_EQ(movers[0].waypoints[1].position, TPoint2D(5, 1.06));
  options.frame_rate = 60;
  EXPECT_TRUE(refuses(walker, "f: a frame rate of 60 contradicts the velocities, which imply 25.00",
                      options));
}

TEST(MoversFile, AFrameRateThatContradictsTheVelocitiesIsRefused) {
  // 1.5 m/s along x, 0.6 m every 6 frames: 15 frames per second.
  const std::string walker = "0 1 0 0 0 1.5 0 0\n6 1 0.6 0 0 1.5 0 0\n12 1 1.2 0 0 1.5 0 0\n";
  MoversFileOptions options;
  options.frame_rate = 2.5;
  EXPECT_TRUE(refuses(
      walker, "f: a frame rate of 2.5 contradicts the velocities, which imply 15.00", options));
  options.frame_rate = 15;
  EXPECT_EQ(movers_from_text(walker, "f", options).size(), 1U);
  options.frame_rate = 2.5;
  EXPECT_EQ(movers_from_text("0 1 0 0 0 0 0 0\n6 1 0.6 0 0 0 0 0\n", "f", options).size(), 1U)
      << "without velocities";
}

TEST(MoversFile, PositionsOfPeopleInPixelsAreRefused) {
  // 50 pixels for a meter, velocities in pixels, too: 0.5 m in 6 frames at 15 per second.
  const std::string walker = "0 1 0 0 0 62.5 0 0\n6 1 25 0 0 62.5 0 0\n12 1 50 0 0 62.5 0 0\n";
  MoversFileOptions options;
  options.frame_rate = 15;
  EXPECT_TRUE(
      refuses(walker, "f: a median speed of 62.5 m/s; expected positions of people in m", options));
  EXPECT_TRUE(refuses("0 1 100 100\n6 1 125 100\n12 1 150 100\n", "f: a median speed of 62.5 m/s",
                      options));
}

TEST(MoversFile, ErrorsNameTheLineAndWhatWasExpected) {
  EXPECT_TRUE(refuses("", "f: empty file; expected CSV with the columns id, t, x, y"));
  EXPECT_TRUE(refuses("id,t,x\n", "f:1: missing column 'y'"));
  EXPECT_TRUE(refuses("id,t,x,y,z\n", "f:1: unknown column 'z'"));
  EXPECT_TRUE(refuses("id,t,x,x\n", "f:1: duplicate column 'x'"));
  EXPECT_TRUE(refuses("id,t,x,y\na,0,1\n", "f:2: 3 fields; expected 4 numbers"));
  EXPECT_TRUE(refuses("id,t,x,y\na,0,nan,2\n", "f:2: invalid number in field 3"));
  EXPECT_TRUE(refuses("id,t,x,y\na,1,0,0\nb,1,0,0\na,1,1,0\n",
                      "f:4: a time of 'a' that does not follow the one before it"));
  EXPECT_TRUE(refuses("id,t,x,y,r\na,0,0,0,0.3\na,1,0,0,0.4\n", "f:3: another radius of 'a'"));
  EXPECT_TRUE(refuses("id,t,x,y,r\na,0,0,0,-1\n", "f"));
  EXPECT_TRUE(refuses("id,t,x,y\n", "f: no position at or after 0 s"));
  EXPECT_TRUE(refuses("1 1 2 0 3 0 0 0\n", "f:1: frames instead of times"));
  EXPECT_TRUE(refuses("1 1 2 3\n", "f:1: frames instead of times"));
  EXPECT_TRUE(refuses("frame,id,x,y\n", "f:1: frames instead of times"));
  MoversFileOptions options;
  options.frame_rate = 25;
  EXPECT_TRUE(refuses("1 1 2 0 3\n", "f:1: 5 fields; expected 4 numbers (frame id x y), or the 8",
                      options));
  EXPECT_TRUE(refuses("1 1 2 3\n1 1 2 0 3\n", "f:2: 5 fields; expected 4 numbers", options));
  EXPECT_TRUE(refuses("1 1.5 2 3\n", "f:1: invalid id in field 2", options));
  EXPECT_TRUE(refuses("frame,t,id,x,y\n", "f:1: columns 't' and 'frame'", options));
  EXPECT_TRUE(refuses("1 1.5 2 0 3 0 0 0\n", "f:1: invalid id in field 2", options));
}

constexpr char kAgents[] = R"(hunav_loader:
  ros__parameters:
    map: cafe
    agents:
      - anna
      - ben
    ben:
      radius: 0.3
      max_vel: 2
      behavior: {type: 1, vel: 0.6}
      init_pose: {x: 0, y: 1, z: 1.25, h: 0}
      cyclic_goals: false
      goals: [g0]
      g0: {x: 4, y: 1, h: 0}
    anna:
      id: 1
      radius: 0.4
      max_vel: 0.5
      init_pose:
        x: 1.0
        y: 2.0
      goal_radius: 0.3
      cyclic_goals: true
      goals:
        - g0
        - g1
      g0:
        x: 1.0
        y: 5.0
      g1:
        x: 5.0
        y: 5.0
)";

TEST(MoversFile, AgentsOfHuNavSimWalkOverTheirGoals) {
  const Movers movers = movers_from_text(kAgents, "f");
  ASSERT_EQ(movers.size(), 2U);
  // 3 m, 4 m and 5 m back, at 0.5 m/s.
  const Mover anna = {
      "anna", 0.4, {{0, {1, 2}}, {6, {1, 5}}, {14, {5, 5}}, {24, {1, 2}}}, MoverEnd::Loop};
  const Mover ben = {"ben", 0.3, {{0, {0, 1}}, {2, {4, 1}}}, MoverEnd::Stop};
  EXPECT_EQ(movers, (Movers{anna, ben}));
}

TEST(MoversFile, AgentsOfHuNavSimThatCannotBeReadAreRefusedWithTheirLine) {
  const auto changed = [](const std::string& from, const std::string& to) {
    std::string text = kAgents;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_TRUE(refuses(changed("radius: 0.3", "radius: -1"), "f:8: "));
  EXPECT_TRUE(refuses(changed("max_vel: 2", "speed: 2"), "f:"));
  EXPECT_TRUE(refuses(changed("      - ben\n", "      - carl\n"), "f:"));
  EXPECT_TRUE(refuses(changed("goals: [g0]", "goals: [g7]"), "f:"));
  EXPECT_TRUE(refuses(changed("x: 4,", "x: four,"), "f:14: "));
  EXPECT_TRUE(refuses(changed("{type: 1,", "{type: 1"), "f:"));
  EXPECT_TRUE(refuses("hunav_loader: 3\n", "f"));
  // Some kilobytes that would take gigabytes.
  std::string many = "hunav_loader:\n  ros__parameters:\n    agents: [a";
  for (int i = 0; i < 2000; ++i) many += ", a";
  many +=
      "]\n    a:\n      radius: 1\n      max_vel: 1\n      init_pose: {x: 0, y: 0}\n"
      "      g: {x: 1, y: 1}\n      h: {x: 2, y: 2}\n      goals: [g";
  for (int i = 0; i < 1000; ++i) many += ", h, g";
  EXPECT_TRUE(refuses(many + "]\n", "f: too many goals"));
  EXPECT_TRUE(refuses(kAgents, "f: files of HuNavSim have no times", {0.3, 2, 0}));
}

TEST(MoversFile, ColumnsHaveTheNamesOfTrackersToo) {
  const Movers expected = movers_from_text("id,t,x,y\n7,0,1,2\n7,1,2,2\n", "f");
  for (const char* header : {"track_id,time,x,y", "person,t,x,y", "ped_id,time,x,y"})
    EXPECT_EQ(movers_from_text(header + std::string("\n7,0,1,2\n7,1,2,2\n"), "f"), expected)
        << header;
  EXPECT_TRUE(refuses("id,track_id,t,x,y\n7,7,0,1,2\n", "f:1: duplicate column 'track_id'"));
}

TEST(MoversFile, AFrameRateInTheHeaderIsThatOfTheRecording) {
  const std::string lines = "# PersID Frame X/cm Y/cm Z/cm\n1 0 100 200 170\n1 8 150 200 170\n";
  for (const char* rate : {"# framerate: 16.00 fps\n", "# Frame rate = 16\n", "#framerate:16\n"}) {
    const Movers movers =
        movers_from_text("# description: a corridor\n" + std::string(rate) + lines, "f");
    ASSERT_EQ(movers.size(), 1U);
    const Mover expected = {"1", 0.3, {{0, {1, 2}}, {0.5, {1.5, 2}}}, MoverEnd::Vanish};
    EXPECT_EQ(movers, Movers{expected}) << rate;
  }
  MoversFileOptions other;
  other.frame_rate = 25;
  EXPECT_TRUE(refuses("# framerate: 16\n" + lines, "f: a frame rate of 25 contradicts", other));
  EXPECT_TRUE(refuses("# framerate: fast\n" + lines, "f:3: frames instead of times"));
}

}  // namespace
}  // namespace slalom
