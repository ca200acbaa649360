// SPDX-License-Identifier: BSD-3-Clause
#include "arrival/unsafe_departures.h"

#include <slalom/core/random.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom::arrival {
namespace {

using mrpt::math::TPoint2D;

/// The smallest distance of robot and mover while both move, by sampling.
double sampled_distance(const Leg& leg, const MoverSegment& segment, double departure) {
  double least = INFINITY;
  constexpr int kSamples = 2000;
  for (int i = 0; i <= kSamples; ++i) {
    const double s = leg.duration * i / kSamples, t = departure + s;
    if (t < segment.begin || t > segment.end) continue;
    const TPoint2D robot = leg.from + leg.velocity * s;
    const TPoint2D mover = segment.from + segment.velocity * (t - segment.begin);
    least = std::min(least, std::hypot(robot.x - mover.x, robot.y - mover.y));
  }
  return least;
}

TEST(GapsBetween, AreWhatTheIntervalsLeave) {
  const auto gaps = gaps_between({{4, 5}, {-1, 1}, {4.5, 6}, {9, 12}}, 0, 10);
  ASSERT_EQ(gaps.size(), 2U);
  EXPECT_EQ(gaps[0].first, 1);
  EXPECT_EQ(gaps[0].last, 4);
  EXPECT_EQ(gaps[1].first, 6);
  EXPECT_EQ(gaps[1].last, 9);
  EXPECT_TRUE(gaps_between({{-1, 3}}, 0, 2).empty());
  EXPECT_TRUE(gaps_between({}, 1, 0).empty());
}

TEST(GapsBetween, AreMomentsWhereOpenIntervalsTouch) {
  const auto gaps = gaps_between({{0, 2}, {2, 4}}, 1, 4);
  ASSERT_EQ(gaps.size(), 2U);
  EXPECT_EQ(gaps[0].first, 2);
  EXPECT_EQ(gaps[0].last, 2);
  EXPECT_EQ(gaps[1].first, 4);
}

TEST(UnsafeDepartures, OfACrossingAreWhenTheDistanceWouldBeTooSmall) {
  // The robot crosses x = 0 one second after its departure at 1 m/s to the right, the mover at the
  // time 5 at 1 m/s upward. Relative to each other they move at sqrt(2) m/s; departing e late they
  // miss by e / sqrt(2).
  const Leg leg{{-1, 0}, {1, 0}, 10};
  const MoverSegment segment{0, 100, {0, -5}, {0, 1}};
  const auto unsafe = unsafe_departures(leg, segment, 0.5);
  ASSERT_TRUE(unsafe.has_value());
  EXPECT_NEAR(unsafe->first, 4 - 0.5 * std::sqrt(2), 1e-8);
  EXPECT_NEAR(unsafe->last, 4 + 0.5 * std::sqrt(2), 1e-8);
}

TEST(UnsafeDepartures, OfAStayAreWhileTheMoverIsNear) {
  const auto unsafe = unsafe_departures({{3, 0.3}, {0, 0}, 0}, {1, 20, {0, 0}, {2, 0}}, 0.5);
  ASSERT_TRUE(
      unsafe.has_value());  // it is 0.4 m before and behind (3, 0) at 1 + 2.6 / 2 and 1 + 3.4 / 2
  EXPECT_NEAR(unsafe->first, 2.3, 1e-8);
  EXPECT_NEAR(unsafe->last, 2.7, 1e-8);
}

TEST(UnsafeDepartures, AreThoseThatSamplingFinds) {
  RandomEngine engine(41);
  int inside = 0, outside = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const auto number = [&](double low, double high) { return uniform_real(engine, low, high); };
    const auto zero_or = [&](double value) { return uniform_int(engine, 0, 4) == 0 ? 0.0 : value; };
    const Leg leg{{number(-3, 3), number(-3, 3)},
                  {zero_or(number(-1, 1)), zero_or(number(-1, 1))},
                  zero_or(number(0, 4))};
    MoverSegment segment{number(0, 4),
                         0,
                         {number(-3, 3), number(-3, 3)},
                         {zero_or(number(-1, 1)), zero_or(number(-1, 1))}};
    if (uniform_int(engine, 0, 4) == 0) segment.velocity = leg.velocity;
    segment.end = segment.begin + number(0.1, 5);
    const double distance = number(0.1, 1.5);
    const auto unsafe = unsafe_departures(leg, segment, distance);
    for (int i = 0; i < 20; ++i) {
      const double departure = number(-5, 10), sampled = sampled_distance(leg, segment, departure);
      const bool is_unsafe = unsafe && unsafe->first < departure && departure < unsafe->last;
      if (sampled < distance) {
        ASSERT_TRUE(is_unsafe) << trial << ", departure " << departure << ", " << sampled << " < "
                               << distance;
      }
      // Samples are at most 4 s / 2000 apart, at relative speeds up to sqrt(8) m/s.
      if (is_unsafe && leg.duration > 0 && unsafe->last - departure > 0.02 &&
          departure - unsafe->first > 0.02) {
        ASSERT_LT(sampled, distance + 0.02) << trial;
      }
      ++(is_unsafe ? inside : outside);
    }
  }
  EXPECT_GT(inside, 500);
  EXPECT_GT(outside, 500);
}

/// People move so: in many short segments.
TEST(UnsafeDepartures, OfALongMotionAreThoseOfItsSegments) {
  RandomEngine engine(43);
  for (int trial = 0; trial < 200; ++trial) {
    const auto number = [&](double low, double high) { return uniform_real(engine, low, high); };
    Mover mover{"a", 0.3, {}, MoverEnd::Stop};
    TPoint2D p(number(-5, 5), number(-5, 5));
    const int count = uniform_int(engine, 1, 100);
    for (int i = 0; i < count; ++i, p += TPoint2D(number(-0.3, 0.3), number(-0.3, 0.3)))
      mover.waypoints.push_back({0.1 * i, p});
    const Leg leg{{number(-5, 5), number(-5, 5)}, {number(-1, 1), number(-1, 1)}, number(0, 2)};
    const Interval window{number(0, 5), number(5, 12)};
    std::vector<Interval> expected;
    for (const MoverSegment& segment : segments_of(mover, 12))
      if (segment.end >= window.first && segment.begin <= window.last + leg.duration)
        if (const auto interval = unsafe_departures(leg, segment, 0.5))
          expected.push_back(*interval);
    const auto unsafe = unsafe_departures(leg, traffic_of({mover}, 0.2, 12), window);
    // Departures outside of the window may be missing.
    const auto inside = [&](std::vector<Interval> intervals) {
      return gaps_between(std::move(intervals), window.first, window.last);
    };
    const std::vector<Interval> found = inside(unsafe), all = inside(expected);
    ASSERT_EQ(found.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_EQ(found[i].first, all[i].first);
      EXPECT_EQ(found[i].last, all[i].last);
    }
  }
}

}  // namespace
}  // namespace slalom::arrival
