// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/studio/results_overlay.h>

#include <gtest/gtest.h>

#include <limits>

namespace slalom {
namespace {

ReplayClock clock_of(double duration) {
  ReplayClock clock;
  clock.set_duration(duration);
  clock.seek(0);
  return clock;
}

TEST(ReplayClock, RunsAtItsSpeedAndPausesAtTheEnd) {
  ReplayClock clock = clock_of(10);
  EXPECT_FALSE(clock.advance(1));  // not playing
  clock.play();
  EXPECT_TRUE(clock.advance(1));
  EXPECT_DOUBLE_EQ(1, clock.time());
  clock.faster();
  EXPECT_EQ("2x", clock.speed_text());
  clock.advance(2);
  EXPECT_DOUBLE_EQ(5, clock.time());
  clock.advance(100);
  EXPECT_DOUBLE_EQ(10, clock.time());
  EXPECT_FALSE(clock.playing());
}

TEST(ReplayClock, PlaysFromTheStartWhenAtTheEnd) {
  ReplayClock clock = clock_of(10);
  clock.seek(10);
  clock.toggle();
  EXPECT_TRUE(clock.playing());
  EXPECT_DOUBLE_EQ(0, clock.time());
  clock.toggle();
  EXPECT_FALSE(clock.playing());
}

TEST(ReplayClock, ClampsItsTime) {
  ReplayClock clock = clock_of(10);
  clock.seek(12);
  EXPECT_DOUBLE_EQ(10, clock.time());
  clock.seek(-1);
  EXPECT_DOUBLE_EQ(0, clock.time());
  clock.seek(std::numeric_limits<double>::quiet_NaN());
  EXPECT_DOUBLE_EQ(0, clock.time());
  clock.play();
  EXPECT_FALSE(clock.advance(-1));
}

TEST(ReplayClock, KeepsItsTimeOrTheEndWhenTheDurationChanges) {
  ReplayClock clock = clock_of(10);
  clock.seek(4);
  clock.set_duration(20);
  EXPECT_DOUBLE_EQ(4, clock.time());
  clock.seek(20);
  clock.set_duration(30);
  EXPECT_DOUBLE_EQ(30, clock.time());
  clock.seek(29);
  clock.set_duration(3);
  EXPECT_DOUBLE_EQ(3, clock.time());
}

TEST(ReplayClock, DoesNotPlayWithoutADuration) {
  for (const double duration : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    ReplayClock clock = clock_of(duration);
    clock.play();
    EXPECT_FALSE(clock.playing()) << duration;
    EXPECT_DOUBLE_EQ(0, clock.duration());
  }
}

TEST(ReplayClock, HasASlowestAndAFastestSpeed) {
  ReplayClock clock;
  for (int i = 0; i < 20; ++i) clock.slower();
  EXPECT_DOUBLE_EQ(ReplayClock::speeds().front(), clock.speed());
  EXPECT_EQ("0.25x", clock.speed_text());
  for (int i = 0; i < 20; ++i) clock.faster();
  EXPECT_DOUBLE_EQ(ReplayClock::speeds().back(), clock.speed());
}

}  // namespace
}  // namespace slalom
