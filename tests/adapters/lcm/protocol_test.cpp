#include <slalom/lcm/protocol.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace slalom {
namespace {

template <typename Message>
std::vector<unsigned char> encoded(const Message& message) {
  std::vector<unsigned char> bytes(static_cast<std::size_t>(message.getEncodedSize()));
  EXPECT_EQ(message.encode(bytes.data(), 0, static_cast<int>(bytes.size())),
            static_cast<int>(bytes.size()));
  return bytes;
}

template <typename Message>
bool decodes(const std::vector<unsigned char>& bytes) {
  Message message;
  return decode_message(bytes.data(), bytes.size(), message);
}

/// Writes a 32-bit integer as LCM does: the most significant byte first.
void put(std::vector<unsigned char>& bytes, std::size_t at, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i)
    bytes[at + i] = static_cast<unsigned char>(value >> (24 - 8 * i));
}

TEST(Protocol, TellsTheRobotAndItsSensorToTheLastBit) {
  RobotModel robot;
  robot.kinematics = "holonomic";
  robot.footprint = "0.3,-0.1; 0.3,0.1; -0.2,0.1; -0.2,-0.1";
  robot.radius = std::hypot(0.3, 0.1);
  robot.max_v = 1.0 / 3;
  robot.forward_only = false;
  SensorModel sensor;
  sensor.rays = 91;
  sensor.max_range = 1.0 / 7;
  const auto bytes = encoded(make_hello("mine", robot, sensor, {{"gain", "2"}, {"a", ""}}));
  hello_t hello;
  ASSERT_TRUE(decode_message(bytes.data(), bytes.size(), hello));
  EXPECT_EQ(hello.protocol_version, kLcmProtocolVersion);
  EXPECT_EQ(hello.method, "mine");
  EXPECT_EQ(settings_of(hello), (MethodSettings{{"a", ""}, {"gain", "2"}}));
  const RobotModel told = robot_of(hello);
  const Footprint here = robot.shape(), there = told.shape();
  EXPECT_EQ(here.corners(), there.corners());
  EXPECT_EQ(told.radius, robot.radius);
  EXPECT_EQ(told.max_v, robot.max_v);
  EXPECT_TRUE(told.holonomic());
  EXPECT_FALSE(told.forward_only);
  EXPECT_EQ(sensor_of(hello).max_range, sensor.max_range);
  for (const double degrees : {180.0, 270.0, 240.1, 33.3, 360.0, 1e-3, 100.0 / 3}) {
    sensor.aperture_deg = degrees;
    EXPECT_EQ(sensor_of(make_hello("", robot, sensor, {})).aperture(), sensor.aperture())
        << degrees;
  }
}

TEST(Protocol, TellsTasksAndObservationsToTheLastBit) {
  Task task;
  task.start = {1.0 / 3, -2, 0.1};
  task.goal = {3, 4.0 / 7};
  task.goal_tolerance = 0.2;
  task.control_period = 0.1;
  task.seed = 0xFEDCBA9876543210U;  // beyond what a signed number holds
  const Task told = task_of(make_run_start(5, task));
  EXPECT_EQ(told.start, task.start);
  EXPECT_EQ(told.goal, task.goal);
  EXPECT_EQ(told.goal_tolerance, task.goal_tolerance);
  EXPECT_EQ(told.control_period, task.control_period);
  EXPECT_EQ(told.seed, task.seed);

  mrpt::obs::CObservation2DRangeScan scan;
  ReceivedScan seen;
  const std::vector<float> ranges = {0.1F, 8.0F, 7.9999F};
  const std::vector<char> valid = {1, 0, 1};
  scan.loadFromVectors(3, ranges.data(), valid.data());
  Observation observation;
  observation.time = 0.7;
  observation.odometry = {1, 2, 0.3};
  observation.v = 0.4;
  observation.vy = -0.5;
  observation.w = 0.6;
  observation.goal_in_robot = {7, 8};
  observation.scan = &scan;
  observation_t message = {};
  fill_observation(observation, message);
  const Observation got = observation_of(message, SensorModel(), seen);
  EXPECT_EQ(got.time, 0.7);
  EXPECT_EQ(got.odometry, observation.odometry);
  EXPECT_EQ(got.v, 0.4);
  EXPECT_EQ(got.vy, -0.5);
  EXPECT_EQ(got.w, 0.6);
  EXPECT_EQ(got.goal_in_robot, observation.goal_in_robot);
  ASSERT_EQ(got.scan->getScanSize(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(got.scan->getScanRange(i), ranges[i]);
    EXPECT_EQ(got.scan->getScanRangeValidity(i), valid[i] != 0);
  }
}

/// Whatever is cut off: the rest is no message, and nothing is read beyond it.
TEST(Protocol, RefusesMessagesCutShort) {
  const auto hello = encoded(make_hello("mine", RobotModel(), SensorModel(), {{"gain", "2"}}));
  observation_t observation = {};
  observation.rays = 2;
  observation.ranges = {1, 2};
  const auto seen = encoded(observation);
  ASSERT_TRUE(decodes<hello_t>(hello));
  ASSERT_TRUE(decodes<observation_t>(seen));
  for (std::size_t size = 0; size < hello.size(); ++size)
    EXPECT_FALSE(decodes<hello_t>({hello.begin(), hello.begin() + static_cast<long>(size)}));
  for (std::size_t size = 0; size < seen.size(); ++size)
    EXPECT_FALSE(decodes<observation_t>({seen.begin(), seen.begin() + static_cast<long>(size)}));
}

TEST(Protocol, RefusesOtherMessagesAndWhatFollowsAMessage) {
  command_t command = {};
  auto bytes = encoded(command);
  EXPECT_FALSE(decodes<run_end_t>(bytes));
  bytes.push_back(0);
  EXPECT_FALSE(decodes<command_t>(bytes));
}

/// A layout that forgets a field would refuse a message that is as it should be.
TEST(Protocol, KnowsTheLayoutOfEachMessage) {
  EXPECT_TRUE(decodes<hello_t>(encoded(hello_t{})));
  EXPECT_TRUE(decodes<ready_t>(encoded(ready_t{})));
  EXPECT_TRUE(decodes<run_start_t>(encoded(run_start_t{})));
  EXPECT_TRUE(decodes<observation_t>(encoded(observation_t{})));
  EXPECT_TRUE(decodes<command_t>(encoded(command_t{})));
  EXPECT_TRUE(decodes<run_end_t>(encoded(run_end_t{})));
  EXPECT_TRUE(decodes<error_t>(encoded(error_t{})));
}

/// Sizes for which a decoder would take gigabytes, and lengths below zero.
TEST(Protocol, RefusesSizesThatTheMessageCannotHold) {
  constexpr std::size_t kFirst = 8, kSecond = 12;  // after the fingerprint
  const auto hello = encoded(make_hello("mine", RobotModel(), SensorModel(), {{"gain", "2"}}));
  for (const std::uint32_t size : {0x7FFFFFFFU, 0x80000000U, 0xFFFFFFFFU, 1000000U}) {
    auto bytes = hello;
    put(bytes, kFirst, size);
    EXPECT_FALSE(decodes<hello_t>(bytes));
    bytes = hello;
    put(bytes, kSecond, size);
    EXPECT_FALSE(decodes<hello_t>(bytes));
    auto observation = encoded(observation_t{});
    put(observation, kFirst, size);
    EXPECT_FALSE(decodes<observation_t>(observation));
  }
  error_t error = {};
  for (const std::uint32_t length : {0U, 0x80000000U, 0xFFFFFFFFU}) {
    auto bytes = encoded(error);
    put(bytes, 16, length);  // of the text, after fingerprint and id
    EXPECT_FALSE(decodes<error_t>(bytes));
  }
}

}  // namespace
}  // namespace slalom
