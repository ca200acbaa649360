// SPDX-License-Identifier: BSD-3-Clause
#include "bag_clock.h"
#include "message_bytes.h"

#include <gtest/gtest.h>

namespace slalom {
namespace {

using testing::kSecond;

TEST(BagClock, TimesOfRecordingStayWhereTransportExplainsTheDifference) {
  BagClock clock;
  for (int i = 0; i < 10; ++i) clock.add(i * kSecond + 20'000'000, i * kSecond);
  clock.finish();
  EXPECT_FALSE(clock.is_other_clock());
  EXPECT_EQ(clock.stamp_of(5 * kSecond), 5 * kSecond);
}

TEST(BagClock, SimulatedTimeIsInterpolatedAtItsRate) {
  BagClock clock;  // twice as fast as the recorder's clock from 900 s on
  for (int i = 9; i >= 0; --i) clock.add((1'700'000'000 + i) * kSecond, (900 + 2 * i) * kSecond);
  clock.finish();
  EXPECT_TRUE(clock.is_other_clock());
  EXPECT_EQ(clock.stamp_of(1'700'000'003 * kSecond), 906 * kSecond);
  EXPECT_EQ(clock.stamp_of(1'700'000'003 * kSecond + kSecond / 4), 906 * kSecond + kSecond / 2);
  EXPECT_EQ(clock.stamp_of(1'700'000'010 * kSecond), 919 * kSecond);  // beyond, at the rate 1
  EXPECT_EQ(clock.stamp_of(1'699'999'999 * kSecond), 899 * kSecond);
}

TEST(BagClock, WithoutMessagesTimesStay) {
  BagClock clock;
  clock.finish();
  EXPECT_EQ(clock.stamp_of(7), 7);
}

}  // namespace
}  // namespace slalom
