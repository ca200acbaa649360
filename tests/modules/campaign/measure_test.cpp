#include <slalom/campaign/measure.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

/// A trajectory along a wall with a clearance of 0.6 m.
Trajectory trajectory_along_wall() {
  Trajectory trajectory;
  for (int i = 0; i < 3; ++i) {
    Sample sample;
    sample.t = i;
    sample.pose = {2.0 + i, 0.85, 0};
    trajectory.samples.push_back(sample);
  }
  return trajectory;
}

TEST(MeasureRun, ComputesTheEnabledMetricsWithTheCampaignOptions) {
  const World room(Scenario::continuous("room", {0, 0, 10, 10}, {}, {2, 0.85, 0}, {8, 5}), 0.05);
  CampaignOptions options;
  options.metrics = {"risk_time_ratio", "par2_time"};
  const auto measured = [&] {
    return measure_run(options, room, find_references(options, nullptr, room),
                       trajectory_along_wall(), Outcome::Timeout);
  };
  EXPECT_EQ(measured().size(), 2U);
  EXPECT_EQ(measured().at("risk_time_ratio").value, Value::of(0));
  options.safe_distance = 0.7;
  EXPECT_EQ(measured().at("risk_time_ratio").value, Value::of(1));
  options.setup.simulation.max_time = 10;
  EXPECT_EQ(measured().at("par2_time").value, Value::of(20));
}

}  // namespace
}  // namespace slalom
