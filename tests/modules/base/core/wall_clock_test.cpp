// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/wall_clock.h>

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace slalom {
namespace {

TEST(WallClock, CountsSeconds) {
  const double before = steady_seconds();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  const double after = steady_seconds();
  EXPECT_GE(after - before, 0.02);
  EXPECT_LE(after, steady_seconds()) << "not monotonic";
}

}  // namespace
}  // namespace slalom
