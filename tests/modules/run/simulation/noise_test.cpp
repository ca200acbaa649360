// SPDX-License-Identifier: BSD-3-Clause
#include "odometry.h"
#include "pose_history.h"
#include "test_runs.h"

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

using mrpt::math::TPose2D;

/// The ranges of the first scans of a run under constant commands.
std::vector<std::vector<double>> scans(const SensorModel& sensor, std::uint64_t seed = 1,
                                       const OdometryModel& odometry = {}) {
  RandomEngine random(4);
  const World world = random_cells(random, 0.03);
  std::vector<std::vector<double>> scans;
  FunctionMethod method([&](const Observation& o) {
    scans.emplace_back();
    for (std::size_t i = 0; i < o.scan->getScanSize(); ++i)
      scans.back().push_back(o.scan->getScanRange(i));
    return Command{0.2, 0.3};
  });
  RunSetup setup;
  setup.robot.radius = 0.05;
  setup.sensor = sensor;
  setup.odometry = odometry;
  setup.simulation.max_time = 1;
  simulate(world, setup, seed, method);
  return scans;
}

SensorModel sensor_with(double noise, double dropout, double quantum = 0) {
  SensorModel sensor;
  sensor.noise_sigma = noise;
  sensor.dropout_ratio = dropout;
  sensor.quantum = quantum;
  return sensor;
}

TEST(Noise, OfRangesHasTheConfiguredDeviation) {
  const auto clean = scans(sensor_with(0, 0)), noisy = scans(sensor_with(0.03, 0));
  double sum = 0, squares = 0;
  int n = 0;
  for (std::size_t k = 0; k < clean.size(); ++k)
    for (std::size_t i = 0; i < clean[k].size(); ++i) {
      if (clean[k][i] >= 7.8 || clean[k][i] < 0.2) continue;  // cut off at the ends
      const double error = noisy[k][i] - clean[k][i];
      sum += error;
      squares += error * error;
      ++n;
    }
  ASSERT_GT(n, 1000);
  // The mean's own deviation is sigma / sqrt(n), the deviation's sigma / sqrt(2 n): four of each.
  EXPECT_NEAR(sum / n, 0, 4 * 0.03 / std::sqrt(n));
  EXPECT_NEAR(std::sqrt(squares / n), 0.03, 4 * 0.03 / std::sqrt(2.0 * n));
}

TEST(Noise, DropoutsHaveTheConfiguredRatio) {
  const auto clean = scans(sensor_with(0, 0)), dropped = scans(sensor_with(0, 0.2));
  int n = 0, gone = 0;
  for (std::size_t k = 0; k < clean.size(); ++k)
    for (std::size_t i = 0; i < clean[k].size(); ++i) {
      if (clean[k][i] >= 8) continue;
      ++n;
      if (dropped[k][i] == clean[k][i]) continue;
      EXPECT_EQ(dropped[k][i], 8) << "as if there were no obstacle";
      ++gone;
    }
  EXPECT_NEAR(static_cast<double>(gone) / n, 0.2, 4 * std::sqrt(0.2 * 0.8 / n));
}

TEST(Noise, QuantizedRangesAreMultiples) {
  const auto clean = scans(sensor_with(0, 0)), rounded = scans(sensor_with(0, 0, 0.05));
  for (std::size_t k = 0; k < clean.size(); ++k)
    for (std::size_t i = 0; i < clean[k].size(); ++i) {
      EXPECT_NEAR(rounded[k][i], clean[k][i], 0.025 + 1e-6);
      EXPECT_NEAR(std::remainder(rounded[k][i], 0.05), 0, 1e-6);
    }
}

TEST(Noise, OneOptionDoesNotChangeTheNumbersOfAnother) {
  const auto noisy = scans(sensor_with(0.03, 0)), both = scans(sensor_with(0.03, 0.2));
  const auto drifting = scans(sensor_with(0.03, 0), 1, {0.1, 0.1});
  int kept = 0;
  for (std::size_t k = 0; k < noisy.size(); ++k) {
    EXPECT_EQ(noisy[k], drifting[k]);
    for (std::size_t i = 0; i < noisy[k].size(); ++i)
      if (both[k][i] < 8) {
        EXPECT_EQ(both[k][i], noisy[k][i]);
        ++kept;
      }
  }
  EXPECT_GT(kept, 500);
}

TEST(Noise, DependsOnTheSeedOnly) {
  EXPECT_EQ(scans(sensor_with(0.03, 0.1), 5), scans(sensor_with(0.03, 0.1), 5));
  EXPECT_NE(scans(sensor_with(0.03, 0.1), 5), scans(sensor_with(0.03, 0.1), 6));
}

TEST(Latency, GivesTheScanOfAnEarlierPose) {
  // Moving straight towards a wall 5 m away with scans 0.2 s old: the range ahead is that of 0.2 s
  // ago.
  const World world = square_world({5, 5, 0}, {9, 5});
  std::vector<double> ahead, x;
  std::vector<double> stamps;
  FunctionMethod method([&](const Observation& o) {
    ahead.push_back(o.scan->getScanRange(90));
    x.push_back(o.odometry.x);
    stamps.push_back(mrpt::Clock::toDouble(o.scan->timestamp));
    return Command{1, 0};
  });
  RunSetup setup;
  setup.sensor.latency = 0.2;
  simulate(world, setup, 1, method);
  ASSERT_GT(x.size(), 30U);
  EXPECT_NEAR(ahead[0], 5, 1e-5);
  for (std::size_t k = 2; k < x.size(); ++k) EXPECT_NEAR(ahead[k], 10 - x[k - 2], 1e-5);
  EXPECT_NEAR(stamps[10] - stamps[9], 0.1, 1e-6);
  EXPECT_NEAR(stamps[10] - stamps[0], 0.8, 1e-6) << "the first scan is of the start";
}

TEST(PoseHistory, GivesTheLastPoseAtOrBeforeATime) {
  PoseHistory history(0.5);
  for (int i = 0; i <= 200; ++i) history.add(0.01 * i, {static_cast<double>(i), 0, 0});
  EXPECT_EQ(history.at(2.0).x, 200);
  EXPECT_EQ(history.at(1.995).x, 199);
  EXPECT_EQ(history.at(1.5).x, 150);
}

TEST(Odometry, IsExactWithoutDrift) {
  Odometry odometry({}, 1, {1, 2, 3});
  odometry.move({1, 2, 3}, {1.1, 2.05, 3.01});
  EXPECT_EQ(odometry.pose(), TPose2D(1.1, 2.05, 3.01));
}

/// The odometry pose after 4 m straight, in `steps` steps.
TPose2D odometry_after(const OdometryModel& model, int steps, std::uint64_t seed) {
  Odometry odometry(model, seed, {0, 0, 0});
  for (int i = 0; i < steps; ++i)
    odometry.move({4.0 * i / steps, 0, 0}, {4.0 * (i + 1) / steps, 0, 0});
  return odometry.pose();
}

TEST(Odometry, DriftsAsARandomWalkIndependentOfTheSteps) {
  // 4 m with a deviation of 0.02 m after 1 m: 0.04 m.
  for (const int steps : {4, 400}) {
    double squares = 0;
    constexpr int kRuns = 2000;
    for (int seed = 0; seed < kRuns; ++seed) {
      const double error = odometry_after({0.02, 0}, steps, seed).x - 4;
      squares += error * error;
    }
    EXPECT_NEAR(std::sqrt(squares / kRuns), 0.04, 4 * 0.04 / std::sqrt(2.0 * kRuns)) << steps;
  }
}

TEST(Odometry, DriftAffectsObservationsNotTheOutcome) {
  const World world = square_world({1, 5, 0}, {8, 5});
  RunSetup setup;
  setup.odometry = {0.1, 0.1};
  double estimated_x = 0;
  FunctionMethod method([&](const Observation& o) {
    estimated_x = o.odometry.x;
    EXPECT_NEAR(o.goal_in_robot.x, 8 - o.odometry.x, 1e-9) << "the goal relative to odometry";
    return Command{0.5, 0};
  });
  const SimulationResult result = simulate(world, setup, 3, method);
  ASSERT_EQ(result.outcome, Outcome::Success);
  EXPECT_NEAR(result.trajectory.samples.back().pose.x, 7.8, 1e-2);
  EXPECT_GT(std::abs(estimated_x - 7.8), 0.02);
}

}  // namespace
}  // namespace slalom::testing
