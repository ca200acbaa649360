// SPDX-License-Identifier: BSD-3-Clause
#include "memory_folder.h"
#include "results_sample.h"

#include <slalom/core/error.h>
#include <slalom/simulation/evaluate_trajectory.h>
#include <slalom/studio/palette.h>
#include <slalom/studio/results_overlay.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace slalom {
namespace {

constexpr const char* kIni = "[robot]\nradius = 0.2\n[simulation]\nresolution = 0.02\n";

class ResultsOverlayTest : public testing::Test {
 protected:
  ResultsOverlayTest() {
    std::string pattern = (memory_folder() / "overlay-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    path_ = folder_ + "/runs.results";
    write_overlay_sample(path_, {{"campaign", "test"}, {"campaign.ini", kIni}});
  }
  ~ResultsOverlayTest() override { std::filesystem::remove_all(folder_); }

  ResultsOverlay opened() {
    ResultsOverlay overlay;
    overlay.set_source(open_overlay_source(path_));
    overlay.set_runs(read_overlay_runs(overlay.source(), overlay_room().hash()));
    return overlay;
  }

  std::string folder_, path_;
};

TEST_F(ResultsOverlayTest, ReadsMethodsCampaignAndRobot) {
  const OverlaySource source = open_overlay_source(path_);
  EXPECT_EQ((std::vector<std::string>{"nd", "ptg", "vfh"}), source.methods);
  EXPECT_EQ("test", source.campaign);
  ASSERT_TRUE(source.robot);
  EXPECT_DOUBLE_EQ(0.2, source.robot->radius);
  EXPECT_DOUBLE_EQ(0.02, source.simulation.resolution);
}

TEST_F(ResultsOverlayTest, AFileWithoutACampaignHasNoRobot) {
  for (const Manifest& manifest : {Manifest{}, Manifest{{"campaign.ini", "[robot]\nwheels = 3"}}}) {
    write_overlay_sample(path_, manifest);
    EXPECT_FALSE(open_overlay_source(path_).robot);
    const ResultsOverlay overlay = opened();
    EXPECT_FALSE(overlay.trajectories().front().footprint);
    // Clearance of the robot's center: 1 m above the lower wall.
    EXPECT_NEAR(1, overlay.runs()[0].clearances[4], 1e-6);
  }
}

TEST_F(ResultsOverlayTest, RejectsFilesThatAreNotResults) {
  std::ofstream(folder_ + "/bad.results") << "not a database";
  EXPECT_THROW(open_overlay_source(folder_ + "/bad.results"), Error);
  EXPECT_THROW(open_overlay_source(folder_ + "/none.results"), Error);
}

TEST_F(ResultsOverlayTest, ReadsOnlyRunsOfTheScenario) {
  const OverlaySource source = open_overlay_source(path_);
  EXPECT_EQ(4U, read_overlay_runs(source, overlay_room().hash()).size());
  EXPECT_EQ(1U, read_overlay_runs(source, overlay_room("other", 8).hash()).size());
  EXPECT_TRUE(read_overlay_runs(source, "00").empty());
}

TEST_F(ResultsOverlayTest, ComputesClearanceOfTheFootprintAndSpeed) {
  const ResultsOverlay overlay = opened();
  const OverlayRun& nd = overlay.runs()[0];
  ASSERT_EQ(17U, nd.times.size());
  EXPECT_DOUBLE_EQ(0, nd.times.front());
  EXPECT_DOUBLE_EQ(8, nd.times.back());
  // At (5, 1): 1 m to the lower wall, 2 m to the disc; less the robot's radius.
  EXPECT_NEAR(0.8, nd.clearances[8], 1e-6);
  EXPECT_DOUBLE_EQ(1, nd.speeds[8]);
}

TEST_F(ResultsOverlayTest, SpeedOfAHolonomicRobotIncludesLateralVelocity) {
  auto trajectory = std::make_shared<Trajectory>(straight_run(3, 2));
  trajectory->samples[1].vy = 4;
  OverlayRun run;
  run.trajectory = trajectory;
  fill_series(run, World(overlay_room(), 0.05), std::nullopt);
  EXPECT_DOUBLE_EQ(3, run.speeds[0]);
  EXPECT_DOUBLE_EQ(5, run.speeds[1]);
}

TEST_F(ResultsOverlayTest, ARunWithoutATrajectoryIsReportedAndNotDrawn) {
  const ResultsOverlay overlay = opened();
  EXPECT_EQ("no trajectory recorded", overlay.runs()[3].problem);
  EXPECT_NE(std::string::npos, overlay.rows()[4].detail.find("no trajectory recorded"));
  EXPECT_EQ(3U, overlay.trajectories().size());
  EXPECT_FALSE(overlay.speed_now(3));
}

TEST_F(ResultsOverlayTest, AMethodWithSeveralRunsIsFollowedByThem) {
  const auto rows = opened().rows();
  std::vector<std::string> lines;
  for (const OverlayRow& row : rows)
    lines.push_back(row.label + ", " + row.outcome + ", " + row.success);
  EXPECT_EQ(
      (std::vector<std::string>{"nd, success, yes", "ptg, mixed, 1 of 3", "ptg 0, success, yes",
                                "ptg 1, stuck, no", "ptg 2, method_crash, no"}),
      lines);
  EXPECT_TRUE(rows[1].group);
  EXPECT_TRUE(rows[2].indented);
  EXPECT_EQ((std::vector<std::size_t>{1, 2, 3}), rows[1].runs);
  EXPECT_DOUBLE_EQ(8, rows[0].length.number());
  EXPECT_EQ("outcome: stuck", rows[3].time.reason());
  EXPECT_EQ("nd 0: success, outcome detail; length 8.000 m; time to goal 8.000 s", rows[0].detail);
}

TEST_F(ResultsOverlayTest, VisibilityOfRunsAndMethodsIsKeptAcrossScenarios) {
  ResultsOverlay overlay = opened();
  EXPECT_DOUBLE_EQ(8, overlay.clock().duration());
  overlay.toggle(overlay.rows()[0]);
  EXPECT_FALSE(overlay.rows()[0].shown);
  EXPECT_DOUBLE_EQ(4, overlay.clock().duration());  // of ptg
  overlay.toggle(overlay.rows()[2]);                // ptg 0
  EXPECT_TRUE(overlay.rows()[1].shown);             // others of ptg are
  overlay.toggle(overlay.rows()[1]);                // hides all of ptg
  EXPECT_TRUE(overlay.trajectories().empty());
  EXPECT_DOUBLE_EQ(0, overlay.clock().duration());
  overlay.toggle(overlay.rows()[1]);  // shows all of ptg
  EXPECT_TRUE(overlay.is_shown(1) && overlay.is_shown(2) && overlay.is_shown(3));

  overlay.set_runs(read_overlay_runs(overlay.source(), overlay_room().hash()));
  EXPECT_FALSE(overlay.is_shown(0));
  overlay.show_all(true);
  EXPECT_TRUE(overlay.is_shown(0));
  overlay.show_all(false);
  EXPECT_TRUE(overlay.trajectories().empty());
}

TEST_F(ResultsOverlayTest, TrajectoriesAreAtTheTimeOfTheReplay) {
  ResultsOverlay overlay = opened();
  overlay.clock().seek(2.25);  // nd at 1 m/s from x = 1, between samples 4 and 5
  const auto drawn = overlay.trajectories();
  ASSERT_EQ(3U, drawn.size());
  EXPECT_EQ("nd 0", drawn[0].label);
  EXPECT_EQ(4U, drawn[0].sample);
  EXPECT_DOUBLE_EQ(3.25, drawn[0].pose.x);
  EXPECT_DOUBLE_EQ(5.5, drawn[1].pose.x);  // ptg 0 at 2 m/s
  EXPECT_DOUBLE_EQ(5, drawn[2].pose.x);    // ptg 1 ended after 2 s
  EXPECT_EQ("stuck", drawn[2].outcome);
  EXPECT_DOUBLE_EQ(0.2, drawn[0].footprint->enclosing_radius());
  EXPECT_DOUBLE_EQ(1, *overlay.speed_now(0));
  EXPECT_NEAR(0.8, *overlay.clearance_now(0), 1e-6);
  EXPECT_FALSE(overlay.speed_now(2));  // over
}

TEST_F(ResultsOverlayTest, TheClockIsOfTheMoversUnlessRunsAreShown) {
  ResultsOverlay overlay;
  EXPECT_FALSE(overlay.replays_runs());
  overlay.set_movers_duration(20);
  EXPECT_DOUBLE_EQ(20, overlay.clock().duration());
  EXPECT_DOUBLE_EQ(0, overlay.clock().time()) << "movers begin where they are at first";
  overlay.clock().seek(15);
  overlay.set_movers_duration(18);  // after an edit
  EXPECT_DOUBLE_EQ(15, overlay.scene_time());
  overlay.set_movers_duration(12);
  EXPECT_DOUBLE_EQ(12, overlay.scene_time());
  overlay.set_source(open_overlay_source(path_));
  EXPECT_DOUBLE_EQ(0, overlay.scene_time());
  overlay.set_runs(read_overlay_runs(overlay.source(), overlay_room().hash()));
  EXPECT_TRUE(overlay.replays_runs());
  EXPECT_DOUBLE_EQ(8, overlay.clock().duration()) << "of the longest run";
  EXPECT_DOUBLE_EQ(18, overlay.scene_time()) << "the sample's runs begin at 10 s";
  overlay.clock().seek(2.25);
  EXPECT_DOUBLE_EQ(12.25, overlay.scene_time());
  overlay.show_all(false);
  EXPECT_FALSE(overlay.replays_runs());
  EXPECT_DOUBLE_EQ(12, overlay.clock().duration());
  EXPECT_DOUBLE_EQ(2.25, overlay.scene_time());
}

TEST_F(ResultsOverlayTest, PeopleWalkAsInTheSelectedOrElseTheFirstShownRun) {
  // A person in the way of the runs, and two of them: the slower one is met later.
  const Scenario room = overlay_room().with_people({{"p", 0.3, 1, {8, 1}, {{1, 1}}, 0.5}});
  const std::string path = folder_ + "/people.results";
  ResultFile file = ResultFile::create(
      path, {{"campaign.ini", std::string(kIni) + "[people]\nmodel = orca\n"}}, {},
      {{"path_length", 1, "Path length", "m", Direction::Down},
       {"time_to_goal", 1, "Time to goal", "s", Direction::Down}});
  file.add_scenario({room.hash(), room.name(), {}}, room, {});
  const std::vector<Trajectory> driven = {straight_run(0.5, 13), straight_run(1, 7)};
  for (int i : {0, 1})
    file.add_run(overlay_record(room, "nd", i, "collision"), {},
                 driven[static_cast<std::size_t>(i)]);
  file.commit();

  ResultsOverlay overlay;
  const Movers standing = {{"p", 0.3, {{0.5, {8, 1}}}}};
  EXPECT_EQ(overlay.people_in(room), standing);
  overlay.set_source(open_overlay_source(path));
  overlay.set_runs(read_overlay_runs(overlay.source(), room.hash()));
  PeopleSettings orca;
  orca.model = PeopleModel::Orca;
  RobotModel robot;
  robot.radius = 0.2;
  std::vector<Movers> records;
  for (const Trajectory& trajectory : driven) {
    records.push_back(movers_along(World(room, 0.02), robot, {}, trajectory, orca));
    for (Waypoint& waypoint : records.back()[0].waypoints) waypoint.t += 10;  // of the first sample
  }
  ASSERT_NE(records[0], records[1]);
  EXPECT_EQ(overlay.people_in(room), records[0]);
  overlay.select(1);
  EXPECT_EQ(overlay.people_in(room), records[1]);
  overlay.select(0);
  overlay.toggle(overlay.rows()[1]);
  EXPECT_EQ(overlay.people_in(room), records[1]) << "run 0 is hidden";
  overlay.show_all(false);
  EXPECT_EQ(overlay.people_in(room), standing);
  EXPECT_TRUE(overlay.people_in(overlay_room()).empty());
}

TEST_F(ResultsOverlayTest, ValuesNowAreInterpolatedAsInThePlots) {
  auto trajectory = std::make_shared<Trajectory>(straight_run(1, 2));  // 0.5 s
  trajectory->samples[1].v = 3;
  OverlayRun run;
  run.record = overlay_record(overlay_room(), "nd", 0, "success");
  run.trajectory = trajectory;
  fill_series(run, World(overlay_room(), 0.05), std::nullopt);
  ResultsOverlay overlay;
  overlay.set_runs({run});
  overlay.clock().seek(0.125);
  EXPECT_DOUBLE_EQ(1.5, *overlay.speed_now(0));
}

TEST_F(ResultsOverlayTest, AMethodKeepsItsColorInAllScenarios) {
  ResultsOverlay overlay = opened();
  overlay.set_runs(read_overlay_runs(overlay.source(), overlay_room("other", 8).hash()));
  EXPECT_EQ(method_line_color(2), overlay.color_of(0)) << "vfh is the third method of the file";
}

TEST_F(ResultsOverlayTest, RunsAreColoredByTheirMethodSpeedOrClearance) {
  ResultsOverlay overlay = opened();
  EXPECT_EQ(nullptr, overlay.colored_values(0)) << "by method";
  EXPECT_DOUBLE_EQ(0, overlay.max_colored_value());
  overlay.set_coloring(RunColoring::Speed);
  EXPECT_EQ(std::vector<double>(17, 1), *overlay.colored_values(0));
  EXPECT_DOUBLE_EQ(2, overlay.max_colored_value()) << "m/s, of ptg";
  overlay.toggle(overlay.rows()[1]);
  EXPECT_DOUBLE_EQ(2, overlay.max_colored_value()) << "colors stay when runs are hidden";
  overlay.set_coloring(RunColoring::Clearance);
  EXPECT_NEAR(0.8, overlay.max_colored_value(), 1e-6) << "1 m to a wall, less the radius";
}

TEST_F(ResultsOverlayTest, TheSampleNearAPositionIsOfARunThatIsShown) {
  ResultsOverlay overlay = opened();
  const auto near = [&overlay](double x, double radius) {
    const auto at = overlay.sample_near({x, 1.05}, radius);
    return at ? overlay.sample_text(*at) : "none";
  };
  // nd has a sample every 0.5 m from x = 1, ptg every 1 m.
  EXPECT_EQ("nd 0 at 0.50 s: 1.00 m/s, clearance 0.800 m", near(1.52, 0.1));
  EXPECT_EQ("none", near(1.6, 0.1)) << "0.11 m away";
  EXPECT_EQ("nd 0 at 2.00 s: 1.00 m/s, clearance 0.800 m", near(3, 0.1)) << "ptg is as near";
  overlay.toggle(overlay.rows()[0]);
  EXPECT_EQ("none", near(1.52, 0.1));
  EXPECT_EQ("ptg 0 at 0.50 s: 2.00 m/s, clearance 0.800 m", near(1.52, 0.5)) << "0.48 m before it";
}

TEST_F(ResultsOverlayTest, PlotsShowARangeOfTimesUntilOtherRunsAreShown) {
  using Times = std::pair<double, double>;
  ResultsOverlay overlay = opened();  // 8 s
  overlay.clock().seek(3);
  EXPECT_FALSE(overlay.shown_times());
  overlay.show_times(5, 2);
  EXPECT_EQ(overlay.shown_times(), Times(2, 5));
  overlay.show_times(6, 99);
  EXPECT_EQ(overlay.shown_times(), Times(6, 8)) << "clamped";
  overlay.show_times(-2, -1);
  EXPECT_EQ(overlay.shown_times(), Times(6, 8)) << "nothing is there";
  EXPECT_DOUBLE_EQ(overlay.clock().time(), 3);
  overlay.show_all_times();
  EXPECT_FALSE(overlay.shown_times());
  overlay.show_times(2, 5);
  overlay.set_runs({});
  EXPECT_FALSE(overlay.shown_times());
}

TEST(ColoredParts, JoinSamplesOfOneColor) {
  const auto texts = [](const std::vector<double>& values, double maximum) {
    std::vector<std::string> lines;
    for (const ColoredPart& part : colored_parts(values, maximum))
      for (const double fraction : {0.0, 0.5, 1.0})
        if (part.color == heat_color(fraction))
          lines.push_back(std::to_string(part.begin) + " to " + std::to_string(part.end) + ": " +
                          std::to_string(fraction).substr(0, 3));
    return lines;
  };
  using Lines = std::vector<std::string>;
  EXPECT_EQ((Lines{"0 to 2: 0.0", "2 to 3: 0.5", "3 to 4: 1.0"}), texts({0, 0, 1, 2, 2}, 2));
  EXPECT_EQ((Lines{"0 to 2: 0.0", "2 to 3: 1.0"}), texts({-1, NAN, 5, 9}, 2))
      << "outside the scale";
  EXPECT_EQ(Lines{"0 to 1: 0.0"}, texts({3, 4}, 0)) << "no scale";
  EXPECT_EQ(Lines{}, texts({1}, 2)) << "no line";
}

TEST(PoseAt, TurnsTheShorterWay) {
  Trajectory trajectory;
  trajectory.samples.push_back({0, {0, 0, 3.0}});
  trajectory.samples.push_back({1, {2, 4, -3.0}});
  const auto pose = pose_at(trajectory, 0.5);
  EXPECT_DOUBLE_EQ(1, pose.x);
  EXPECT_DOUBLE_EQ(2, pose.y);
  EXPECT_NEAR(M_PI, std::abs(pose.phi), 1e-12);
  EXPECT_EQ(0U, sample_at(trajectory, -1));
  EXPECT_DOUBLE_EQ(0, pose_at(trajectory, -1).x);
  EXPECT_DOUBLE_EQ(2, pose_at(trajectory, 7).x);
}

}  // namespace
}  // namespace slalom
