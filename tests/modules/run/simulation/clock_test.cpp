// SPDX-License-Identifier: BSD-3-Clause
#include "test_runs.h"

#include <gtest/gtest.h>
#include <mrpt/core/Clock.h>

namespace slalom::testing {
namespace {

using mrpt::Clock;

double seconds_between(const Clock::time_point& a, const Clock::time_point& b) {
  return std::chrono::duration<double>(b - a).count();
}

TEST(SimulatedClock, FollowsTheRunExactly) {
  Clock::time_point start;
  FunctionMethod method([&](const Observation& o) {
    EXPECT_EQ(Clock::getActiveClock(), Clock::Simulated);
    if (o.time == 0) start = Clock::now();
    EXPECT_NEAR(seconds_between(start, Clock::now()), o.time, 1e-7);
    EXPECT_EQ(o.scan->timestamp, Clock::now());
    return Command{1, 0};
  });
  run(square_world({1, 5, 0}, {8, 5}), method);
}

TEST(SimulatedClock, NeverGoesBackAndSeparatesRunsByTwoSeconds) {
  Clock::time_point last = Clock::time_point::min();
  const World world = square_world({1, 5, 0}, {8, 5});
  for (int i = 0; i < 5; ++i) {
    FunctionMethod method([&](const Observation& o) {
      if (o.time == 0) {
        EXPECT_TRUE(last == Clock::time_point::min() || seconds_between(last, Clock::now()) >= 2);
      } else {
        EXPECT_GT(Clock::now(), last);
      }
      last = Clock::now();
      return Command{1, 0};
    });
    run(world, method);
  }
}

}  // namespace
}  // namespace slalom::testing
