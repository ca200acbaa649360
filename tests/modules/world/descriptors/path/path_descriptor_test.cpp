// SPDX-License-Identifier: BSD-3-Clause
// Descriptors along the shortest path, with paths given by their vertices.
#include "../small_worlds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

TEST(ConfinementPath, IsTheMeanAlongThePath) {
  // 0.5 m from the left wall, more than 1 m from all others: 2 acos(0.5) = 120 degrees are walls.
  // One ray of 64 more or less.
  const World world = drawn_world({".....", ".....", "S...G", ".....", "....."});
  const Path near_wall = {{0.5, 1.5}, {0.5, 3.5}}, inside = {{1.5, 2.5}, {3.5, 2.5}};
  const auto along = [&](const Path& path) {
    return value_of("confinement_path", context_with_path(world, path, 0.25, 1));
  };
  EXPECT_NEAR(along(near_wall), 1.0 / 3, 1.0 / 64);
  EXPECT_DOUBLE_EQ(along(inside), 0);
}

TEST(NarrowFraction, IsTheFractionOfThePathThatIsNarrow) {
  // For a robot 0.8 m wide: d below 0.6 m. Within the opening (1 m) d is 0.5 m; before it, to the
  // corners, sqrt(a^2 + 0.5^2) < 0.6 for a < 0.332 m; at both ends 0.1 m next to the walls. d is
  // taken to be linear within 0.25 m, which makes it 0.013 m too little on each side.
  const World world = drawn_world({"..#..", "..#..", "S...G", "..#..", "..#.."});
  const Path straight = {{0.5, 2.5}, {4.5, 2.5}};
  const double narrow = 1 + 2 * std::sqrt(0.6 * 0.6 - 0.25) + 2 * 0.1;
  EXPECT_NEAR(value_of("narrow_fraction", context_with_path(world, straight, 0.4)), narrow / 4,
              0.008);
  EXPECT_DOUBLE_EQ(value_of("narrow_fraction", context_with_path(world, straight, 0.3)), 0);
}

TEST(DetourRatio, IsTheShortestLengthOverTheStraightDistance) {
  const World world = drawn_world({".....", ".....", "S...G", ".....", "....."});
  // One meter up, four along, one down; the ends are 4 m apart.
  const Path path = {{0.5, 2.5}, {0.5, 3.5}, {4.5, 3.5}, {4.5, 2.5}};
  EXPECT_DOUBLE_EQ(value_of("detour_ratio", context_with_path(world, path)), 1.5);
  EXPECT_EQ(descriptor("detour_ratio").compute(context_of(world)).reason(), "no path given");
}

TEST(TurnDensity, IsTheHeadingChangePerMeter) {
  const World world = drawn_world({".....", ".....", "S...G", ".....", "....."});
  // Up, right, down: two right angles in 6 m. A vertex without a turn and a duplicate one add
  // nothing.
  const Path round = {{0.5, 2.5}, {0.5, 3.5}, {2.5, 3.5}, {2.5, 3.5}, {4.5, 3.5}, {4.5, 2.5}};
  EXPECT_NEAR(value_of("turn_density", context_with_path(world, round)), M_PI / 6, 1e-12);
  EXPECT_DOUBLE_EQ(value_of("turn_density", context_with_path(world, {{0.5, 2.5}, {4.5, 2.5}})), 0);
}

TEST(TurnDensity, IsZeroForAStraightPathInAnyDirection) {
  const World world = drawn_world({".....", ".....", "S...G", ".....", "....."});
  const mrpt::math::TPoint2D center(2.5, 2.5);
  for (const double x : {-2.0, -1.0, -0.0, 0.0, 1.0, 2.0})
    for (const double y : {-2.0, -1.0, -0.0, 0.0, 1.0, 2.0}) {
      if (x == 0 && y == 0) continue;
      const Path straight = {center, {center.x + x, center.y + y}};
      EXPECT_EQ(value_of("turn_density", context_with_path(world, straight)), 0) << x << ' ' << y;
    }
}

TEST(GoalVisibility, IsTheFractionOfThePathThatSeesTheGoal) {
  // Under the wall, whose corners are (2, 1) and (3, 1). From (x, 0.5) the line to (4.5, 2.5)
  // passes x = 3 at 0.5 + 2 (3 - x) / (4.5 - x), below 1 where x > 2.5: the last 2 m of the middle
  // leg, and the last leg of 2 m, of 8 m.
  const World world = drawn_world({"..#..", "..#..", "S.#.G", "..#..", "....."});
  const Path under = {{0.5, 2.5}, {0.5, 0.5}, {4.5, 0.5}, {4.5, 2.5}};
  EXPECT_DOUBLE_EQ(value_of("goal_visibility", context_with_path(world, under)), 4.0 / 8);
}

TEST(PathDescriptors, AreNaWithoutAPath) {
  const World world = drawn_world({"S.#.G"});
  for (const std::string id : {"confinement_path", "narrow_fraction", "detour_ratio",
                               "turn_density", "goal_visibility", "predicted_difficulty"})
    EXPECT_EQ(descriptor(id).compute(context_of(world)).reason(), "no path given") << id;
}

TEST(PredictedDifficulty, IsTheModelOfDetourAndNarrowness) {
  // The coefficients of difficulty_model.h.
  constexpr double kEasiest = -5.281, kNarrow = 4.389, kDetour = 5.467;
  const World empty = drawn_world({".....", ".....", "S...G", ".....", "....."});
  const Path straight = {{0.5, 2.5}, {4.5, 2.5}};
  EXPECT_DOUBLE_EQ(value_of("predicted_difficulty", context_with_path(empty, straight)), kEasiest);
  // Six meters instead of four, 1/3 of it in excess, and 0.5 m from the walls.
  const Path detour = {{0.5, 2.5}, {0.5, 3.5}, {4.5, 3.5}, {4.5, 2.5}};
  EXPECT_NEAR(value_of("predicted_difficulty", context_with_path(empty, detour)),
              kEasiest + kDetour / 3 / (1.0 / 3 + 0.05), 1e-12);
  // Everywhere 0.5 m from the walls, less than 1.5 times the radius of 0.4 m.
  const World corridor = drawn_world({"S...G"});
  const Path narrow = {{0.5, 0.5}, {4.5, 0.5}};
  EXPECT_NEAR(value_of("predicted_difficulty", context_with_path(corridor, narrow, 0.4)),
              kEasiest + kNarrow / 1.1, 1e-12);
}

TEST(PredictedDifficulty, IsNaForTheReasonOfItsDescriptors) {
  const World world = drawn_world({"S...G"});
  DescriptorContext context = context_of(world);
  context.shortest = search_once([] { return KnownPath{{}, 0, "no way"}; });
  EXPECT_EQ(descriptor("predicted_difficulty").compute(context).reason(), "no way");
}

TEST(PathDescriptors, AreNaWhereStartAndGoalCoincide) {
  const World world = drawn_world({"..S.."});
  const mrpt::math::TPoint2D point(2.5, 0.5);
  for (const std::string id :
       {"confinement_path", "narrow_fraction", "turn_density", "goal_visibility"})
    EXPECT_EQ(descriptor(id).compute(context_with_path(world, {point, point})).reason(),
              "start and goal coincide")
        << id;
}

TEST(PathDescriptors, SearchThePathOnce) {
  const World world = drawn_world({"S...G"});
  int searches = 0;
  DescriptorContext context = context_of(world);
  context.shortest = search_once([&searches] {
    ++searches;
    return KnownPath{{{0.5, 0.5}, {4.5, 0.5}}, 4, ""};
  });
  const DescriptorContext copy = context;
  for (const Descriptor& tested : all_descriptors()) tested.compute(context);
  descriptor("turn_density").compute(copy);
  EXPECT_EQ(searches, 1);
}

}  // namespace
}  // namespace slalom
