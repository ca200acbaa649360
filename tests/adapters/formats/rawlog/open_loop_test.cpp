// SPDX-License-Identifier: BSD-3-Clause
#include "recorded_runs.h"

#include <slalom/rawlog/open_loop_summary.h>

#include <mrpt/core/bits_math.h>
#include <nlohmann/json.hpp>

#include <error_text.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::obs::CObservation2DRangeScan;

/// `rays` rays over `aperture_deg`, all of which measure `range`.
CObservation2DRangeScan even_scan(std::size_t rays, double aperture_deg, float range) {
  CObservation2DRangeScan scan;
  scan.aperture = static_cast<float>(mrpt::DEG2RAD(aperture_deg));
  scan.maxRange = 80;
  scan.resizeScanAndAssign(rays, range, true);
  return scan;
}

SensorModel sensor_of(int rays, double aperture_deg) {
  SensorModel sensor;
  sensor.rays = rays;
  sensor.aperture_deg = aperture_deg;
  return sensor;
}

TEST(ResampleScan, KeepsAScanOfTheSameSensor) {
  auto scan = even_scan(181, 180, 2);
  for (std::size_t i = 0; i < 181; ++i) scan.setScanRange(i, 1 + 0.01F * static_cast<float>(i));
  const auto resampled = resample_scan(scan, sensor_of(181, 180));
  ASSERT_EQ(resampled.getScanSize(), 181U);
  // The points of neighboring rays cover up to half a spacing: they matter only due to rounding.
  for (std::size_t i = 0; i < 181; ++i)
    EXPECT_NEAR(resampled.getScanRange(i), scan.getScanRange(i), 0.0101) << i;
}

TEST(ResampleScan, CropsToTheAngleAndTheRangeOfTheSensor) {
  auto scan = even_scan(361, 360, 10);
  scan.setScanRange(180, 3);  // straight ahead
  scan.setScanRange(0, 1);    // straight behind
  const auto resampled = resample_scan(scan, sensor_of(91, 90));
  ASSERT_EQ(resampled.getScanSize(), 91U);
  EXPECT_FLOAT_EQ(resampled.getScanRange(45), 3);
  EXPECT_FLOAT_EQ(resampled.getScanRange(0), 8);  // 10 m is beyond its 8 m
  EXPECT_FALSE(resampled.getScanRangeValidity(0));
  for (std::size_t i = 0; i < 91; ++i) EXPECT_GE(resampled.getScanRange(i), 3);
}

TEST(ResampleScan, KeepsTheClosestOfManyRays) {
  auto scan = even_scan(721, 180, 5);  // 0.25 degrees
  scan.setScanRange(361, 2);           // 0.25 degrees to the left: within half a degree of ahead
  const auto resampled = resample_scan(scan, sensor_of(181, 180));
  EXPECT_FLOAT_EQ(resampled.getScanRange(90), 2);
  EXPECT_FLOAT_EQ(resampled.getScanRange(91), 5);
  EXPECT_FLOAT_EQ(resampled.getScanRange(89), 5);
}

TEST(ResampleScan, LeavesNoGapsBetweenSparseRays) {
  const auto resampled =
      resample_scan(even_scan(19, 180, 4), sensor_of(181, 180));  // 10 degrees apart
  for (std::size_t i = 0; i < 181; ++i) EXPECT_FLOAT_EQ(resampled.getScanRange(i), 4) << i;
}

TEST(ResampleScan, RaysWithoutHitsAreFree) {
  auto scan = even_scan(181, 180, 4);
  for (std::size_t i = 60; i < 121; ++i) scan.setScanRangeValidity(i, false);
  scan.setScanRange(30, 0);
  const auto resampled = resample_scan(scan, sensor_of(181, 180));
  EXPECT_FLOAT_EQ(resampled.getScanRange(90), 8);
  EXPECT_FLOAT_EQ(resampled.getScanRange(30), 8);
}

TEST(ResampleScan, ARangeOfTheMaximumIsNoReturn) {
  // Drivers and simulators write the maximum where nothing is. Those that set it to the largest
  // reading lose that one: a wall at the maximum all around would be worse.
  auto scan = even_scan(181, 180, 4);
  scan.maxRange = 4;
  scan.setScanRange(90, 3);
  const auto resampled = resample_scan(scan, sensor_of(181, 180));
  EXPECT_FLOAT_EQ(resampled.getScanRange(90), 3);
  EXPECT_FLOAT_EQ(resampled.getScanRange(45), 8);
  EXPECT_FALSE(resampled.getScanRangeValidity(45));
}

TEST(ResampleScan, TransformsToTheRobotsCenter) {
  auto scan = even_scan(181, 180, 2);
  scan.sensorPose = mrpt::poses::CPose3D(0.5, 0, 0.3, 0, 0, 0);  // half a meter ahead
  const auto ahead = resample_scan(scan, sensor_of(181, 180));
  EXPECT_NEAR(ahead.getScanRange(90), 2.5, 1e-6);
  // The point of the ray at 90 degrees is at (0.5, 2).
  EXPECT_NEAR(ahead.getScanRange(166), std::hypot(0.5, 2), 0.05);  // 76 degrees

  auto upside_down = even_scan(181, 180, 5);
  upside_down.setScanRange(0, 1);  // -90 degrees of the sensor, the robot's left
  upside_down.sensorPose = mrpt::poses::CPose3D(0, 0, 0, 0, 0, M_PI);
  EXPECT_NEAR(resample_scan(upside_down, sensor_of(181, 180)).getScanRange(180), 1, 1e-6);

  auto clockwise = even_scan(181, 180, 5);
  clockwise.rightToLeft = false;
  clockwise.setScanRange(0, 1);  // the first ray points to the left
  EXPECT_NEAR(resample_scan(clockwise, sensor_of(181, 180)).getScanRange(180), 1, 1e-6);
}

TEST(ResampleScan, ScansThatAreNotHorizontalHaveNoPoints) {
  auto scan = even_scan(181, 180, 2);
  scan.sensorPose = mrpt::poses::CPose3D(0, 0, 1, 0, mrpt::DEG2RAD(30.0), 0);
  EXPECT_TRUE(scan_points(scan).empty());
}

// The default robot: radius 0.25 m, brakes with 1 m/s^2. At v = 1 m/s: one period of 0.1 s at full
// speed is 0.1 m, braking 0.5 m; so 0.6 m until it stops, 1 m in one second.
TEST(PredictContact, OfARobotDrivingStraight) {
  const RobotModel robot;
  const auto prediction = [&](double distance) {
    return predict_contact(robot, 0.1, {1, 0, 0}, {1, 0, 0}, {{distance, 0}});
  };
  const ContactPrediction near = prediction(0.25 + 0.55), between = prediction(0.25 + 0.8),
                          far = prediction(0.25 + 1.1), touching = prediction(0.2);
  EXPECT_TRUE(near.stopping && near.one_second && !near.in_contact);
  EXPECT_TRUE(!between.stopping && between.one_second);
  EXPECT_TRUE(!far.stopping && !far.one_second);
  EXPECT_TRUE(touching.in_contact && !touching.stopping && !touching.one_second);
}

TEST(PredictContact, AStoppedRobotHasNoContact) {
  const ContactPrediction prediction = predict_contact({}, 0.1, {}, {}, {{0.26, 0}});
  EXPECT_FALSE(prediction.in_contact || prediction.stopping || prediction.one_second);
}

TEST(PredictContact, OfACornerOfARotatingFootprint) {
  RobotModel robot;
  robot.footprint = "-0.2,-0.2; 0.6,-0.2; 0.6,0.2; -0.2,0.2";
  robot.radius = robot.shape().enclosing_radius();
  const std::vector<TPoint2D> points = {{0.5, 0.3}};  // free at the start; reached by turning left
  EXPECT_FALSE(predict_contact(robot, 0.1, {}, {}, points).one_second);
  EXPECT_TRUE(predict_contact(robot, 0.1, {}, {0, 1.0, 0}, points).one_second);
  EXPECT_FALSE(predict_contact(robot, 0.1, {}, {0, -1.0, 0}, points).one_second);
}

TEST(PredictContact, VelocitiesAreClampedToTheRobotsLimits) {
  const std::vector<TPoint2D> ahead = {{0.25 + 0.7, 0}};
  EXPECT_FALSE(predict_contact({}, 0.1, {5, 0, 0}, {0, 0, 0}, ahead).stopping);
}

LoggedScan logged(double time, float range) {
  LoggedScan scan;
  scan.scan = std::make_shared<CObservation2DRangeScan>(even_scan(181, 180, range));
  scan.time = time;
  return scan;
}

TEST(ReplayOpenLoop, EachScanIsASeparateTask) {
  OpenLoopSetup setup;
  setup.goal_ahead = 3;
  auto moved = logged(1, 4);
  moved.odometry = {1, 2, M_PI / 2};
  moved.velocity = mrpt::math::TTwist2D(0.5, 0, 0.1);
  struct : Method {
    void reset(const NavigationTask& task) override { tasks.push_back(task); }
    Command step(const Observation& observation) override {
      observations.push_back(observation);
      return {0.1 * static_cast<double>(tasks.size()), 0};
    }
    std::vector<NavigationTask> tasks;
    std::vector<Observation> observations;
  } method;
  const auto answers = replay_open_loop({logged(0, 4), moved}, setup, method);
  ASSERT_EQ(method.tasks.size(), 2U);
  EXPECT_NEAR(method.tasks[1].goal.x, 1, 1e-12);
  EXPECT_NEAR(method.tasks[1].goal.y, 5, 1e-12);
  EXPECT_EQ(method.observations[1].goal_in_robot.x, 3);
  EXPECT_EQ(method.observations[1].v, 0.5);
  EXPECT_EQ(method.observations[1].w, 0.1);
  EXPECT_EQ(method.observations[0].v, 0);
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[1].command.v, 0.2);
  EXPECT_EQ(answers[1].time, 1);
  EXPECT_EQ(answers[0].uncovered_rays, 0);
}

TEST(ReplayOpenLoop, AMethodThatTakesTheLaserForTheCenterSeesItsRanges) {
  auto ahead = std::make_shared<CObservation2DRangeScan>(even_scan(181, 180, 4));
  ahead->sensorPose.x(0.5);
  LoggedScan scan;
  scan.scan = ahead;
  OpenLoopSetup setup;
  float range = 0;
  testing::FunctionMethod method([&](const Observation& o) {
    range = o.scan->getScanRange(90);
    return Command{};
  });
  replay_open_loop({scan}, setup, method);
  EXPECT_NEAR(range, 4.5, 1e-5);
  setup.sensor.lasers.resize(1);
  setup.sensor.lasers[0].name = "front";
  replay_open_loop({scan}, setup, method);
  EXPECT_NEAR(range, 4.5, 1e-5);
  setup.sensor.lasers[0].raw = true;
  replay_open_loop({scan}, setup, method);
  EXPECT_NEAR(range, 4, 1e-5);
}

TEST(ReplayOpenLoop, PredictsContact) {
  auto fast = testing::constant_method(1, 0);
  auto moving = logged(0, 0.7F);
  moving.velocity = mrpt::math::TTwist2D(1, 0, 0);
  const auto answers = replay_open_loop({moving, logged(1, 5)}, {}, fast);
  EXPECT_TRUE(answers[0].prediction.stopping);
  EXPECT_FALSE(answers[1].prediction.one_second);
}

TEST(ReplayOpenLoop, InvalidAnswersHaveAReason) {
  auto too_fast = testing::constant_method(7, 0);
  testing::FunctionMethod failing([](const Observation&) -> Command { throw MethodError("lost"); });
  EXPECT_TRUE(mentions(replay_open_loop({logged(0, 4)}, {}, too_fast)[0].problem, {"v = 7"}));
  EXPECT_EQ(replay_open_loop({logged(0, 4)}, {}, failing)[0].problem, "lost");
}

TEST(ReplayOpenLoop, CountsRaysOutsideTheFieldOfView) {
  auto half = logged(0, 4);
  half.scan = std::make_shared<CObservation2DRangeScan>(even_scan(91, 90, 4));
  auto method = testing::constant_method(0, 0);
  // 181 rays from -90 to 90 degrees; those from -45 to 45, 91 of them, are covered.
  EXPECT_EQ(replay_open_loop({half}, {}, method)[0].uncovered_rays, 90);
}

/// Two commands, one of which predicts contact, and a scan without a command.
std::vector<OpenLoopAnswer> three_answers() {
  std::vector<OpenLoopAnswer> answers(3);
  answers[0].command = {0.5, 0.1};
  answers[0].uncovered_rays = 6;
  answers[1].command = {0.2, 0};
  answers[1].prediction.stopping = answers[1].prediction.one_second = true;
  answers[2].time = 2;
  answers[2].problem = "lost";
  return answers;
}

TEST(OpenLoopSummary, MeansOfVelocitiesAreOverCommandsAndOfRaysOverScans) {
  auto moved = logged(1, 4);
  moved.odometry = {1, 2, 0};
  const OpenLoopSummary sum = summarize({logged(0, 4), moved, logged(2, 4)}, three_answers());
  EXPECT_EQ(sum.scans, 3U);
  EXPECT_EQ(sum.with_odometry, 1U);
  EXPECT_EQ(sum.commands, 2U);
  EXPECT_EQ(sum.problems, 1U);
  EXPECT_EQ(sum.stopping, 1U);
  EXPECT_NEAR(sum.mean_v, 0.35, 1e-12);
  EXPECT_NEAR(sum.mean_uncovered, 2, 1e-12);
  EXPECT_EQ(summarize({}, {}).mean_v, 0);
}

TEST(OpenLoopSummary, CommandsAreComparedWithTheVelocitiesAtTheNextScan) {
  std::vector<LoggedScan> scans(3);
  scans[0].velocity = {9, 9, 9};
  scans[1].velocity = {0.3, 0, 0.2};
  scans[2].velocity = {0.1, 0, 0};
  // Commands of 0.5 m/s, 0.1 rad/s, and of 0.2 m/s, 0; none at the last scan.
  const OpenLoopSummary sum = summarize(scans, three_answers());
  EXPECT_EQ(sum.compared, 2U);
  EXPECT_NEAR(sum.difference_v, (0.2 + 0.1) / 2, 1e-12);
  EXPECT_NEAR(sum.difference_w, (0.1 + 0) / 2, 1e-12);
  EXPECT_NE(render_text(sum).find("0.150 m/s, 0.050 rad/s on average"), std::string::npos);
}

TEST(OpenLoopSummary, TextAndJsonAgree) {
  OpenLoopSummary sum = summarize({}, three_answers());
  sum.log = "a.rawlog";
  sum.method = "nd";
  sum.goal_ahead = 5;
  EXPECT_EQ(render_text(sum),
            "a.rawlog: nd, goal 5 m ahead\n"
            "scans                                 3\n"
            "  with odometry                       0\n"
            "  rays not covered by the log         2.0 on average\n"
            "commands                              2\n"
            "  mean linear velocity                0.350 m/s\n"
            "  distance from the log's velocity    NA: no command before a scan with a velocity\n"
            "  robot already in contact            0\n"
            "  contact, braking after one period   1\n"
            "  contact, held for one second        1\n"
            "scans without a command               1\n");
  EXPECT_EQ(render_text(three_answers()),
            "time_s v w vy contact\n"
            "0.000 0.500 0.100 0.000 none\n"
            "0.000 0.200 0.000 0.000 stopping\n"
            "2.000 - - - lost\n\n");
  const auto json = nlohmann::json::parse(render_json(sum, three_answers()));
  EXPECT_EQ(json["commands"], 2);
  EXPECT_EQ(json["answers"][1]["contact"]["stopping"], true);
  EXPECT_EQ(json["answers"][2]["problem"], "lost");
  EXPECT_FALSE(nlohmann::json::parse(render_json(sum, {})).contains("answers"));
}

}  // namespace
}  // namespace slalom
