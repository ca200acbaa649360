// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/scenario/convert.h>
#include <slalom/scenario/scenario.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace slalom {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Along x from 0 to 2 in 4 s, rests 1 s, along y to 3 in 1.5 s.
Mover turning_mover(MoverEnd after = MoverEnd::Stop) {
  return {"a", 0.3, {{1, {0, 0}}, {5, {2, 0}}, {6, {2, 0}}, {7.5, {2, 3}}}, after};
}

/// Around a square of side 1 in 4 s, from 2 s on.
Mover circling_mover() {
  return {
      "c", 0.2, {{2, {0, 0}}, {3, {1, 0}}, {4, {1, 1}}, {5, {0, 1}}, {6, {0, 0}}}, MoverEnd::Loop};
}

void expect_state(const Mover& mover, double t, double x, double y, double vx, double vy) {
  EXPECT_NEAR(mover.position(t).x, x, 1e-12) << t;
  EXPECT_NEAR(mover.position(t).y, y, 1e-12) << t;
  EXPECT_NEAR(mover.velocity(t).x, vx, 1e-12) << t;
  EXPECT_NEAR(mover.velocity(t).y, vy, 1e-12) << t;
}

TEST(Mover, MovesStraightBetweenItsWaypoints) {
  const Mover mover = turning_mover();
  expect_state(mover, 0, 0, 0, 0, 0);
  expect_state(mover, 1, 0, 0, 0.5, 0);
  expect_state(mover, 3, 1, 0, 0.5, 0);
  expect_state(mover, 5.5, 2, 0, 0, 0);
  expect_state(mover, 6, 2, 0, 0, 2);
  expect_state(mover, 7, 2, 2, 0, 2);
  expect_state(mover, 7.5, 2, 3, 0, 0);
  expect_state(mover, 100, 2, 3, 0, 0);
}

TEST(Mover, IsPresentFromItsFirstWaypoint) {
  for (const MoverEnd after : {MoverEnd::Stop, MoverEnd::Vanish}) {
    EXPECT_FALSE(turning_mover(after).present(0.999));
    EXPECT_TRUE(turning_mover(after).present(1));
    EXPECT_TRUE(turning_mover(after).present(7.5));
  }
  EXPECT_TRUE(turning_mover(MoverEnd::Stop).present(1e6));
  EXPECT_FALSE(turning_mover(MoverEnd::Vanish).present(7.500001));
  EXPECT_TRUE(circling_mover().present(1e6));
}

TEST(Mover, RepeatsAClosedPath) {
  const Mover mover = circling_mover();
  expect_state(mover, 4.5, 0.5, 1, -1, 0);
  expect_state(mover, 6.25, 0.25, 0, 1, 0);  // second round
  expect_state(mover, 2 + 4 * 25 + 3.5, 0, 0.5, 0, -1);
}

TEST(Mover, ReportsWhenItsMotionChanges) {
  const Mover mover = turning_mover();
  EXPECT_EQ(mover.next_change(0), 1);
  EXPECT_EQ(mover.next_change(1), 5);
  EXPECT_EQ(mover.next_change(5.5), 6);
  EXPECT_EQ(mover.next_change(7.5), kNever);
  EXPECT_EQ(circling_mover().next_change(6), 7);
  EXPECT_EQ(circling_mover().next_change(9.5), 10);
}

TEST(Mover, KeepsTheSegmentsOfLaterRoundsDespiteRounding) {
  // A time that rounds to just before the end of a round.
  const Mover round{"r", 0.2, {{1.7, {0, 0}}, {2.2, {1, 0}}, {2.8, {0, 0}}}, MoverEnd::Loop};
  const double t = 29.199999999999996;  // 25 rounds of 1.1 s after 1.7 s
  EXPECT_NEAR(round.velocity(t).x, 2, 1e-9);
  EXPECT_NEAR(round.next_change(t), 29.7, 1e-9);
}

RC_GTEST_PROP(MoverProperty, LaterRoundsHaveEachSegmentOnce, ()) {
  Mover mover{"m", 0.3, {}, MoverEnd::Loop};
  const int count = *rc::gen::inRange(2, 6);
  double t = *rc::gen::inRange(0, 1'000'000) * 1e-7;
  for (int i = 0; i < count; ++i) {
    mover.waypoints.push_back({t, {0.1 * i, 0}});
    t += 1e-3 + *rc::gen::inRange(0, 100'000'000) * 1e-8;
  }
  mover.waypoints.push_back({t, {0, 0}});
  check_movers("any", {mover});
  double at = mover.waypoints.front().t;
  for (int round = 0; round < 40; ++round)
    for (int i = 0; i < count; ++i) {
      const Waypoint &a = mover.waypoints[static_cast<std::size_t>(i)],
                     &b = mover.waypoints[static_cast<std::size_t>(i) + 1];
      const double speed = (b.position.x - a.position.x) / (b.t - a.t);
      RC_ASSERT(std::abs(mover.velocity(at).x - speed) < 1e-9 * std::abs(speed));
      const double next = mover.next_change(at);
      RC_ASSERT(std::abs(next - at - (b.t - a.t)) < 1e-8);
      at = next;
    }
}

/// A random valid mover; times in eighths of a second.
Mover any_mover() {
  Mover mover{"m", 0.3, {}, *rc::gen::element(MoverEnd::Stop, MoverEnd::Loop, MoverEnd::Vanish)};
  const int count = *rc::gen::inRange(2, 7);
  double t = *rc::gen::inRange(-20, 20) / 8.0;
  for (int i = 0; i < count; ++i) {
    mover.waypoints.push_back(
        {t, {*rc::gen::inRange(-50, 50) / 10.0, *rc::gen::inRange(-50, 50) / 10.0}});
    t += *rc::gen::inRange(1, 30) / 8.0;
  }
  if (mover.after == MoverEnd::Loop) mover.waypoints.push_back({t, mover.waypoints[0].position});
  check_movers("any", {mover});
  return mover;
}

RC_GTEST_PROP(MoverProperty, MovesAtItsVelocityUntilTheNextChange, ()) {
  const Mover mover = any_mover();
  const double t = *rc::gen::inRange(-400, 4000) / 80.0;
  const double next = std::min(mover.next_change(t), t + 5);
  RC_ASSERT(next > t);
  const double middle = 0.5 * (t + next);
  for (const double until : {middle, next}) {
    const auto expected = mover.position(t) + mover.velocity(t) * (until - t);
    RC_ASSERT(std::abs(mover.position(until).x - expected.x) < 1e-9);
    RC_ASSERT(std::abs(mover.position(until).y - expected.y) < 1e-9);
  }
  RC_ASSERT(mover.present(middle) == mover.present(t + 0.9 * (next - t)));
}

Scenario still() {
  return Scenario::continuous("still", {-10, -10, 10, 10}, {{{{3, 3}, 0.5}}, {}}, {1, 1, 0},
                              {4, 4});
}

TEST(Mover, BelongsToTheContentOfAScenarioOnlyIfThereIsOne) {
  EXPECT_EQ(still().with_movers({}).hash(), still().hash());
  const Scenario moving = still().with_movers({turning_mover()});
  EXPECT_NE(moving.hash(), still().hash());
  EXPECT_EQ(moving.with_movers({}).hash(), still().hash());
  EXPECT_EQ(moving.movers(), Movers{turning_mover()});
  const auto hash_of = [](const std::function<void(Mover&)>& change) {
    Mover mover = turning_mover();
    change(mover);
    return still().with_movers({mover}).hash();
  };
  EXPECT_EQ(hash_of([](Mover&) {}), moving.hash());
  EXPECT_NE(hash_of([](Mover& m) { m.id = "b"; }), moving.hash());
  EXPECT_NE(hash_of([](Mover& m) { m.radius += 1e-9; }), moving.hash());
  EXPECT_NE(hash_of([](Mover& m) { m.after = MoverEnd::Vanish; }), moving.hash());
  EXPECT_NE(hash_of([](Mover& m) { m.waypoints[1].t += 1e-9; }), moving.hash());
  EXPECT_NE(hash_of([](Mover& m) { m.waypoints[3].position.y += 1e-9; }), moving.hash());
}

TEST(Mover, StaysInScenariosThatAreDerivedFromOthers) {
  const Scenario moving = still().with_movers({turning_mover(), circling_mover()});
  EXPECT_EQ(moving.renamed("other").movers(), moving.movers());
  EXPECT_EQ(moving.with_start_goal({0, 0, 0}, {1, 1}).movers(), moving.movers());
  ConversionOptions options;
  options.resolution = 0.5;
  for (const Representation to : {Representation::Grid, Representation::Points})
    EXPECT_EQ(convert(moving, to, options).movers(), moving.movers());
}

TEST(Mover, IsRefusedWithItsIdWhenInvalid) {
  const auto refused = [](const std::function<void(Mover&)>& change, const std::string& what) {
    Mover mover = turning_mover();
    change(mover);
    return throws_error(ErrorKind::File, "still: moving obstacle ", {what}, [&] {
      still().with_movers({circling_mover(), mover});
    });
  };
  EXPECT_TRUE(refused([](Mover& m) { m.id = "c"; }, "'c': duplicate id"));
  EXPECT_TRUE(refused([](Mover& m) { m.id = ""; }, "1: invalid id"));
  EXPECT_TRUE(refused([](Mover& m) { m.id = "caf\xe9"; }, "1: invalid id"));
  EXPECT_TRUE(refused([](Mover& m) { m.id = std::string(101, 'x'); }, "1: invalid id"));
  EXPECT_TRUE(refused([](Mover& m) { m.radius = 0; }, "'a': invalid radius 0 m"));
  EXPECT_TRUE(refused([](Mover& m) { m.radius = std::nan(""); }, "'a': invalid radius"));
  EXPECT_TRUE(refused([](Mover& m) { m.waypoints.clear(); }, "'a': no waypoints"));
  EXPECT_TRUE(refused([](Mover& m) { m.waypoints[2].t = 5; }, "waypoint 2 is at 5 s, not after"));
  EXPECT_TRUE(
      refused([](Mover& m) { m.waypoints[2].t = 5.0009; }, "waypoint 2 is at 5.0009 s, not after"));
  EXPECT_TRUE(refused([](Mover& m) { m.waypoints[0].t = kNever; }, "waypoint 0 is out of range"));
  EXPECT_TRUE(
      refused([](Mover& m) { m.waypoints[3].position.x = kNever; }, "waypoint 3 is out of range"));
  EXPECT_TRUE(refused([](Mover& m) { m.waypoints[3].position.y = 1501; }, "waypoint 3 is too far"));
  EXPECT_TRUE(refused([](Mover& m) { m.after = MoverEnd::Loop; }, "is not closed"));
}

TEST(SegmentsOf, AreTheMotionsOfAMoverWhileItIsPresent) {
  const Mover mover{"a", 0.3, {{1, {0, 0}}, {3, {4, 0}}, {4, {4, 0}}}, MoverEnd::Vanish};
  const auto segments = segments_of(mover, 10);
  ASSERT_EQ(segments.size(), 2U);
  EXPECT_EQ(segments[0].begin, 1);
  EXPECT_EQ(segments[0].end, 3);
  EXPECT_EQ(segments[0].velocity.x, 2);
  EXPECT_EQ(segments[1].from.x, 4);
  EXPECT_EQ(segments[1].end, 4);
}

}  // namespace
}  // namespace slalom
