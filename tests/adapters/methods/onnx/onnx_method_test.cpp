// SPDX-License-Identifier: BSD-3-Clause
// The networks are linear (networks/make_networks.py): of the inputs x0, x1, ... the first output
// is the sum of 2^i xi, the second the sum of i xi.
#include "error_text.h"
#include "places.h"

#include <slalom/onnx/onnx_method.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

const std::string kNetworks = kSource + "/tests/adapters/methods/onnx/networks";

/// Line 3 contains the model, further keys start at line 4.
std::string section_for(const std::string& model, const std::string& keys = "") {
  return "[method.a]\nadapter = onnx\nmodel = " + model + "\n" + keys;
}

/// A robot whose limits cut nothing off.
RobotModel fast_robot() {
  RobotModel robot;
  robot.max_v = robot.max_w = 1000;
  robot.forward_only = false;
  return robot;
}

SensorModel sensor_with(int rays) {
  SensorModel sensor;
  sensor.rays = rays;
  sensor.max_range = 8;
  return sensor;
}

std::unique_ptr<Method> load(const std::string& ini_text, const RobotModel& robot,
                             const SensorModel& sensor) {
  const IniFile ini = IniFile::from_text(ini_text, kNetworks + "/campaign.ini");
  auto method = read_onnx_method(ini, "method.a")(robot, sensor);
  method->reset({});
  return method;
}

testing::AssertionResult refuses(const std::string& ini_text, const std::string& where,
                                 std::initializer_list<std::string> words) {
  return throws_error(ErrorKind::Usage, kNetworks + "/campaign.ini:" + where, words,
                      [&] { load(ini_text, {}, sensor_with(3)); });
}

Command step(Method& method, const std::vector<float>& ranges) {
  mrpt::obs::CObservation2DRangeScan scan;
  scan.resizeScan(ranges.size());
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    scan.setScanRange(i, ranges[i]);
    scan.setScanRangeValidity(i, ranges[i] < 8);
  }
  Observation observation;
  observation.v = 250;
  observation.w = -500;
  observation.vy = 125;
  observation.goal_in_robot = {3, 4};
  observation.scan = &scan;
  return method.step(observation);
}

/// The values of goal and velocity for the observation of step() with fast_robot(): at 5 of 10 m,
/// in the direction (3, 4) / 5.
const std::vector<double> kState = {0.5, 0.6, 0.8, 0.25, -0.5};

double weighted(const std::vector<double>& values, double (*weight)(double)) {
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) sum += weight(static_cast<double>(i)) * values[i];
  return sum;
}

double power(double i) {
  return std::exp2(i);
}

double itself(double i) {
  return i;
}

std::vector<double> with_state(std::vector<double> scan) {
  scan.insert(scan.end(), kState.begin(), kState.end());
  return scan;
}

constexpr char kPhysical[] = "output = physical\n";

TEST(OnnxMethod, EvaluatesTheNetworkOnScanGoalAndVelocity) {
  const auto method = load(section_for("linear.onnx", kPhysical), fast_robot(), sensor_with(3));
  const std::vector<double> values = with_state({0.125, 0.5, 1});
  const Command command = step(*method, {1, 4, 8});
  EXPECT_NEAR(command.v, weighted(values, power), 1e-4);
  EXPECT_NEAR(command.w, weighted(values, itself), 1e-5);
  EXPECT_EQ(command.vy, 0);
}

TEST(OnnxMethod, GivesMinimaOfGroupsOfRaysWithTheScalingOfTheOption) {
  // Seven rays in three groups: 0 to 1, 2 to 3, 4 to 6.
  const std::vector<float> ranges = {2, 6, 8, 4, 7, 1, 3};
  const auto scan_of = [&](const std::string& scaling) {
    const auto method =
        load(section_for("linear.onnx", std::string(kPhysical) +
                                            "scan_size = 3\nscan_scaling = " + scaling + "\n"),
             fast_robot(), sensor_with(7));
    return step(*method, ranges).v;
  };
  EXPECT_NEAR(scan_of("divide"), weighted(with_state({0.25, 0.5, 0.125}), power), 1e-4);
  EXPECT_NEAR(scan_of("inverse"), weighted(with_state({0.75, 0.5, 0.875}), power), 1e-4);
  EXPECT_NEAR(scan_of("none"), weighted(with_state({2, 4, 1}), power), 1e-4);
}

TEST(OnnxMethod, GivesNamedInputsInTheirShapes) {
  const auto method =
      load(section_for("named.onnx", std::string(kPhysical) +
                                         "inputs = scan: scan as 1x1x4; state: goal, velocity\n"),
           fast_robot(), sensor_with(4));
  const Command command = step(*method, {1, 2, 4, 8});
  EXPECT_NEAR(command.v, weighted(with_state({0.125, 0.25, 0.5, 1}), power), 1e-3);
}

TEST(OnnxMethod, ScaledOutputsAreFractionsOfTheLimitsAndCutOffThere) {
  RobotModel robot;
  robot.max_v = 2;
  robot.max_w = 3;
  const std::string only_scan = "inputs = scan\n";
  // Eight rays: v is the sum of 2^i xi, w that of i xi.
  const auto command_for = [&](int ray, float range) {
    const auto method = load(section_for("linear.onnx", only_scan + "scan_scaling = inverse\n"),
                             robot, sensor_with(8));
    std::vector<float> ranges(8, 8.0F);
    ranges[static_cast<std::size_t>(ray)] = range;
    return step(*method, ranges);
  };
  const Command half = command_for(0, 4);
  EXPECT_NEAR(half.v, 0.5 * 2, 1e-6);
  EXPECT_NEAR(half.w, 0, 1e-6);
  const Command above = command_for(3, 4);
  EXPECT_EQ(above.v, 2);
  EXPECT_EQ(above.w, 3);
}

TEST(OnnxMethod, OfAHolonomicRobotHasThreeOutputsWithinItsLimits) {
  RobotModel robot;
  robot.kinematics = Kinematics::Holonomic;
  robot.max_v = 1;
  const auto method = load(section_for("holonomic.onnx", kPhysical), robot, sensor_with(3));
  const Command command = step(*method, {1, 4, 8});
  EXPECT_LE(std::hypot(command.v, command.vy), 1 + 1e-12);
  EXPECT_NE(command.vy, 0);
}

TEST(OnnxMethod, RefusesModelsThatCannotBeRead) {
  EXPECT_TRUE(refuses("[method.a]\nadapter = onnx\n", "1: [method.a]",
                      {"missing model", "model = FILE.onnx"}));
  EXPECT_TRUE(refuses(section_for("none.onnx"),
                      "3: [method.a] model: ", {"'none.onnx' not found", "networks/none.onnx"}));
  EXPECT_TRUE(refuses(section_for("make_networks.py"),
                      "3: [method.a] model: ", {"make_networks.py cannot be read", "ONNX"}));
}

TEST(OnnxMethod, RefusesInputsThatDoNotFit) {
  EXPECT_TRUE(refuses(section_for("linear.onnx", "inputs = scan, gaol\n"),
                      "4: [method.a] inputs: ", {"unknown content 'gaol'", "goal"}));
  EXPECT_TRUE(refuses(section_for("linear.onnx", "inputs = scan as 1xa\n"),
                      "4: [method.a] inputs: ", {"invalid shape '1xa'", "1x1x61"}));
  EXPECT_TRUE(refuses(section_for("linear.onnx", "inputs = scan as 2x2\n"),
                      "4: [method.a] inputs: ", {"the shape 2x2 does not fit", "product of 3"}));
  EXPECT_TRUE(refuses(section_for("linear.onnx", "inputs = scan; goal\n"),
                      "4: [method.a] inputs: ", {"no name"}));
  EXPECT_TRUE(refuses(section_for("linear.onnx", "inputs = scan\n"),
                      "4: [method.a] inputs: ", {"the network failed", "1x3", "was trained"}));
  EXPECT_TRUE(refuses(section_for("linear.onnx", "scan_size = 4\n"),
                      "4: [method.a] scan_size: ", {"above the number of rays", "at most 3"}));
}

TEST(OnnxMethod, RefusesAnotherNumberOfOutputs) {
  const std::string where = kNetworks + "/campaign.ini:3: [method.a] model: ";
  EXPECT_TRUE(throws_error(ErrorKind::Usage, where, {"has 3 outputs", "expected 2: v, w"}, [] {
    load(section_for("holonomic.onnx"), RobotModel(), sensor_with(4));
  }));
  RobotModel holonomic;
  holonomic.kinematics = Kinematics::Holonomic;
  EXPECT_TRUE(throws_error(ErrorKind::Usage, where, {"has 2 outputs", "expected 3: v, w, vy"},
                           [&] { load(section_for("linear.onnx"), holonomic, sensor_with(2)); }));
}

}  // namespace
}  // namespace slalom
