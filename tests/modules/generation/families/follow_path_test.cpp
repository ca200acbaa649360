// SPDX-License-Identifier: BSD-3-Clause
#include "family_samples.h"

#include <slalom/core/distance.h>
#include <slalom/generation/start_goal.h>
#include <slalom/scenario/geometry.h>

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

double heading_of(const TPoint2D& from, const TPoint2D& to) {
  return std::atan2(to.y - from.y, to.x - from.x);
}

/// The center line of a corridor, halfway between corners of its walls, and its width.
struct Corridor {
  std::vector<TPoint2D> center;
  double width = 0;
};

/// The first half of a wall's corners is its right side, the second half, backward, its left one.
Corridor corridor_of(const Scenario& scenario) {
  const auto& walls = scenario.primitives().polygons;
  EXPECT_EQ(walls.size(), 4U);
  const auto &left = walls[0].vertices, &right = walls[1].vertices;
  const std::size_t corners = left.size() / 2;
  Corridor corridor;
  for (std::size_t i = 0; i < corners; ++i)
    corridor.center.push_back((left[i] + right[right.size() - 1 - i]) * 0.5);
  corridor.width = distance_between(left[0], right.back());
  return corridor;
}

double distance_to_line(const TPoint2D& p, const std::vector<TPoint2D>& line) {
  double least = 1e9;
  for (std::size_t i = 1; i < line.size(); ++i)
    least = std::min(least, distance_to_segment(p, line[i - 1], line[i]));
  return least;
}

/// Whether it is on the inner side of both end walls.
bool is_between_ends(const TPoint2D& p, const Corridor& corridor) {
  const auto& line = corridor.center;
  const auto is_ahead = [&](const TPoint2D& end, const TPoint2D& next) {
    return (next.x - end.x) * (p.x - end.x) + (next.y - end.y) * (p.y - end.y) > 0;
  };
  return is_ahead(line[0], line[1]) && is_ahead(line.back(), line[line.size() - 2]);
}

TEST(FollowPath, SegmentsTurnsAndStartAreAsTheOptionsSay) {
  const auto generator = family("follow_path",
                                "min_segments = 3\nmax_segments = 6\nmin_segment_length = 2\n"
                                "max_segment_length = 3\nmin_turn_deg = 30\nmax_turn_deg = 50\n"
                                "min_width = 1.2\nmax_width = 1.4\nmargin = 0.6\n"
                                "min_angle_deg = 5\nmax_angle_deg = 25\nmin_distance = 1\n");
  RandomEngine engine(4);
  int left = 0, turned_left = 0, by_segments[7] = {};
  for (int i = 0; i < 200; ++i) {
    const Scenario scenario = generator->generate("x", engine);
    const Corridor corridor = corridor_of(scenario);
    const auto& line = corridor.center;
    ASSERT_GE(line.size(), 4U);
    ASSERT_LE(line.size(), 7U);
    ++by_segments[line.size() - 1];
    expect_within(corridor.width, 1.2, 1.4);
    for (std::size_t k = 1; k < line.size(); ++k) {
      expect_within(distance_between(line[k - 1], line[k]), 2, 3);
      EXPECT_LE(std::abs(heading_of(line[k - 1], line[k])), 80 * M_PI / 180 + kRoundingError);
      if (k == 1) continue;
      const double turn = heading_of(line[k - 1], line[k]) - heading_of(line[k - 2], line[k - 1]);
      expect_angle_within(turn, 30, 50);
      if (k == 2) left += turn > 0 ? 1 : 0;
    }
    const auto& start = scenario.start();
    EXPECT_NEAR(distance_between(start, line[0]), 0.6, kRoundingError);
    EXPECT_NEAR(distance_between(scenario.goal(), line.back()), 0.6, kRoundingError);
    EXPECT_NEAR(distance_to_line({start.x, start.y}, line), 0, kRoundingError);
    EXPECT_NEAR(distance_to_line(scenario.goal(), line), 0, kRoundingError);
    EXPECT_NEAR(heading_of(line[0], line[1]), 0, kRoundingError);
    expect_angle_within(start.phi, 5, 25);
    turned_left += start.phi > 0 ? 1 : 0;
  }
  // 200 throws of a coin, and of a die with four sides.
  EXPECT_NEAR(left, 100, 40);
  EXPECT_NEAR(turned_left, 100, 40);
  for (const int segments : {3, 4, 5, 6}) EXPECT_NEAR(by_segments[segments], 50, 35);
}

TEST(FollowPath, TheCorridorHasTheClearWidthAllAlong) {
  const auto generator = family("follow_path", "min_segments = 5\nmax_segments = 5\n");
  // (1.6 m + 2 * 0.15 m) tan(40 deg) = 1.594 m: nearly no wall is left between two such turns.
  const auto sharp = family("follow_path",
                            "min_segments = 9\nmax_segments = 9\nmin_turn_deg = 70\n"
                            "max_turn_deg = 80\nmin_segment_length = 1.6\n"
                            "max_segment_length = 1.8\nmin_width = 1.5\n");
  RandomEngine engine(9);
  for (int i = 0; i < 60; ++i) {
    const Scenario scenario = (i % 2 == 0 ? generator : sharp)->generate("x", engine);
    const Corridor corridor = corridor_of(scenario);
    const auto& line = corridor.center;
    for (const Polygon& wall : scenario.primitives().polygons) EXPECT_TRUE(is_simple(wall));
    // Less than half of the width only in front of the end walls.
    for (std::size_t k = 1; k < line.size(); ++k)
      for (double f = 0; f <= 1; f += 1.0 / 64) {
        const TPoint2D p = line[k - 1] + (line[k] - line[k - 1]) * f;
        const double end = std::min(distance_between(p, line[0]), distance_between(p, line.back()));
        EXPECT_NEAR(wall_clearance(scenario, p), std::min(end, corridor.width / 2), kRoundingError);
      }
  }
}

TEST(FollowPath, NoPointOfTheCorridorIsFartherFromTheCenterLineThanStated) {
  const auto generator = family("follow_path", "min_turn_deg = 50\nmax_turn_deg = 60\n");
  RandomEngine engine(3);
  double most = 0;  // as a fraction of half of the width less the radius
  for (int i = 0; i < 30; ++i) {
    const Scenario scenario = generator->generate("x", engine);
    const Corridor corridor = corridor_of(scenario);
    const double radius = 0.3, deviation = corridor.width / 2 - radius;
    for (int k = 0; k < 4000; ++k) {
      const TPoint2D p = sample_position(engine, scenario.bounds());
      const double from_line = distance_to_line(p, corridor.center);
      // Beyond the walls the robot is not: they enclose the corridor.
      const bool is_inside = from_line < corridor.width / 2 + 0.1 && is_between_ends(p, corridor);
      if (!is_inside || wall_clearance(scenario, p) < radius) continue;
      most = std::max(most, from_line / deviation);
      EXPECT_LE(from_line, deviation / std::cos(M_PI / 6) + kRoundingError);
    }
  }
  // Outside corners are mitered.
  EXPECT_GT(most, 1);
}

TEST(FollowPath, TheWallsEncloseTheCorridor) {
  const auto generator = family("follow_path");
  RandomEngine engine(6);
  for (int i = 0; i < 60; ++i) {
    const Scenario scenario = generator->generate("x", engine);
    const Bounds& b = scenario.bounds();
    const Bounds beyond = {b.x_min - 50, b.y_min - 50, b.x_max + 50, b.y_max + 50};
    const auto line = corridor_of(scenario).center;
    // No ray from the center line gets out.
    for (std::size_t k = 1; k < line.size(); ++k)
      for (double a = 0; a < 2 * M_PI; a += M_PI / 90)
        EXPECT_LT(cast_ray(scenario.primitives(), beyond, (line[k - 1] + line[k]) * 0.5, a, 49),
                  49);
  }
}

TEST(FollowPath, TheLastSegmentIsLongerIfMinDistanceRequiresIt) {
  const auto generator = family("follow_path",
                                "min_segments = 1\nmax_segments = 2\nmin_segment_length = 2\n"
                                "max_segment_length = 4\nmin_distance = 6\n");
  RandomEngine engine(6);
  for (int i = 0; i < 60; ++i) {
    const Scenario scenario = generator->generate("x", engine);
    EXPECT_GE(distance_between(scenario.start(), scenario.goal()), 6);
    EXPECT_LT(distance_between(scenario.start(), scenario.goal()), 7);
  }
}

TEST(FollowPath, EveryDrawOfTheDefaultsIsSolvable) {
  expect_solvable("follow_path", 1);
}

TEST(FollowPath, OptionsWithoutARangeGiveDistinctScenarios) {
  expect_distinct("follow_path",
                  "min_segments = 1\nmax_segments = 1\nmin_segment_length = 4\n"
                  "max_segment_length = 4\nmin_width = 1\nmax_width = 1\n"
                  "max_angle_deg = 0\n");
}

TEST(FollowPath, RejectsInvalidOptions) {
  expect_refusals(
      "follow_path",
      {{"min_segments = 6\n", "max_segments: is less than min_segments"},
       {"min_segment_length = 5\n", "max_segment_length: is less than min_segment_length"},
       {"min_turn_deg = 70\n", "max_turn_deg: is less than min_turn_deg"},
       {"max_turn_deg = 90\n", "max_turn_deg"},
       {"min_width = 2\n", "max_width: is less than min_width"},
       {"min_angle_deg = 40\n", "max_angle_deg: is less than min_angle_deg"},
       // (1.6 m + 2 * 0.15 m) tan(30 deg) = 1.1 m.
       {"min_segment_length = 1.05\n", "min_segment_length: leaves no wall between two turns"},
       {"margin = 1\n", "margin: places start and goal outside"},
       {"clear_radius = 0.55\n", "clear_radius: reaches the walls"},
       {"min_distance = 20\n", "min_distance: start and goal cannot be min_distance apart"}});
}

}  // namespace
}  // namespace slalom
