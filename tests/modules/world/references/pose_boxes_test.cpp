// SPDX-License-Identifier: BSD-3-Clause
#include "pose_boxes.h"
#include "reference_worlds.h"

#include <slalom/core/distance.h>
#include <slalom/core/random.h>
#include <slalom/references/footprint_contact.h>
#include <slalom/references/footprint_path.h>

#include <gtest/gtest.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <cmath>
#include <deque>
#include <set>
#include <tuple>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

std::size_t random_index(RandomEngine& engine, int size) {
  return static_cast<std::size_t>(uniform_int(engine, 0, size - 1));
}

/// Rows from the top; '#' is occupied.
World world_of(const std::vector<std::string>& rows, double resolution, const TPose2D& start,
               const TPoint2D& goal) {
  const auto height = static_cast<int>(rows.size()), width = static_cast<int>(rows[0].size());
  mrpt::maps::COccupancyGridMap2D map;
  const auto side = static_cast<float>(resolution);
  map.setSize(0, static_cast<float>(width) * side, 0, static_cast<float>(height) * side, side,
              1.0F);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (rows[static_cast<std::size_t>(height - 1 - y)][static_cast<std::size_t>(x)] == '#')
        map.setCell(x, y, 0.0F);
  return {Scenario::grid("rows", map, start, goal), resolution};
}

bool is_proved(const World& world, const Footprint& footprint, int divisions, double reach = 0) {
  const Scenario& scenario = world.scenario();
  return is_obstructed(world, footprint, scenario.start(), scenario.goal(), reach, divisions);
}

/// A room of 6 m x 6 m with a wall 0.2 m thick and a door of `cells` x 0.05 m.
World door(int cells, int divider = 120) {
  std::vector<std::string> rows(120, std::string(120, ' '));
  for (int y = 0; y < divider; ++y)
    if (y < 60 - cells / 2 || y >= 60 - cells / 2 + cells)
      rows[static_cast<std::size_t>(y)].replace(58, 4, "####");
  return world_of(rows, 0.05, {1.5, 1.5, 0.3}, {4.5, 4.5});
}

TEST(FootprintProof, ADoorNarrowerThanTheRobotIsNoWay) {
  // The widths of the robots are 0.42 and 0.58 m, the least ones, along a diagonal too.
  for (const int divisions : {1, 2, 4}) {
    EXPECT_TRUE(is_proved(door(7), Footprint::parse(kRectangle), divisions));
    EXPECT_FALSE(is_proved(door(9), Footprint::parse(kRectangle), divisions));
    EXPECT_TRUE(is_proved(door(10), Footprint::parse(kRearAxle), divisions));
    EXPECT_FALSE(is_proved(door(12), Footprint::parse(kRearAxle), divisions));
  }
  EXPECT_FALSE(is_proved(door(7, 100), Footprint::parse(kRectangle), 1)) << "around the wall";
  EXPECT_FALSE(is_proved(door(7), Footprint::disc(0.42), 1)) << "discs have proofs of their own";
}

TEST(FootprintProof, AGoalIsNearEnoughWithinItsReach) {
  // The center is on the axis of the robot, 0.2 m from its rear.
  std::vector<std::string> rows(80, std::string(80, ' '));
  const World corner = world_of(rows, 0.05, {2, 2, 0}, {0.12, 2});
  EXPECT_TRUE(is_proved(corner, Footprint::parse(kRearAxle), 2));
  EXPECT_TRUE(is_proved(corner, Footprint::parse(kRearAxle), 2, 0.03));
  EXPECT_FALSE(is_proved(corner, Footprint::parse(kRearAxle), 2, 0.1));
}

TEST(FootprintProof, ARobotThatCannotTurnAroundIsNotHeldByItsPosition) {
  // A corridor of 0.5 m with a bend: the rectangle, 0.84 m long, drives in, but not around it.
  std::vector<std::string> rows(60, std::string(60, '#'));
  for (std::size_t y = 40; y < 50; ++y)
    for (std::size_t x = 2; x < 40; ++x) rows[y][x] = ' ';
  for (std::size_t y = 2; y < 50; ++y)
    for (std::size_t x = 30; x < 40; ++x) rows[y][x] = ' ';
  const World bend = world_of(rows, 0.05, {0.7, 0.75, 0}, {1.75, 2.2});
  EXPECT_TRUE(is_proved(bend, Footprint::parse(kRectangle), 1));
  EXPECT_FALSE(is_proved(bend, Footprint::parse("0.2,0.2; -0.2,0.2; -0.2,-0.2; 0.2,-0.2"), 1));
}

/// A room of 5 m x 5 m with squares of 0.4 m, start and goal in opposite corners.
World squares(RandomEngine& engine) {
  std::vector<std::string> rows(100, std::string(100, ' '));
  for (int i = 0; i < 25; ++i) {
    const std::size_t x = random_index(engine, 92), y = random_index(engine, 92);
    if ((x < 34 && y > 58) || (x > 58 && y < 34)) continue;
    for (std::size_t k = 0; k < 8; ++k) rows[y + k].replace(x, 8, "########");
  }
  return world_of(rows, 0.05, {0.8, 0.8, uniform_real(engine, -3, 3)}, {4.2, 4.2});
}

/// Whether steps between free poses of a fine lattice lead to the goal: by brute force.
bool is_connected_by_samples(const World& world, const Footprint& footprint) {
  constexpr int kHeadings = 72;
  const Occupancy& cells = world.occupancy();
  const double step = cells.resolution() / 4;
  const auto contact = make_footprint_contact(world, footprint);
  const TPose2D start = world.scenario().start();
  const TPoint2D goal = world.scenario().goal();
  using Node = std::tuple<int, int, int>;
  const auto pose = [&](const Node& node) {
    const auto [x, y, heading] = node;
    return TPose2D(start.x + x * step, start.y + y * step,
                   start.phi + heading * 2 * M_PI / kHeadings);
  };
  std::set<Node> seen = {{0, 0, 0}};
  std::deque<Node> open(seen.begin(), seen.end());
  while (!open.empty()) {
    const Node node = open.front();
    open.pop_front();
    if (distance_between(TPoint2D(pose(node)), goal) <= step) return true;
    const auto [x, y, heading] = node;
    for (const Node& next :
         {Node{x + 1, y, heading}, Node{x - 1, y, heading}, Node{x, y + 1, heading},
          Node{x, y - 1, heading}, Node{x, y, (heading + 1) % kHeadings},
          Node{x, y, (heading + kHeadings - 1) % kHeadings}})
      if (seen.count(next) == 0 && !contact->touches(pose(next))) {
        seen.insert(next);
        open.push_back(next);
      }
  }
  return false;
}

TEST(FootprintProof, NeverContradictsBruteForceInSmallWorlds) {
  int proved = 0, connected = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    RandomEngine engine(seed);
    std::vector<std::string> rows(14, std::string(14, ' '));
    for (int i = 0; i < 30; ++i) rows[random_index(engine, 14)][random_index(engine, 14)] = '#';
    for (std::size_t y = 0; y < 14; ++y)
      for (std::size_t x = 0; x < 14; ++x)
        if ((x < 5 && y > 8) || (x > 8 && y < 5)) rows[y][x] = ' ';
    const World world =
        world_of(rows, 0.1, {0.25, 0.25, uniform_real(engine, -3, 3)}, {1.15, 1.15});
    for (const char* text :
         {"0.22,0.1; -0.22,0.1; -0.22,-0.1; 0.22,-0.1",
          "0.2,0.05; -0.05,0.05; -0.05,-0.2; 0.05,-0.2; 0.05,-0.05; 0.2,-0.05"}) {
      const Footprint footprint = Footprint::parse(text);
      if (make_footprint_contact(world, footprint)->touches(world.scenario().start())) continue;
      const bool is_reached = is_connected_by_samples(world, footprint);
      connected += is_reached ? 1 : 0;
      for (const int divisions : {1, 2, 4}) {
        const bool is_none = is_proved(world, footprint, divisions, 0.025);
        EXPECT_FALSE(is_none && is_reached) << seed << " " << text << " " << divisions;
        proved += is_none ? 1 : 0;
      }
    }
  }
  EXPECT_GT(connected, 3);
  EXPECT_GT(proved, 5);
}

/// Poses that no box near them lets to a goal that is everywhere.
template <std::size_t kDivisions>
int count_closed(const World& world, const Footprint& footprint,
                 const PoseBoxes<kDivisions>& boxes) {
  RandomEngine engine(6);
  const auto contact = make_footprint_contact(world, footprint);
  int closed = 0;
  for (int i = 0; i < 5000; ++i) {
    const TPose2D pose(uniform_real(engine, 0, 5), uniform_real(engine, 0, 5),
                       uniform_real(engine, -M_PI, M_PI));
    if (!boxes.separates(pose)) continue;
    EXPECT_TRUE(contact->touches(pose)) << pose << " " << kDivisions;
    ++closed;
  }
  return closed;
}

TEST(FootprintProof, TheRobotTouchesSomethingAtEachPoseOfAClosedBox) {
  RandomEngine engine(5);
  const World world = squares(engine);
  for (const char* text : {kRectangle, kRearAxle, kCorner}) {
    const Footprint footprint = Footprint::parse(text);
    const TPoint2D middle(2.5, 2.5);
    const PoseBoxes<1> large(world, footprint, middle, 10);
    const PoseBoxes<2> small(world, footprint, middle, 10),
        divided(world, footprint, middle, 10, large);
    const PoseBoxes<4> smallest(world, footprint, middle, 10, divided);
    const int coarse = count_closed(world, footprint, large),
              fine = count_closed(world, footprint, small),
              finer = count_closed(world, footprint, smallest);
    EXPECT_GT(coarse, 1000);
    EXPECT_GT(fine, coarse) << "smaller boxes close more";
    EXPECT_GT(finer, fine);
    EXPECT_NEAR(count_closed(world, footprint, divided), fine, 0.01 * fine)
        << "hardly a box that is not divided has closed ones in it";
  }
}

TEST(FootprintProof, NeverContradictsAPathThatIsFound) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    RandomEngine engine(seed);
    const World world = squares(engine);
    for (const char* text : {kRectangle, kRearAxle, kCorner}) {
      const Footprint footprint = Footprint::parse(text);
      const auto contact = make_footprint_contact(world, footprint);
      std::string reason;
      if (contact->touches(world.scenario().start()) ||
          !find_footprint_path(world, footprint, world.scenario().start(), world.scenario().goal(),
                               0, reason, SearchEffort::Thorough))
        continue;
      for (const int divisions : {1, 2, 4})
        EXPECT_FALSE(is_proved(world, footprint, divisions, footprint.half_width() / 6))
            << seed << " " << text << " " << divisions;
    }
  }
}

}  // namespace
}  // namespace slalom
