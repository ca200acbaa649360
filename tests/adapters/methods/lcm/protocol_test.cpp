// SPDX-License-Identifier: BSD-3-Clause
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

TEST(Protocol, EncodesRobotAndSensorExactly) {
  RobotModel robot;
  robot.kinematics = Kinematics::Holonomic;
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
  const RobotModel decoded = robot_of(hello);
  const Footprint here = robot.shape(), there = decoded.shape();
  EXPECT_EQ(here.corners(), there.corners());
  RobotModel fork = robot;
  fork.footprint = "0.3,0.2; 0.3,0.1; 0.1,0.1; 0.1,-0.1; 0.3,-0.1; 0.3,-0.2; -0.2,-0.2; -0.2,0.2";
  EXPECT_EQ(robot_of(make_hello("", fork, sensor, {})).shape().corners(), fork.shape().hull());
  EXPECT_EQ(decoded.radius, robot.radius);
  EXPECT_EQ(decoded.max_v, robot.max_v);
  EXPECT_TRUE(decoded.holonomic());
  EXPECT_FALSE(decoded.forward_only);
  EXPECT_EQ(sensor_of(hello).max_range, sensor.max_range);
  for (const double degrees : {180.0, 270.0, 240.1, 33.3, 360.0, 1e-3, 100.0 / 3}) {
    sensor.aperture_deg = degrees;
    EXPECT_EQ(sensor_of(make_hello("", robot, sensor, {})).aperture(), sensor.aperture())
        << degrees;
  }
}

TEST(Protocol, EncodesTasksAndObservationsExactly) {
  NavigationTask task;
  task.start = {1.0 / 3, -2, 0.1};
  task.goal = {3, 4.0 / 7};
  task.goal_tolerance = 0.2;
  task.control_period = 0.1;
  task.seed = 0xFEDCBA9876543210U;  // exceeds the range of a signed integer
  const NavigationTask decoded = task_of(make_run_start(5, task));
  EXPECT_EQ(decoded.start, task.start);
  EXPECT_EQ(decoded.goal, task.goal);
  EXPECT_EQ(decoded.goal_tolerance, task.goal_tolerance);
  EXPECT_EQ(decoded.control_period, task.control_period);
  EXPECT_EQ(decoded.seed, task.seed);

  mrpt::obs::CObservation2DRangeScan scan;
  ReceivedScan scan_buffer;
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
  const Observation received = observation_of(message, SensorModel(), scan_buffer);
  EXPECT_EQ(received.time, 0.7);
  EXPECT_EQ(received.odometry, observation.odometry);
  EXPECT_EQ(received.v, 0.4);
  EXPECT_EQ(received.vy, -0.5);
  EXPECT_EQ(received.w, 0.6);
  EXPECT_EQ(received.goal_in_robot, observation.goal_in_robot);
  ASSERT_EQ(received.scan->getScanSize(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(received.scan->getScanRange(i), ranges[i]);
    EXPECT_EQ(received.scan->getScanRangeValidity(i), valid[i] != 0);
  }
}

/// Truncated messages are invalid wherever they end, and nothing is read beyond the end.
TEST(Protocol, RefusesTruncatedMessages) {
  const auto hello = encoded(make_hello("mine", RobotModel(), SensorModel(), {{"gain", "2"}}));
  observation_t observation = {};
  observation.rays = 2;
  observation.ranges = {1, 2};
  const auto encoded_observation = encoded(observation);
  ASSERT_TRUE(decodes<hello_t>(hello));
  ASSERT_TRUE(decodes<observation_t>(encoded_observation));
  for (std::size_t size = 0; size < hello.size(); ++size)
    EXPECT_FALSE(decodes<hello_t>({hello.begin(), hello.begin() + static_cast<long>(size)}));
  for (std::size_t size = 0; size < encoded_observation.size(); ++size)
    EXPECT_FALSE(decodes<observation_t>(
        {encoded_observation.begin(), encoded_observation.begin() + static_cast<long>(size)}));
}

TEST(Protocol, RefusesOtherMessagesAndTrailingBytes) {
  command_t command = {};
  auto bytes = encoded(command);
  EXPECT_FALSE(decodes<run_end_t>(bytes));
  bytes.push_back(0);
  EXPECT_FALSE(decodes<command_t>(bytes));
}

/// A layout that lacks a field would reject valid messages.
TEST(Protocol, KnowsTheLayoutOfEachMessage) {
  EXPECT_TRUE(decodes<hello_t>(encoded(hello_t{})));
  EXPECT_TRUE(decodes<ready_t>(encoded(ready_t{})));
  EXPECT_TRUE(decodes<goal_heading_t>(encoded(goal_heading_t{})));
  EXPECT_TRUE(decodes<run_start_t>(encoded(run_start_t{})));
  EXPECT_TRUE(decodes<observation_t>(encoded(observation_t{})));
  EXPECT_TRUE(decodes<command_t>(encoded(command_t{})));
  EXPECT_TRUE(decodes<run_end_t>(encoded(run_end_t{})));
  EXPECT_TRUE(decodes<error_t>(encoded(error_t{})));
}

/// Sizes for which a decoder would allocate gigabytes, and negative lengths.
TEST(Protocol, RefusesSizesBeyondTheMessage) {
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
