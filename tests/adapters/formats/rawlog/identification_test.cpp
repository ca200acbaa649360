// SPDX-License-Identifier: BSD-3-Clause
#include "recorded_runs.h"

#include <slalom/core/text.h>
#include <slalom/rawlog/identification.h>
#include <slalom/robot/vehicle.h>

#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <nlohmann/json.hpp>

#include <error_text.h>

namespace slalom {
namespace {

using mrpt::obs::CObservation2DRangeScan;

/// True parameters of a robot in a test.
struct Planted {
  RobotModel robot;
  double v_bias = 1, w_bias = 1;
  double velocity_noise = 0;  ///< m/s, rad/s
  double period = 0.1;        ///< s, of the odometry
  double duration = 46;       ///< s
  SensorModel sensor;
  std::uint64_t seed = 1;
};

/// A robot whose acceleration limits are never reached.
RobotModel strong_robot(double delay, double tau) {
  RobotModel robot;
  robot.delay = delay;
  robot.delay_tau = tau;
  robot.max_accel_v = robot.max_accel_w = 1e3;
  return robot;
}

constexpr double kCommandPeriod = 0.1;  // s

/// At rest, a step, at rest, random steps of 0.1 to 1 s. A drive of less than 20 s has no rest.
std::vector<Command> script(double duration, RandomEngine& random) {
  std::vector<Command> commands;
  const auto hold = [&](const Command& command, int cycles) {
    commands.insert(commands.end(), static_cast<std::size_t>(cycles), command);
  };
  if (duration >= 20) {
    hold({}, 40);
    hold({0.6, 0.5}, 20);
    hold({}, 100);
  }
  while (static_cast<double>(commands.size()) < duration / kCommandPeriod) {
    const int cycles = uniform_int(random, 1, 10);  // compilers order arguments differently
    hold({uniform_real(random, 0, 1), uniform_real(random, -1.2, 1.2)}, cycles);
  }
  return commands;
}

CObservation2DRangeScan::Ptr noisy_scan(const SensorModel& sensor, RandomEngine& random) {
  auto scan = CObservation2DRangeScan::Create();
  scan->maxRange = static_cast<float>(sensor.max_range);
  scan->resizeScan(static_cast<std::size_t>(sensor.rays));
  for (std::size_t i = 0; i < scan->getScanSize(); ++i) {
    const double distance = 1.2 + 5.5 * std::fmod(0.618034 * static_cast<double>(i), 1);
    double range = distance + normal(random, 0, sensor.noise_sigma);
    if (sensor.quantum > 0) range = sensor.quantum * std::round(range / sensor.quantum);
    if (uniform_real(random, 0, 1) < sensor.dropout_ratio) range = sensor.max_range;
    scan->setScanRange(i, static_cast<float>(std::min(range, sensor.max_range)));
    scan->setScanRangeValidity(i, range < sensor.max_range);
  }
  return scan;
}

/// The log of the drive of modules/world/robot.
MotionLog drive(const Planted& planted) {
  constexpr double kStep = 0.01;  // s
  RandomEngine random(planted.seed);
  const auto vehicle = make_vehicle(planted.robot);
  vehicle->start_at({});
  MotionLog log;
  const int steps = static_cast<int>(std::lround(kCommandPeriod / kStep));
  const int steps_of_odometry = static_cast<int>(std::lround(planted.period / kStep));
  int step = 0;
  for (const Command& command : script(planted.duration, random)) {
    log.commands.push_back({step * kStep, command.v, command.w});
    log.scans.push_back({step * kStep, noisy_scan(planted.sensor, random)});
    vehicle->command(command.v, command.w);
    for (int i = 0; i < steps; ++i, ++step) {
      if (step % steps_of_odometry == 0)
        log.odometry.push_back(
            {step * kStep,
             planted.v_bias * vehicle->v() + normal(random, 0, planted.velocity_noise),
             planted.w_bias * vehicle->w() + normal(random, 0, planted.velocity_noise)});
      vehicle->advance(kStep);
    }
  }
  return log;
}

/// Whether an estimate is within 5 % of a planted value other than 0.
::testing::AssertionResult is_close(const Identification& found, const std::string& id,
                                    double planted) {
  const Value& value = found.at(id).value;
  if (!value.is_na() && std::abs(value.number() - planted) <= 0.05 * planted)
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << id << " = " << format_value(value) << ", planted " << planted;
}

/// Whether the interval of an estimate contains a planted value. Intervals that end at it do not
/// miss it by rounding.
bool covers(const Identification& found, const std::string& id, double planted) {
  const auto& interval = found.at(id).interval;
  constexpr double kRounding = 1e-12;
  return interval && interval->low <= planted + kRounding && planted <= interval->high + kRounding;
}

TEST(Identify, RecoversThePlantedResponse) {
  for (const double period : {0.1, 0.02})
    for (const double noise : {0.0, 0.005})
      for (const auto& [delay, tau] : {std::pair{0.12, 0.3}, {0.07, 0.1}, {0.4, 1.0}}) {
        SCOPED_TRACE(::testing::Message() << period << " " << noise << " " << delay << " " << tau);
        Planted planted;
        planted.robot = strong_robot(delay, tau);
        planted.period = period;
        planted.velocity_noise = noise;
        planted.v_bias = 0.9;
        planted.w_bias = 1.1;
        const Identification found = identify(drive(planted), {});
        EXPECT_TRUE(is_close(found, "delay", delay));
        EXPECT_TRUE(is_close(found, "delay_tau", tau));
        EXPECT_TRUE(is_close(found, "v_bias", 0.9));
        EXPECT_TRUE(is_close(found, "w_bias", 1.1));
        EXPECT_TRUE(found.warnings.empty()) << found.warnings.front();
      }
}

TEST(Identify, LimitedAccelerationIsNoLag) {
  Planted planted;
  planted.robot.delay = 0.12;
  planted.robot.delay_tau = 0.2;  // steps of more than 0.2 m/s and 0.6 rad/s are limited
  planted.velocity_noise = 0.005;
  const MotionLog log = drive(planted);
  for (const auto& known : {std::optional<RobotModel>(), std::optional(planted.robot)}) {
    const Identification found = identify(log, {1, known});
    EXPECT_TRUE(is_close(found, "delay", 0.12));
    EXPECT_TRUE(is_close(found, "delay_tau", 0.2));
  }
}

// The law: without delay and lag the intervals of both contain 0, limited or not. Between two
// velocities measured 0.1 s apart any delay below 0.1 s has the same effect, and the interval of
// delays of a robot without limits says so.
TEST(Identify, ARobotWithoutDelayAndLagHasNone) {
  for (const RobotModel& robot : {strong_robot(0, 0), RobotModel()})
    for (const double period : {0.1, 0.02}) {
      Planted planted;
      planted.robot = robot;
      planted.period = period;
      const Identification found = identify(drive(planted), {1, robot});
      EXPECT_TRUE(covers(found, "delay", 0)) << period;
      EXPECT_TRUE(covers(found, "delay_tau", 0)) << period;
      EXPECT_TRUE(is_close(found, "v_bias", 1));
      EXPECT_TRUE(is_close(found, "w_bias", 1));
      EXPECT_LT(found.at("delay").interval->high, period * 1.02);
      const bool is_limited = robot.max_accel_v < 100;
      EXPECT_EQ(found.at("delay").interval->high < 0.9 * period, is_limited) << period;
    }
}

/// How many of 4 intervals of each of 40 logs contain what was planted.
int covered(Planted planted) {
  constexpr int kLogs = 40;
  int count = 0;
  planted.velocity_noise = 0.02;
  for (int i = 0; i < kLogs; ++i) {
    planted.seed = 100 + static_cast<std::uint64_t>(i);
    const Identification found = identify(drive(planted), {});
    count += covers(found, "delay", planted.robot.delay) +
             covers(found, "delay_tau", planted.robot.delay_tau) + covers(found, "v_bias", 1) +
             covers(found, "w_bias", 1);
  }
  return count;
}

// 95 % intervals: of 160 of one kind 152 +- 2.8 contain the truth if they are independent, of all
// 800 they are 0.95 +- 0.008. Intervals of parameters at a bound are wider: up to 97.5 % of tau,
// and 100 % of delays between two measurements.
TEST(Identify, IntervalsContainTheTruthAsOftenAsTheyClaim) {
  RobotModel weak;
  weak.delay = 0.12;
  weak.delay_tau = 0.2;
  weak.max_accel_v = 0.5;
  weak.max_accel_w = 1;
  int all = 0;
  const auto check = [&](const std::string& kind, const RobotModel& robot, double duration) {
    Planted planted;
    planted.robot = robot;
    planted.duration = duration;
    planted.sensor.rays = 3;
    const int count = covered(planted);
    all += count;
    EXPECT_GE(count, 146) << kind;  // 2 deviations
  };
  check("lag, 20 s", strong_robot(0.12, 0.3), 19.9);
  check("lag, 8 s", strong_robot(0.12, 0.3), 8);
  check("lag, 5 s", strong_robot(0.12, 0.3), 5);
  check("no lag, 8 s", strong_robot(0, 0), 8);
  check("limited, 10 s", weak, 10);
  EXPECT_GE(all, 0.93 * 800);
  EXPECT_LE(all, 0.97 * 800);
}

TEST(Identify, WarnsIfTheVelocitiesDiffer) {
  Planted planted;
  planted.robot = strong_robot(0.1, 0.3);
  MotionLog log = drive(planted);
  planted.robot = strong_robot(0.3, 0.3);
  const MotionLog slower = drive(planted);
  for (std::size_t i = 0; i < log.odometry.size(); ++i) log.odometry[i].w = slower.odometry[i].w;
  const Identification found = identify(log, {});
  ASSERT_EQ(found.warnings.size(), 1U);
  EXPECT_TRUE(mentions(found.warnings[0], {"delay", "0.1000", "0.3000"}));
}

TEST(Identify, RecoversThePlantedRangeNoise) {
  for (const double quantum : {0.0, 0.01, 0.03}) {
    Planted planted;
    planted.robot = strong_robot(0.1, 0.2);
    planted.sensor.noise_sigma = 0.02;
    planted.sensor.dropout_ratio = 0.1;
    planted.sensor.quantum = quantum;
    const Identification found = identify(drive(planted), {});
    EXPECT_TRUE(is_close(found, "noise_sigma", 0.02));
    EXPECT_TRUE(is_close(found, "dropout_ratio", 0.1));
    EXPECT_NEAR(found.at("quantum").value.number(), quantum, 1e-6);
    EXPECT_TRUE(covers(found, "noise_sigma", 0.02));
    EXPECT_TRUE(covers(found, "dropout_ratio", 0.1));
    const Interval interval = *found.at("noise_sigma").interval;
    EXPECT_LT(interval.high - interval.low, 2e-3);
  }
}

// Clopper and Pearson's bound of no event in n: (1 - p)^n = 0.025.
TEST(Identify, NoDropoutInAFewRangesHasAnUpperBound) {
  Planted planted;
  planted.sensor.noise_sigma = 0.02;
  const Identification found = identify(drive(planted), {});
  const Estimate& dropout = found.at("dropout_ratio");
  EXPECT_EQ(dropout.value.number(), 0);
  const double n = static_cast<double>(dropout.samples);
  EXPECT_EQ(dropout.interval->low, 0);
  EXPECT_NEAR(dropout.interval->high, 1 - std::pow(0.025, 1 / n), 1e-12);
}

TEST(Identify, NoiseBelowHalfAQuantumHasAnUpperBoundOnly) {
  for (const double sigma : {0.0, 0.005, 0.012}) {
    Planted planted;
    planted.sensor.noise_sigma = sigma;
    planted.sensor.quantum = 0.03;
    const Identification found = identify(drive(planted), {});
    EXPECT_TRUE(covers(found, "noise_sigma", sigma)) << sigma;
    EXPECT_EQ(found.at("noise_sigma").interval->low, 0) << sigma;
  }
}

/// Whether of 200 intervals 0.93 to 0.98 contain what was planted: 190 +- 3.1. Those of rare
/// dropouts are a little wider, since they are counts.
::testing::AssertionResult noise_is_covered(const std::string& id, const Planted& planted,
                                            double truth) {
  Planted other = planted;
  other.duration = 4;
  other.robot.max_v = 0;  // stationary
  other.robot.max_w = 0;
  int count = 0;
  for (int i = 0; i < 200; ++i) {
    other.seed = static_cast<std::uint64_t>(i);
    count += covers(identify(drive(other), {}), id, truth);
  }
  if (count >= 186 && count <= 196) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << id << ": " << count << " of 200";
}

TEST(Identify, IntervalsOfRangesContainTheTruthAsOftenAsTheyClaim) {
  Planted planted;
  planted.sensor.rays = 61;
  planted.sensor.noise_sigma = 0.02;
  planted.sensor.dropout_ratio = 0.05;
  EXPECT_TRUE(noise_is_covered("noise_sigma", planted, 0.02));
  EXPECT_TRUE(noise_is_covered("dropout_ratio", planted, 0.05));
  planted.sensor.quantum = 0.01;
  EXPECT_TRUE(noise_is_covered("noise_sigma", planted, 0.02));
}

TEST(Identify, ASensorWithoutNoiseHasNone) {
  const Identification found = identify(drive({}), {});
  EXPECT_EQ(found.at("noise_sigma").value.number(), 0);
  EXPECT_EQ(found.at("dropout_ratio").value.number(), 0);
  EXPECT_EQ(found.at("quantum").value.number(), 0);
}

TEST(Identify, OtherObjectsAreNoNoise) {
  Planted planted;
  planted.sensor.noise_sigma = 0.01;
  MotionLog log = drive(planted);
  for (std::size_t i = 5; i < 9; ++i) {  // someone passes
    auto scan = std::make_shared<CObservation2DRangeScan>(*log.scans[i].scan);
    for (std::size_t ray = 60; ray < 90; ++ray) scan->setScanRange(ray, 0.8F);
    log.scans[i].scan = scan;
  }
  EXPECT_TRUE(is_close(identify(log, {}), "noise_sigma", 0.01));
}

/// The reason for which an estimate is NA.
std::string reason(const MotionLog& log, const std::string& id, double max_delay = 1) {
  return identify(log, {max_delay, std::nullopt}).at(id).value.reason();
}

TEST(Identify, StatesWhyAQuantityIsNotEstimated) {
  Planted planted;
  planted.robot = strong_robot(0.3, 0.2);
  const MotionLog log = drive(planted);
  EXPECT_EQ(reason(log, "delay"), "");
  EXPECT_TRUE(mentions(reason(log, "delay", 0.2), {"delay exceeds", "0.2 s"}));

  MotionLog changed = log;
  changed.commands.clear();
  changed.odometry_labels = {"odometry", "cmd"};
  EXPECT_TRUE(mentions(reason(changed, "v_bias"), {"'command'", "'odometry', 'cmd'"}));
  EXPECT_EQ(reason(changed, "noise_sigma"), "");

  changed = log;
  changed.odometry.clear();
  EXPECT_TRUE(mentions(reason(changed, "delay_tau"), {"'odometry'", "no odometry"}));
  EXPECT_TRUE(mentions(reason(changed, "noise_sigma"), {"'odometry'"}));

  changed = log;
  changed.scans.clear();
  EXPECT_TRUE(mentions(reason(changed, "quantum"), {"no 2D scans"}));

  changed = log;
  for (LoggedVelocity& command : changed.commands) command.v = 0.3;
  EXPECT_TRUE(mentions(reason(changed, "v_bias"), {"commanded", "constant"}));
  EXPECT_EQ(reason(changed, "delay"), "");  // of w
  EXPECT_EQ(identify(changed, {}).at("delay").samples, identify(log, {}).at("w_bias").samples);

  changed = log;
  for (LoggedVelocity& velocity : changed.odometry) velocity.v = velocity.w = 0.1;
  EXPECT_TRUE(mentions(reason(changed, "delay"), {"measured", "constant"}));
  EXPECT_TRUE(mentions(reason(changed, "noise_sigma"), {"stationary for at most 0 scans", "20"}));

  changed = log;
  RandomEngine random(3);
  for (LoggedVelocity& velocity : changed.odometry) velocity.v = uniform_real(random, 0, 1);
  EXPECT_TRUE(mentions(reason(changed, "v_bias"), {"does not follow"}));

  changed = log;
  changed.odometry.resize(25);
  EXPECT_TRUE(mentions(reason(changed, "delay"), {"only 15 velocities", "20"}));
}

// Gain and time constant of a step that is not over at the end of the log are not told apart.
TEST(Identify, NoTimeConstantOfAStepThatIsNotOver) {
  MotionLog log;
  RandomEngine random(5);
  for (int i = 0; i <= 80; ++i) {
    const double t = 0.1 * i, step = 5, tau = 4;
    const double v = t < step ? 0 : 0.5 * (1 - std::exp((step - t) / tau));
    log.commands.push_back({t, t < step ? 0 : 0.5, 0});
    log.odometry.push_back({t, v + normal(random, 0, 0.02), 0});
  }
  EXPECT_TRUE(mentions(reason(log, "delay_tau"), {"all values from ", "to 5 s are as likely"}));
  EXPECT_EQ(reason(log, "delay"), "");
}

class IdentifyLog : public testing::RecordedRunTest {};

TEST_F(IdentifyLog, RecoversTheRobotOfARecordedRun) {
  RunSetup setup;
  setup.robot = strong_robot(0.12, 0.3);
  setup.sensor.noise_sigma = 0.02;
  setup.sensor.dropout_ratio = 0.1;
  setup.simulation.max_time = 40;
  setup.simulation.stuck_time = 30;
  RandomEngine random(4);
  Command command;
  int cycle = 0;
  // Stationary for 12 s, then drives to and fro.
  setup.robot.forward_only = false;
  testing::FunctionMethod method([&](const Observation&) {
    if (++cycle > 120 && cycle % 5 == 0) {
      const double forward = cycle % 10 == 0 ? 0.5 : -0.5;
      command = {forward + uniform_real(random, -0.3, 0.3), uniform_real(random, -1, 1), 0};
    }
    return command;
  });
  Primitives ring;
  for (double angle = 0; angle < 2 * M_PI; angle += 0.1)
    ring.discs.push_back({{5 + 4 * std::cos(angle), 5 + 4 * std::sin(angle)}, 0.4});
  const Scenario scenario =
      Scenario::continuous("ring", {0, 0, 10, 10}, ring, {5, 5, 0.1}, {9.8, 9.8});
  testing::simulate_run(path("run.rawlog"), method, setup, 7, scenario);
  const Identification found = identify(read_motion_log(path("run.rawlog")), {});
  EXPECT_TRUE(is_close(found, "delay", 0.12));
  EXPECT_TRUE(is_close(found, "delay_tau", 0.3));
  EXPECT_TRUE(is_close(found, "v_bias", 1));
  EXPECT_TRUE(is_close(found, "w_bias", 1));
  EXPECT_TRUE(is_close(found, "noise_sigma", 0.02));
  EXPECT_TRUE(is_close(found, "dropout_ratio", 0.1));
}

mrpt::obs::CObservationOdometry::Ptr odometry_at(double time, const std::string& label) {
  auto odometry = mrpt::obs::CObservationOdometry::Create();
  odometry->timestamp = mrpt::Clock::fromDouble(1e9 + time);
  odometry->sensorLabel = label;
  return odometry;
}

TEST_F(IdentifyLog, ReadsVelocitiesAndPosesByLabel) {
  mrpt::obs::CRawlog log;
  for (int i = 0; i < 4; ++i) {
    const double t = 0.5 * (3 - i);  // backwards in time
    const auto command = odometry_at(t, "cmd");
    command->hasVelocities = true;
    command->velocityLocal = {t, 0, -t};
    log.insert(command);
  }
  mrpt::obs::CSensoryFrame frame;
  frame.insert(odometry_at(0, "wheels"));
  log.insert(frame);
  const auto moved = odometry_at(0.5, "wheels");
  moved->odometry = mrpt::poses::CPose2D(0.2, 0, 0.1);
  log.insert(moved);
  auto undated = odometry_at(0, "cmd");
  undated->timestamp = INVALID_TIMESTAMP;
  log.insert(undated);
  ASSERT_TRUE(log.saveToRawLogFile(path("log.rawlog")));
  const MotionLog read = read_motion_log(path("log.rawlog"), {"cmd", "wheels", ""});
  ASSERT_EQ(read.commands.size(), 4U);
  EXPECT_NEAR(read.commands[1].time - read.commands[0].time, 0.5, 1e-6);
  EXPECT_EQ(read.commands[3].v, 1.5);
  EXPECT_EQ(read.commands[3].w, -1.5);
  ASSERT_EQ(read.odometry.size(), 1U);
  EXPECT_NEAR(read.odometry[0].v, 0.4, 1e-9);
  EXPECT_NEAR(read.odometry[0].w, 0.2, 1e-9);
  EXPECT_NEAR(read.odometry[0].time - read.commands[0].time, 0.25, 1e-6);
  EXPECT_EQ(read.odometry_labels, (std::vector<std::string>{"cmd", "wheels"}));
}

TEST_F(IdentifyLog, ReadsTheScansOfOneSensor) {
  mrpt::obs::CRawlog log;
  for (const auto& [label, rays] : {std::pair{"front", 9U}, {"rear", 9U}, {"front", 9U}}) {
    auto scan = CObservation2DRangeScan::Create();
    scan->resizeScanAndAssign(rays, 2.0F, true);
    scan->timestamp = mrpt::Clock::fromDouble(1e9);
    scan->sensorLabel = label;
    log.insert(scan);
  }
  ASSERT_TRUE(log.saveToRawLogFile(path("log.rawlog")));
  EXPECT_EQ(read_motion_log(path("log.rawlog")).scans.size(), 2U);
  EXPECT_EQ(read_motion_log(path("log.rawlog"), {"command", "odometry", "rear"}).scans.size(), 1U);
  EXPECT_TRUE(throws_error(ErrorKind::File, path("none.rawlog"), {"cannot be read"},
                           [&] { read_motion_log(path("none.rawlog")); }));
}

/// Estimates of which one is NA.
Identification four_estimates() {
  Identification identification;
  identification.log = "a.rawlog";
  identification.estimates = {
      {"delay", "s", Value::of(0.12), 500, Interval{0.114, 0.126}},
      {"delay_tau", "s", Value::of(0.2000004), 500, Interval{0.192, 0.208}},
      {"v_bias", "-", Value::of(0.9), 250, Interval{0.898, 0.902}},
      {"w_bias", "-", Value::of(1.1), 250, Interval{1.098, 1.102}},
      {"noise_sigma", "m", Value::of(0.0123456), 7240, Interval{0.012, 0.0127}},
      {"dropout_ratio", "-", Value::na("no 2D scans"), 0},
      {"quantum", "m", Value::of(0.01), 7240, {}, "a common divisor, not a mean"}};
  identification.warnings = {"delay differs"};
  return identification;
}

TEST(IdentificationText, EndsWithAFragmentOfAnIni) {
  const std::string text = render_text(four_estimates());
  EXPECT_EQ(text,
            "a.rawlog\n"
            "quantity       estimate      samples  95 % interval\n"
            "delay          0.12 s        500      0.114 to 0.126 s\n"
            "delay_tau      0.2 s         500      0.192 to 0.208 s\n"
            "v_bias         0.9           250      0.898 to 0.902\n"
            "w_bias         1.1           250      1.098 to 1.102\n"
            "noise_sigma    0.01235 m     7240     0.012 to 0.0127 m\n"
            "dropout_ratio  NA (no 2D scans)\n"
            "quantum        0.01 m        7240     NA (a common divisor, not a mean)\n"
            "Warning: delay differs\n"
            "\n"
            "[robot]\n"
            "# v_bias, w_bias: no keys; measured / commanded velocity\n"
            "delay = 0.12\n"
            "delay_tau = 0.2\n"
            "[sensor]\n"
            "noise_sigma = 0.01235\n"
            "# dropout_ratio: NA (no 2D scans)\n"
            "quantum = 0.01\n");
  const IniFile ini = IniFile::from_text(text.substr(text.find("[robot]")));
  EXPECT_EQ(read_robot_model(ini).delay_tau, 0.2);
  EXPECT_EQ(read_options<SensorModel>(ini, "sensor").noise_sigma, 0.01235);
}

TEST(IdentificationText, JsonHasAllNumbers) {
  const auto json = nlohmann::json::parse(render_json(four_estimates()));
  EXPECT_EQ(json["estimates"]["delay_tau"]["value"], 0.2000004);
  EXPECT_EQ(json["confidence"], 0.95);
  EXPECT_EQ(json["estimates"]["delay"]["interval"], nlohmann::json({0.114, 0.126}));
  EXPECT_EQ(json["estimates"]["noise_sigma"]["unit"], "m");
  EXPECT_EQ(json["estimates"]["noise_sigma"]["samples"], 7240);
  EXPECT_EQ(json["estimates"]["dropout_ratio"]["na"], "no 2D scans");
  EXPECT_EQ(json["estimates"]["quantum"]["no_interval"], "a common divisor, not a mean");
  EXPECT_EQ(json["warnings"].size(), 1U);
}

}  // namespace
}  // namespace slalom
