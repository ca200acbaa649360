#include "recorded_runs.h"

#include <slalom/rawlog/open_loop.h>

#include <mrpt/core/bits_math.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::obs::CObservation2DRangeScan;

/// `rays` rays over `aperture_deg` that all measure `range`.
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

TEST(ResampleScan, KeepsAScanOfItsOwnSensor) {
  auto scan = even_scan(181, 180, 2);
  for (std::size_t i = 0; i < 181; ++i) scan.setScanRange(i, 1 + 0.01F * static_cast<float>(i));
  const auto seen = resample_scan(scan, sensor_of(181, 180));
  ASSERT_EQ(seen.getScanSize(), 181U);
  // A ray also has what its neighbours' points reach, half a spacing away: nothing, but for
  // rounding.
  for (std::size_t i = 0; i < 181; ++i)
    EXPECT_NEAR(seen.getScanRange(i), scan.getScanRange(i), 0.0101) << i;
}

TEST(ResampleScan, CropsToTheAngleAndTheRangeOfTheSensor) {
  auto scan = even_scan(361, 360, 10);
  scan.setScanRange(180, 3);  // straight ahead
  scan.setScanRange(0, 1);    // straight behind
  const auto seen = resample_scan(scan, sensor_of(91, 90));
  ASSERT_EQ(seen.getScanSize(), 91U);
  EXPECT_FLOAT_EQ(seen.getScanRange(45), 3);
  EXPECT_FLOAT_EQ(seen.getScanRange(0), 8);  // 10 m is beyond its 8 m
  EXPECT_FALSE(seen.getScanRangeValidity(0));
  for (std::size_t i = 0; i < 91; ++i) EXPECT_GE(seen.getScanRange(i), 3);
}

TEST(ResampleScan, KeepsTheNearestOfManyRays) {
  auto scan = even_scan(721, 180, 5);  // 0.25 degrees
  scan.setScanRange(361, 2);           // 0.25 degrees to the left: within half a degree of ahead
  const auto seen = resample_scan(scan, sensor_of(181, 180));
  EXPECT_FLOAT_EQ(seen.getScanRange(90), 2);
  EXPECT_FLOAT_EQ(seen.getScanRange(91), 5);
  EXPECT_FLOAT_EQ(seen.getScanRange(89), 5);
}

TEST(ResampleScan, LeavesNoHolesBetweenFewRays) {
  const auto seen = resample_scan(even_scan(19, 180, 4), sensor_of(181, 180));  // 10 degrees apart
  for (std::size_t i = 0; i < 181; ++i) EXPECT_FLOAT_EQ(seen.getScanRange(i), 4) << i;
}

TEST(ResampleScan, RaysThatMetNothingAreFree) {
  auto scan = even_scan(181, 180, 4);
  for (std::size_t i = 60; i < 121; ++i) scan.setScanRangeValidity(i, false);
  scan.setScanRange(30, 0);
  const auto seen = resample_scan(scan, sensor_of(181, 180));
  EXPECT_FLOAT_EQ(seen.getScanRange(90), 8);
  EXPECT_FLOAT_EQ(seen.getScanRange(30), 8);
}

TEST(ResampleScan, SeesFromTheRobotsCentre) {
  auto scan = even_scan(181, 180, 2);
  scan.sensorPose = mrpt::poses::CPose3D(0.5, 0, 0.3, 0, 0, 0);  // half a metre ahead
  const auto ahead = resample_scan(scan, sensor_of(181, 180));
  EXPECT_NEAR(ahead.getScanRange(90), 2.5, 1e-6);
  // Seen at 90 degrees the point is at (0.5, 2).
  EXPECT_NEAR(ahead.getScanRange(166), std::hypot(0.5, 2), 0.05);  // 76 degrees

  auto upside_down = even_scan(181, 180, 5);
  upside_down.setScanRange(0, 1);  // -90 degrees of the sensor, the robot's left
  upside_down.sensorPose = mrpt::poses::CPose3D(0, 0, 0, 0, 0, M_PI);
  EXPECT_NEAR(resample_scan(upside_down, sensor_of(181, 180)).getScanRange(180), 1, 1e-6);

  auto clockwise = even_scan(181, 180, 5);
  clockwise.rightToLeft = false;
  clockwise.setScanRange(0, 1);  // its first ray looks to the left
  EXPECT_NEAR(resample_scan(clockwise, sensor_of(181, 180)).getScanRange(180), 1, 1e-6);
}

TEST(ResampleScan, AScanOfTheGroundIsNone) {
  auto scan = even_scan(181, 180, 2);
  scan.sensorPose = mrpt::poses::CPose3D(0, 0, 1, 0, mrpt::DEG2RAD(30.0), 0);
  EXPECT_TRUE(scan_points(scan).empty());
}

// The default robot: radius 0.25 m, brakes with 1 m/s^2. At v = 1 m/s: one period of 0.1 s at full
// speed is 0.1 m, braking 0.5 m; so 0.6 m until it stands, 1 m in one second.
TEST(ForeseeContact, OfARobotThatDrivesStraight) {
  const RobotModel robot;
  const auto forecast = [&](double distance) {
    return foresee_contact(robot, 0.1, {1, 0, 0}, {1, 0, 0}, {{distance, 0}});
  };
  const Forecast near = forecast(0.25 + 0.55), between = forecast(0.25 + 0.8),
                 far = forecast(0.25 + 1.1), touching = forecast(0.2);
  EXPECT_TRUE(near.stopping && near.one_second && !near.at_once);
  EXPECT_TRUE(!between.stopping && between.one_second);
  EXPECT_TRUE(!far.stopping && !far.one_second);
  EXPECT_TRUE(touching.at_once && !touching.stopping && !touching.one_second);
}

TEST(ForeseeContact, ARobotThatStandsAndIsToldToStandMeetsNothing) {
  const Forecast forecast = foresee_contact({}, 0.1, {}, {}, {{0.26, 0}});
  EXPECT_FALSE(forecast.at_once || forecast.stopping || forecast.one_second);
}

TEST(ForeseeContact, ACornerOfAFootprintThatTurns) {
  RobotModel robot;
  robot.footprint = "-0.2,-0.2; 0.6,-0.2; 0.6,0.2; -0.2,0.2";
  robot.radius = robot.shape().enclosing_radius();
  const std::vector<TPoint2D> beside = {{0.5, 0.3}};  // free now; reached by turning left
  EXPECT_FALSE(foresee_contact(robot, 0.1, {}, {}, beside).one_second);
  EXPECT_TRUE(foresee_contact(robot, 0.1, {}, {0, 1.0, 0}, beside).one_second);
  EXPECT_FALSE(foresee_contact(robot, 0.1, {}, {0, -1.0, 0}, beside).one_second);
}

TEST(ForeseeContact, SpeedsBeyondTheRobotsLimitsCountAsItsLimits) {
  const std::vector<TPoint2D> ahead = {{0.25 + 0.7, 0}};
  EXPECT_FALSE(foresee_contact({}, 0.1, {5, 0, 0}, {0, 0, 0}, ahead).stopping);
}

LoggedScan logged(double time, float range) {
  LoggedScan scan;
  scan.scan = std::make_shared<CObservation2DRangeScan>(even_scan(181, 180, range));
  scan.time = time;
  return scan;
}

TEST(ReplayOpenLoop, EveryScanIsATaskOfItsOwn) {
  OpenLoopSetup setup;
  setup.goal_ahead = 3;
  auto moved = logged(1, 4);
  moved.odometry = {1, 2, M_PI / 2};
  moved.velocity = mrpt::math::TTwist2D(0.5, 0, 0.1);
  struct : Method {
    void reset(const Task& task) override { tasks.push_back(task); }
    Command step(const Observation& observation) override {
      observations.push_back(observation);
      return {0.1 * static_cast<double>(tasks.size()), 0};
    }
    std::vector<Task> tasks;
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
  EXPECT_EQ(answers[0].unseen_rays, 0);
}

TEST(ReplayOpenLoop, CountsWhatWouldHaveLedToContact) {
  auto fast = testing::constant_method(1, 0);
  auto moving = logged(0, 0.7F);
  moving.velocity = mrpt::math::TTwist2D(1, 0, 0);
  const auto answers = replay_open_loop({moving, logged(1, 5)}, {}, fast);
  EXPECT_TRUE(answers[0].forecast.stopping);
  EXPECT_FALSE(answers[1].forecast.one_second);
}

TEST(ReplayOpenLoop, AnswersThatAreNoneHaveAReason) {
  auto too_fast = testing::constant_method(7, 0);
  testing::FunctionMethod failing([](const Observation&) -> Command { throw MethodError("lost"); });
  EXPECT_NE(replay_open_loop({logged(0, 4)}, {}, too_fast)[0].problem.find("v = 7"),
            std::string::npos);
  EXPECT_EQ(replay_open_loop({logged(0, 4)}, {}, failing)[0].problem, "lost");
}

TEST(ReplayOpenLoop, CountsRaysOutsideTheLogsView) {
  auto half = logged(0, 4);
  half.scan = std::make_shared<CObservation2DRangeScan>(even_scan(91, 90, 4));
  auto method = testing::constant_method(0, 0);
  // 181 rays from -90 to 90 degrees; those from -45 to 45, 91 of them, are seen.
  EXPECT_EQ(replay_open_loop({half}, {}, method)[0].unseen_rays, 90);
}

}  // namespace
}  // namespace slalom
