// SPDX-License-Identifier: BSD-3-Clause
#include "measured_run.h"

#include <slalom/scenario/grid_map.h>

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace slalom::testing {
namespace {

// Common errors of metric implementations, each as a test that detects them. Those covered by the
// tests of a metric are not repeated: accelerations not divided by dt and jerk as
// acceleration over dt (acceleration_test), yaw mixed into length (path_quality_test), unwrapped
// headings (turning_test), intervals still open at the end of the log (clearance_test,
// motion_time_test).

std::map<std::string, Value> all_values(const MeasuredRun& run) {
  std::map<std::string, Value> values;
  for (const Metric& metric : all_metrics())
    values.emplace(metric.info.id, run.value(metric.info.id));
  return values;
}

TEST(ClassicErrors, ARunWithoutMotionIsNoSuccess) {
  for (const Outcome outcome : enum_values<Outcome>()) {
    MeasuredRun run({{2, 5}, {2, 5}});
    run.outcome = outcome;
    if (outcome == Outcome::Success) continue;
    for (const std::string id : {"success", "spl", "soft_spl", "barn_score_v2"}) {
      const Value value = run.value(id);
      EXPECT_TRUE(value.is_na() || value.number() == 0) << id << " " << to_string(outcome);
    }
  }
}

TEST(ClassicErrors, FailedRunsAreNaInsteadOfNeutralValues) {
  MeasuredRun run({{2, 5}, {4, 5}, {5, 5}});
  for (const Outcome outcome : enum_values<Outcome>()) {
    if (outcome == Outcome::Success) continue;
    run.outcome = outcome;
    for (const std::string id :
         {"optimality", "optimality_area", "safety", "safety_area", "optisafe", "path_excess",
          "time_to_goal", "time_ratio", "path_irregularity", "frechet_to_reference",
          "hausdorff_to_reference"})
      EXPECT_EQ(run.reason(id), "outcome: " + to_string(outcome)) << id;
  }
}

TEST(ClassicErrors, DegenerateRunsAreNaInsteadOfZeroOrInfinity) {
  const std::set<std::string> counted = {
      "success",   "spl",           "soft_spl", "barn_score_v2",  "path_length",
      "par2_time", "min_clearance", "progress", "final_distance", "closest_distance"};
  MeasuredRun run({{2, 5}});  // one sample
  run.outcome = Outcome::MethodCrash;
  for (const auto& [id, value] : all_values(run)) {
    EXPECT_EQ(value.is_na(), counted.count(id) == 0) << id;
    EXPECT_EQ(value.is_na(), !value.reason().empty()) << id;
  }
  MeasuredRun still({{8, 5}, {8, 5}, {8, 5}, {8, 5}});  // stays at its goal
  still.set_shortest({{8, 5}});
  still.set_safest({{8, 5}});
  for (const std::string id :
       {"optimality", "optimality_area", "safety", "safety_area", "optisafe", "spl", "soft_spl",
        "barn_score_v2", "path_excess", "time_ratio", "mean_clearance", "min_time_to_collision",
        "progress", "angle_over_length", "bending_energy", "max_curvature", "path_irregularity",
        "sparc", "log_dimensionless_jerk"})
    EXPECT_NE(still.reason(id), "") << id;
}

TEST(ClassicErrors, ClearanceIsGroundTruthIndependentOfTheSensor) {
  // Backward, up to 0.3 m from a disc behind the robot, outside the scan.
  const Primitives disc{{Disc{{4, 5}, 0.475}}, {}};  // occupies cells up to x = 4.5 on its axis
  MeasuredRun run({{7, 5}, {6, 5}, {5.05, 5}}, disc);
  for (Sample& sample : run.trajectory.samples) sample.v = -1;
  EXPECT_NEAR(run.number("min_clearance"), 5.05 - 4.5 - 0.25, 1e-6);
  EXPECT_GT(run.number("risk_time_ratio"), 0);
  EXPECT_NEAR(run.number("min_time_to_collision"), 0.3 / 9.5, 1e-6);  // 0.95 m in 0.1 s
}

TEST(ClassicErrors, PathAndObstaclesShareFrameAndAxisOrder) {
  // The occupied cell is [-1.2, -0.7] x [7.6, 8.1].
  auto map = make_grid_map(20, 6, 0.5, {-3.2, 7.1});
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 20; ++x) map.setCell(x, y, x == 4 && y == 1 ? 0.0F : 1.0F);
  const World world(Scenario::grid("shifted", map, {-2.5, 7.6, 0}, {5, 8.6}), 0.5);
  const RobotModel robot;
  const auto clearance_at = [&](double x, double y) {
    return footprint_clearance(world, robot.shape(), {x, y, 0});
  };
  EXPECT_NEAR(clearance_at(-0.1, 7.85), 0.6 - 0.25, 1e-5);                  // right of it
  EXPECT_NEAR(clearance_at(-1.7, 7.85), 0.5 - 0.25, 1e-5);                  // left
  EXPECT_NEAR(clearance_at(-0.95, 8.7), 0.6 - 0.25, 1e-5);                  // above
  EXPECT_NEAR(clearance_at(-0.4, 8.5), std::hypot(0.3, 0.4) - 0.25, 1e-5);  // near its corner
  EXPECT_NEAR(clearance_at(6.2, 8.6), 0.6 - 0.25, 1e-5);  // the border's right side
}

TEST(ClassicErrors, ValuesAreInvariantUnderRotation) {
  // The same run along x in a wide room and along y in a high one.
  const Path path = {{2, 5}, {4, 5.5}, {5, 4}, {7.9, 5}};
  MeasuredRun along_x(path);
  const World high(Scenario::continuous("high", {0, -10, 10, 18}, {}, {5, 2, M_PI / 2}, {5, 8}),
                   0.05);
  Trajectory turned = along_x.trajectory;
  for (Sample& sample : turned.samples)
    sample.pose = {10 - sample.pose.y, sample.pose.x, sample.pose.phi + M_PI / 2};
  MeasuredRun references({});
  references.set_shortest({{5, 2}, {5, 8}});
  references.references.safest = along_x.references.safest;
  references.references.safest->path = {{5, 2}, {5, 8}};
  const MetricContext context = make_metric_context(high, along_x.robot, turned, Outcome::Success,
                                                    references.references, 60, 0.2);
  for (const Metric& metric : all_metrics()) {
    const std::string id = metric.info.id;
    const Value value = metric.compute(context), expected = along_x.value(id);
    ASSERT_EQ(value.is_na(), expected.is_na()) << id;
    if (!value.is_na()) {
      EXPECT_NEAR(value.number(), expected.number(), 1e-5) << id;
    }
  }
}

TEST(Metrics, AreIndependentOfEachOther) {
  MeasuredRun run({{2, 5}, {3, 5.5}, {5, 4}, {6, 5}, {7.9, 5}});
  run.trajectory.samples[2].v = 1;
  const MetricContext context = make_metric_context(run.world, run.robot, run.trajectory,
                                                    run.outcome, run.references, 60, 0.2);
  std::map<std::string, Value> together;
  for (auto metric = all_metrics().rbegin(); metric != all_metrics().rend(); ++metric)
    together.emplace(metric->info.id, metric->compute(context));
  for (const Metric& metric : all_metrics()) {
    const MeasuredRun alone({{2, 5}, {3, 5.5}, {5, 4}, {6, 5}, {7.9, 5}});
    const MetricContext its_own = make_metric_context(alone.world, run.robot, run.trajectory,
                                                      run.outcome, run.references, 60, 0.2);
    EXPECT_EQ(metric.compute(its_own), together.at(metric.info.id)) << metric.info.id;
  }
}

}  // namespace
}  // namespace slalom::testing
