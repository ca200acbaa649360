// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/commands/edit_movers.h>
#include <slalom/core/error.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

/// A mover from (2, 2) to (6, 2) in 4 s, and one that walks about a triangle.
Scenario walked_room() {
  const Movers movers = {
      {"a", 0.5, {{0, {2, 2}}, {4, {6, 2}}}, MoverEnd::Vanish},
      {"mover_1", 0.3, {{1, {8, 1}}, {3, {8, 3}}, {5, {7, 3}}, {7, {8, 1}}}, MoverEnd::Loop}};
  return Scenario::continuous("room", {0, 0, 10, 6}, {}, {1, 5, 0}, {9, 5}).with_movers(movers);
}

TEST(EditMovers, FindsAMoverWhereItIsAtTheTime) {
  const Scenario room = walked_room();
  EXPECT_EQ(mover_at(room, {2.4, 2}, 0), 0U);
  EXPECT_EQ(mover_at(room, {2.4, 2}, 2), std::nullopt) << "it is at (4, 2)";
  EXPECT_EQ(mover_at(room, {4.4, 2.2}, 2), 0U);
  EXPECT_EQ(mover_at(room, {6, 2}, 4), 0U);
  EXPECT_EQ(mover_at(room, {6, 2}, 4.1), std::nullopt) << "it has vanished";
  EXPECT_EQ(mover_at(room, {8, 1}, 0), std::nullopt) << "it appears at 1 s";
  EXPECT_EQ(mover_at(room, {8, 1.1}, 7), 1U);
}

TEST(EditMovers, FindsTheNearestWaypoint) {
  const auto found = waypoint_at(walked_room(), {7.05, 3.05}, 0.1);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->mover, 1U);
  EXPECT_EQ(found->waypoint, 2U);
  EXPECT_FALSE(waypoint_at(walked_room(), {7.2, 3}, 0.1));
}

TEST(EditMovers, WalksAlongAPathAtTheSpeed) {
  // 3 m and 4 m at 0.5 m/s.
  const Mover there = mover_along({{1, 1}, {4, 1}, {4, 5}}, 0.2, 0.5);
  ASSERT_EQ(there.waypoints.size(), 3U);
  EXPECT_DOUBLE_EQ(there.waypoints[1].t, 6);
  EXPECT_DOUBLE_EQ(there.waypoints[2].t, 14);
  EXPECT_EQ(there.after, MoverEnd::Stop);
  EXPECT_EQ(mover_along({{1, 1}, {4, 1}, {1, 1}}, 0.2, 0.5).after, MoverEnd::Loop);
  EXPECT_EQ(mover_along({{1, 1}}, 0.2, 0.5).after, MoverEnd::Stop);
  Mover later = there;
  later.waypoints[0].t = 2;
  set_speed(later, 1);
  EXPECT_DOUBLE_EQ(later.waypoints[1].t, 5);
  EXPECT_DOUBLE_EQ(later.waypoints[2].t, 9);
  const Mover crowded = mover_along({{1, 1}, {1 + 1e-9, 1}, {1, 1 + 1e-9}}, 0.2, 100);
  EXPECT_NO_THROW(with_mover_added(walked_room(), crowded)) << "times increase enough";
}

TEST(EditMovers, MovesWholePathsAndSingleWaypoints) {
  const Mover loop = walked_room().movers()[1];
  const Mover all = moved(loop, 1, -0.5);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_DOUBLE_EQ(all.waypoints[i].position.x, loop.waypoints[i].position.x + 1);
    EXPECT_DOUBLE_EQ(all.waypoints[i].position.y, loop.waypoints[i].position.y - 0.5);
    EXPECT_EQ(all.waypoints[i].t, loop.waypoints[i].t);
  }
  const Mover inner = with_waypoint_moved(loop, 1, 0, 1);
  EXPECT_EQ(inner.waypoints[1].position.y, 4);
  EXPECT_EQ(inner.waypoints[0].position.y, 1);
  for (const std::size_t end : {0U, 3U}) {
    const Mover closed = with_waypoint_moved(loop, end, 1, 0);
    EXPECT_EQ(closed.waypoints[0].position.x, 9) << "both ends of a loop move";
    EXPECT_EQ(closed.waypoints[3].position.x, 9);
  }
}

TEST(EditMovers, AddsReplacesAndRemoves) {
  const Scenario room = walked_room();
  const Scenario more = with_mover_added(room, mover_along({{3, 3}}, 0.2, 1));
  ASSERT_EQ(more.movers().size(), 3U);
  EXPECT_EQ(more.movers()[2].id, "mover_2") << "mover_1 is taken";
  const Scenario met = room.with_people({{"mover_2", 0.3, 1, {5, 5}, {{5, 4}}}});
  EXPECT_EQ(with_mover_added(met, mover_along({{3, 3}}, 0.2, 1)).movers()[2].id, "mover_3")
      << "a person has the other";
  EXPECT_NE(more.hash(), room.hash());
  EXPECT_EQ(with_mover_removed(more, 2).hash(), room.hash());
  EXPECT_EQ(with_mover_removed(room, 0).movers(), Movers{room.movers()[1]});
  const Scenario swapped = with_mover_replaced(room, 0, moved(room.movers()[0], 0, 1));
  EXPECT_EQ(swapped.movers()[0].waypoints[0].position.y, 3);
  EXPECT_THROW(with_mover_added(room, room.movers()[0]), Error) << "the id is taken";
}

TEST(EditMovers, KnowsTheLastTime) {
  EXPECT_EQ(last_waypoint_time({}), 0);
  EXPECT_EQ(last_waypoint_time(walked_room().movers()), 7);
  EXPECT_EQ(last_waypoint_time({{"early", 0.1, {{-3, {1, 1}}, {-1, {2, 1}}}}}), 0);
}

}  // namespace
}  // namespace slalom
