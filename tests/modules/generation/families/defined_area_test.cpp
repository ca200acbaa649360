// SPDX-License-Identifier: BSD-3-Clause
#include "family_samples.h"

#include <slalom/core/distance.h>
#include <slalom/scenario/geometry.h>

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

Bounds bounds_of(const Polygon& rectangle) {
  const auto& v = rectangle.vertices;
  EXPECT_EQ(v.size(), 4U);
  return {v[0].x, v[0].y, v[2].x, v[2].y};
}

/// The area within the four outer walls of a scenario, and its aisles.
struct Area {
  Bounds inside;
  std::vector<Bounds> walls;  ///< between aisles
  std::vector<Bounds> boxes;
  double width = 0;
};

/// Takes the area from the polygons, with walls of 0.15 m between this number of aisles.
Area area_of(const Scenario& scenario, int aisles) {
  std::vector<Bounds> all;
  for (const Polygon& polygon : scenario.primitives().polygons) all.push_back(bounds_of(polygon));
  const auto first = all.begin() + 4, last = first + aisles - 1;
  Area area = {
      {all[2].x_max, all[0].y_max, all[3].x_min, all[1].y_min}, {first, last}, {last, all.end()}};
  area.width = (area.inside.height() - (aisles - 1) * 0.15) / aisles;
  return area;
}

/// The line along the middle of all aisles and turns, from start to goal.
std::vector<TPoint2D> middle(const Scenario& scenario, const Area& area, int aisles) {
  const TPoint2D start(scenario.start().x, scenario.start().y);
  const double step = (scenario.goal().y - start.y) / (aisles - 1);
  const double left = area.inside.x_min + area.width / 2,
               right = area.inside.x_max - area.width / 2;
  std::vector<TPoint2D> line = {start};
  for (int i = 0; i + 1 < aisles; ++i) {
    const double x = i % 2 == 0 ? right : left, y = start.y + i * step;
    line.emplace_back(x, y);
    line.emplace_back(x, y + step);
  }
  line.push_back(scenario.goal());
  return line;
}

TEST(DefinedArea, AislesAndTurnsHaveTheClearWidth) {
  for (const int aisles : {2, 3, 4, 5}) {
    const std::string n = std::to_string(aisles);
    const auto generator = family(
        "defined_area", "min_aisles = " + n + "\nmax_aisles = " + n +
                            "\nmin_width = 1\nmax_width = 1.2\nlength = 6\nmax_impairments = 0\n");
    RandomEngine engine(3);
    for (int i = 0; i < 20; ++i) {
      const Scenario scenario = generator->generate("x", engine);
      const Area area = area_of(scenario, aisles);
      EXPECT_NEAR(area.inside.width(), 6, kRoundingError);
      expect_within(area.width, 1, 1.2);
      EXPECT_EQ(scenario.primitives().polygons.size(), 4U + static_cast<std::size_t>(aisles) - 1);
      // A disc of exactly the width passes along the middle, and touches walls all the time.
      const auto line = middle(scenario, area, aisles);
      double most = 0;
      for (std::size_t k = 1; k < line.size(); ++k)
        for (double f = 0; f <= 1; f += 1.0 / 64) {
          const double clearance =
              wall_clearance(scenario, line[k - 1] + (line[k] - line[k - 1]) * f);
          EXPECT_GE(clearance, area.width / 2 - kRoundingError);
          most = std::max(most, clearance);
        }
      EXPECT_LE(most, area.width / 2 + kRoundingError);
      // Right of odd walls, left of even ones, each opening is as wide.
      for (std::size_t k = 0; k < area.walls.size(); ++k) {
        const bool is_right = k % 2 == 0;
        const Bounds& wall = area.walls[k];
        EXPECT_NEAR(is_right ? area.inside.x_max - wall.x_max : wall.x_min - area.inside.x_min,
                    area.width, kRoundingError);
        EXPECT_EQ(is_right ? wall.x_min : wall.x_max,
                  is_right ? area.inside.x_min : area.inside.x_max);
      }
    }
  }
}

TEST(DefinedArea, BoxesLeaveTheFractionOfTheWidth) {
  const auto generator = family("defined_area",
                                "min_aisles = 3\nmax_aisles = 3\nmin_impairments = 4\n"
                                "max_impairments = 4\nmin_free = 0.65\nmax_free = 0.75\n"
                                "impairment = 0.3\n");
  RandomEngine engine(8);
  int below = 0, all = 0;
  for (int i = 0; i < 100; ++i) {
    const Scenario scenario = generator->generate("x", engine);
    const Area area = area_of(scenario, 3);
    const auto low_of_aisle = [&](const Bounds& box) {
      const double row = area.width + 0.15, y = (box.y_min + box.y_max) / 2 - area.inside.y_min;
      return area.inside.y_min + std::floor(y / row) * row;
    };
    for (const Bounds& box : area.boxes) {
      expect_within(1 - box.height() / area.width, 0.65, 0.75);
      EXPECT_NEAR(box.width(), 0.3, kRoundingError);
      const double low = low_of_aisle(box), high = low + area.width;
      const bool is_below = std::abs(box.y_min - low) < kRoundingError;
      EXPECT_NEAR(is_below ? box.y_min : box.y_max, is_below ? low : high, kRoundingError);
      // Not in a turn, and with the width of the aisle to the next one in it.
      expect_within(box.x_min, area.inside.x_min + area.width, 99);
      expect_within(box.x_max, 0, area.inside.x_max - area.width);
      for (const Bounds& other : area.boxes)
        if (&other != &box && low_of_aisle(other) == low)
          expect_within(std::abs(other.x_min - box.x_min) - 0.3, area.width, 99);
      below += is_below ? 1 : 0;
      ++all;
    }
  }
  // 400 throws of a coin; four boxes in three aisles always find a place in 60 draws.
  EXPECT_EQ(all, 400);
  EXPECT_NEAR(below, 200, 60);
}

TEST(DefinedArea, TheWayLeadsFromTheFirstAisleToTheLastOne) {
  const auto generator = family("defined_area", "min_angle_deg = 5\nmax_angle_deg = 25\n");
  RandomEngine engine(2);
  int upward = 0, turned_left = 0, by_aisles[5] = {};
  for (int i = 0; i < 300; ++i) {
    const Scenario scenario = generator->generate("x", engine);
    const Bounds inside = area_of(scenario, 2).inside;
    const double height = inside.height(), way = scenario.goal().y - scenario.start().y;
    // The start is half of the width away from the closed end, the goal in the opposite row.
    const double width = 2 * (scenario.start().x - inside.x_min);
    const double aisles = (height + 0.15) / (width + 0.15);
    EXPECT_NEAR(aisles, std::round(aisles), kRoundingError);
    ++by_aisles[std::lround(aisles)];
    EXPECT_NEAR(std::abs(way), height - width, kRoundingError);
    expect_angle_within(scenario.start().phi, 5, 25);
    upward += way > 0 ? 1 : 0;
    turned_left += scenario.start().phi > 0 ? 1 : 0;
  }
  // 300 throws of a coin, and of a die with three sides.
  EXPECT_NEAR(upward, 150, 50);
  EXPECT_NEAR(turned_left, 150, 50);
  for (const int aisles : {2, 3, 4}) EXPECT_NEAR(by_aisles[aisles], 100, 45);
}

TEST(DefinedArea, NearlyEveryDrawOfTheDefaultsIsSolvable) {
  expect_solvable("defined_area", 2);
}

TEST(DefinedArea, OptionsWithoutARangeGiveDistinctScenarios) {
  expect_distinct("defined_area",
                  "min_width = 1\nmax_width = 1\nmin_aisles = 2\nmax_aisles = 2\n"
                  "max_impairments = 0\nmax_angle_deg = 0\n");
}

TEST(DefinedArea, FollowsFromWidthAndLength) {
  // The same random numbers at twice the scale.
  RandomEngine one(8), other(8);
  const Scenario small = family("defined_area")->generate("x", one);
  const Scenario large = family("defined_area", "", with_hall(2))->generate("x", other);
  const auto &a = small.primitives().polygons, &b = large.primitives().polygons;
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(distance_between(a[i].vertices[k] * 2.0, b[i].vertices[k]), 0, kRoundingError);
}

TEST(DefinedArea, RejectsInvalidOptions) {
  expect_refusals(
      "defined_area",
      {{"min_width = 2\n", "max_width: is less than min_width"},
       {"max_width = 4\n", "max_width: leaves no wall between the turns"},
       {"min_aisles = 5\n", "max_aisles: is less than min_aisles"},
       {"min_aisles = 1\n", "min_aisles"},
       {"min_impairments = 3\n", "max_impairments: is less than min_impairments"},
       {"min_free = 0.95\n", "max_free: is less than min_free"},
       {"impairment = 6\n", "impairment: does not fit between the turns"},
       {"min_angle_deg = 40\n", "max_angle_deg: is less than min_angle_deg"},
       {"margin = 0.5\n", "margin: places the start outside the aisle"},
       {"clear_radius = 0.5\n", "clear_radius: reaches the walls"},
       {"min_distance = 7\n", "min_distance: start and goal cannot be min_distance apart"}});
}

}  // namespace
}  // namespace slalom
