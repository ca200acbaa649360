#include "measured_run.h"

#include <slalom/core/error.h>
#include <slalom/core/random.h>

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

TEST(Metrics, AreListedOnceInTheOrderOfTheDefinitions) {
  const std::vector<std::string> expected = {"success",
                                             "optimality",
                                             "optimality_area",
                                             "safety",
                                             "safety_area",
                                             "optisafe",
                                             "spl",
                                             "soft_spl",
                                             "barn_score_v2",
                                             "path_length",
                                             "path_excess",
                                             "time_to_goal",
                                             "par2_time",
                                             "time_ratio",
                                             "min_clearance",
                                             "mean_clearance",
                                             "risk_time_ratio",
                                             "inverse_clearance",
                                             "impact_speed",
                                             "min_time_to_collision",
                                             "progress",
                                             "final_distance",
                                             "closest_distance",
                                             "mean_speed",
                                             "time_stopped",
                                             "cumulative_heading_change",
                                             "angle_over_length",
                                             "bending_energy",
                                             "max_curvature",
                                             "path_irregularity",
                                             "rms_linear_acceleration",
                                             "rms_angular_acceleration",
                                             "rms_linear_jerk",
                                             "rms_angular_jerk",
                                             "sparc",
                                             "log_dimensionless_jerk",
                                             "command_variation_v",
                                             "command_variation_w",
                                             "oscillation_count",
                                             "frechet_to_reference",
                                             "hausdorff_to_reference"};
  std::vector<std::string> ids;
  for (const auto& candidate : all_metrics()) {
    const QuantityInfo info = candidate->info();
    ids.push_back(info.id);
    EXPECT_GE(info.version, 1);
    EXPECT_NE(info.name, "");
    EXPECT_NE(info.unit, "");
    EXPECT_NE(info.direction, Direction::None);
    EXPECT_EQ(&metric(info.id), candidate.get());
  }
  EXPECT_EQ(ids, expected);
}

TEST(Metrics, NameTheNearestIdToAnUnknownOne) {
  try {
    metric("optimalty");
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.culprit(), Culprit::Usage);
    EXPECT_NE(std::string(error.what()).find("'optimality'"), std::string::npos) << error.what();
  }
}

TEST(Metrics, GiveTheOutcomeAsReasonWhereTheGoalWasNotReached) {
  MeasuredRun run({{2, 5}, {3, 5}});
  run.outcome = Outcome::Collision;
  for (const std::string id : {"optimality", "optimality_area", "safety", "safety_area", "optisafe",
                               "path_excess", "time_to_goal", "time_ratio"})
    EXPECT_EQ(run.reason(id), "outcome: collision") << id;
  for (const std::string id : {"soft_spl", "path_length", "min_clearance", "mean_clearance",
                               "risk_time_ratio", "inverse_clearance", "impact_speed", "progress",
                               "final_distance", "closest_distance", "mean_speed", "time_stopped"})
    EXPECT_FALSE(run.value(id).is_na()) << id;
}

TEST(Metrics, AreNotAvailableWithoutATrajectory) {
  const MeasuredRun run({});
  for (const auto& candidate : all_metrics()) {
    const std::string id = candidate->info().id;
    if (id == "success") continue;
    EXPECT_EQ(run.reason(id), id == "impact_speed" ? "outcome: success" : "no trajectory") << id;
  }
}

TEST(Metrics, GiveTheReferencesReasonWhereItIsMissing) {
  MeasuredRun run({{2, 5}, {8, 5}});
  run.references = {};
  run.references.shortest_reason = "no path";
  run.references.safest_reason = "no diagram";
  for (const std::string id : {"optimality", "optimality_area", "spl", "soft_spl", "barn_score_v2",
                               "path_excess", "time_ratio", "progress"})
    EXPECT_EQ(run.reason(id), "no path") << id;
  run.set_shortest({{2, 5}, {8, 5}});
  for (const std::string id : {"safety", "safety_area", "optisafe"})
    EXPECT_EQ(run.reason(id), "no diagram") << id;
}

TEST(Metrics, HoldTheirRangesOnRandomTrajectories) {
  RandomEngine random(1);
  for (int i = 0; i < 50; ++i) {
    Path points{{2, 5}};
    for (int k = uniform_int(random, 1, 20); k > 0; --k)
      points.emplace_back(uniform_real(random, 1, 9), uniform_real(random, 1, 9));
    points.emplace_back(8, 5);
    const MeasuredRun run(points);
    EXPECT_GT(run.number("optimality"), 0);
    EXPECT_LE(run.number("optimality"), 1 + 1e-12);
    EXPECT_NEAR(run.number("spl"), run.number("optimality"), 1e-12);
    EXPECT_GE(run.number("optimality_area"), 0);
    EXPECT_GE(run.number("path_length"), 6 - 1e-12);
    EXPECT_LE(run.number("min_clearance"), run.number("mean_clearance"));
    EXPECT_LE(run.number("safety"), 1 + 1e-12);  // nothing is further from the walls than y = 5
  }
}

}  // namespace
}  // namespace slalom::testing
