// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/trajectory/trajectory.h>

#include <gtest/gtest.h>

#include <set>

namespace slalom {
namespace {

Trajectory three_samples() {
  Trajectory trajectory;
  for (int i = 0; i < 3; ++i)
    trajectory.samples.push_back({1 + 0.1 * i, {i * 1.0, 2, 0}, 1, 0, 1, 0});
  return trajectory;
}

TEST(Trajectory, DurationIsFromTheFirstToTheLastSample) {
  EXPECT_NEAR(three_samples().duration(), 0.2, 1e-12);
  EXPECT_EQ(Trajectory().duration(), 0);
}

TEST(Trajectory, PathHasThePositionsOnly) {
  Trajectory spinning = three_samples();
  for (Sample& s : spinning.samples) s.pose.phi = s.t * 100;
  EXPECT_EQ(length(spinning.path()), 2);
}

TEST(Trajectory, IsAsLongAsRecordedElseStraightBetweenSamples) {
  Trajectory trajectory = three_samples();
  EXPECT_EQ(trajectory.traveled(), 2);
  trajectory.samples[0].traveled = 0.5;
  EXPECT_EQ(trajectory.traveled(), 2) << "not known at the end";
  trajectory.samples[2].traveled = 2.75;
  EXPECT_EQ(trajectory.traveled(), 2.25);
  EXPECT_EQ(Trajectory().traveled(), 0);
}

TEST(Trajectory, HashDependsOnEveryField) {
  std::set<std::string> hashes = {three_samples().hash()};
  for (double Sample::*field : {&Sample::t, &Sample::v, &Sample::w, &Sample::vy, &Sample::command_v,
                                &Sample::command_w, &Sample::command_vy, &Sample::traveled}) {
    Trajectory changed = three_samples();
    changed.samples[1].traveled = 0;
    changed.samples[1].*field += 1e-9;
    hashes.insert(changed.hash());
  }
  EXPECT_EQ(hashes.size(), 9U);
  EXPECT_EQ(three_samples().hash(), three_samples().hash());
}

TEST(Sample, IsRestoredFromItsNumbers) {
  std::array<double, Sample::kNumbers> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = 1.5 * static_cast<double>(i + 1);
  EXPECT_EQ(Sample::from_numbers(numbers).numbers(), numbers);
}

TEST(Outcome, IsRestoredFromItsName) {
  EXPECT_EQ(enum_values<Outcome>().size(), 11U);
  for (const Outcome outcome : enum_values<Outcome>())
    EXPECT_EQ(from_name<Outcome>(to_string(outcome)), outcome);
  EXPECT_EQ(to_string(Outcome::Success), "success");
  EXPECT_EQ(to_string(Outcome::MethodInvalidCommand), "method_invalid_command");
  EXPECT_EQ(to_string(Outcome::InfrastructureError), "infrastructure_error");
  EXPECT_THROW(from_stored_name<Outcome>("outcome", "victory"), Error);
}

}  // namespace
}  // namespace slalom
