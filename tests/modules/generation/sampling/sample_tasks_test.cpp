// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/generation/generator.h>
#include <slalom/references/exact_shortest.h>
#include <slalom/references/footprint_path.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace slalom {
namespace {

/// Two rooms of 10 m x 10 m, optionally connected by a door of 1 m.
Scenario two_rooms(bool door) {
  mrpt::maps::COccupancyGridMap2D map(0, 20, 0, 10, 0.1F);
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 200; ++x) {
      const bool wall = x == 100 && !(door && y >= 45 && y < 55);
      map.setCell(x, y, wall ? 0.0F : 1.0F);
    }
  return Scenario::grid("rooms", map, {0.05, 0.05, 0}, {0.05, 0.05});
}

GenerationSettings pairs(int count) {
  GenerationSettings settings;
  settings.count = count;
  settings.seed = 3;
  settings.name_prefix = "rooms";
  return settings;
}

TEST(SampleTasks, PairsAreSolvableDistinctAndFarEnoughApart) {
  const auto scenarios = sample_tasks(two_rooms(true), pairs(10), 6);
  std::set<std::string> hashes;
  for (const Scenario& s : scenarios) {
    hashes.insert(s.hash());
    EXPECT_GE(std::hypot(s.goal().x - s.start().x, s.goal().y - s.start().y), 6);
    const World world(s, 0.1);
    std::string reason;
    EXPECT_TRUE(exact_shortest_path({world, 0.25, {s.start().x, s.start().y}, s.goal()}, reason)
                    .has_value())
        << reason;
  }
  EXPECT_EQ(hashes.size(), 10U);
}

TEST(SampleTasks, ADistanceThatIsLargerThanTheMapIsRefused) {
  const Scenario map = two_rooms(true);
  const double diagonal = std::hypot(map.bounds().width(), map.bounds().height());
  try {
    sample_tasks(map, pairs(1), 1.01 * diagonal);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("whose diagonal is"), std::string::npos)
        << error.what();
  }
}

TEST(SampleTasks, AreThoseOfTheShapeOfARobotThatTurnsInPlace) {
  // 1.2 m long and 0.6 m wide, with its center at the rear: its disc of 0.95 m does not pass the
  // door of 1 m.
  GenerationSettings settings = pairs(12);
  settings.footprint = Footprint::parse("0.9,0.3; -0.3,0.3; -0.3,-0.3; 0.9,-0.3");
  settings.robot_radius = settings.footprint->enclosing_radius();
  int through = 0;
  for (const Scenario& s : sample_tasks(two_rooms(true), settings, 6)) {
    const World world(s, 0.1);
    std::string reason;
    EXPECT_TRUE(find_footprint_path(world, *settings.footprint, s.start(), s.goal(), 0.01, reason))
        << reason;
    EXPECT_GE(world.distance_field().clearance({s.start().x, s.start().y}), settings.robot_radius);
    through += (s.start().x < 10) != (s.goal().x < 10) ? 1 : 0;
  }
  EXPECT_GT(through, 0);
  settings.footprint.reset();
  for (const Scenario& s : sample_tasks(two_rooms(true), settings, 6))
    EXPECT_EQ(s.start().x < 10, s.goal().x < 10);
}

TEST(SampleTasks, NeverPairsUnconnectedRooms) {
  for (const Scenario& s : sample_tasks(two_rooms(false), pairs(20), 3))
    EXPECT_EQ(s.start().x < 10, s.goal().x < 10);
}

double straight(const Scenario& s) {
  return std::hypot(s.goal().x - s.start().x, s.goal().y - s.start().y);
}

double shortest(const Scenario& s) {
  const World world(s, 0.1);
  std::string reason;
  return exact_shortest_path({world, 0.25, {s.start().x, s.start().y}, s.goal()}, reason)->length;
}

TEST(SampleTasks, RespectsTheRangeOfDistances) {
  TaskConstraints limits;
  limits.min_distance = 3;
  limits.max_distance = 3.5;
  for (const Scenario& s : sample_tasks(two_rooms(true), pairs(20), limits)) {
    EXPECT_GE(straight(s), 3);
    EXPECT_LE(straight(s), 3.5);
  }
}

TEST(SampleTasks, RespectsTheRangeOfPathLengths) {
  TaskConstraints limits;
  limits.min_distance = 0;
  limits.min_length = 8;
  limits.max_length = 9;
  for (const Scenario& s : sample_tasks(two_rooms(true), pairs(10), limits)) {
    EXPECT_GE(shortest(s), 8);
    EXPECT_LE(shortest(s), 9);
  }
}

TEST(SampleTasks, RespectsTheRangeOfDetours) {
  TaskConstraints limits;  // 1.25 times the straight line: only through the door
  limits.min_distance = 1;
  limits.min_detour = 1.25;
  limits.max_detour = 3;
  for (const Scenario& s : sample_tasks(two_rooms(true), pairs(10), limits)) {
    EXPECT_GE(shortest(s) / straight(s), 1.25);
    EXPECT_LE(shortest(s) / straight(s), 3);
    EXPECT_NE(s.start().x < 10, s.goal().x < 10);
  }
}

TEST(SampleTasks, ReportsThatNoPairHasTheRequiredDetour) {
  TaskConstraints limits;  // without a door each pair lies in one room, without obstacles between
  limits.min_detour = 1.5;
  GenerationSettings settings = pairs(1);
  settings.attempts_per_scenario = 5;
  try {
    sample_tasks(two_rooms(false), settings, limits);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.exit_status(), 1);
    EXPECT_NE(std::string(e.what()).find("5 times: the path's detour ratio"), std::string::npos)
        << e.what();
  }
}

TEST(SampleTasks, RejectsContradictoryLimits) {
  const auto exit_status = [](const TaskConstraints& limits) {
    try {
      sample_tasks(two_rooms(true), pairs(1), limits);
    } catch (const Error& e) {
      return e.exit_status();
    }
    return 0;
  };
  TaskConstraints limits;
  limits.max_distance = 3;  // below the default minimum of 4
  EXPECT_EQ(exit_status(limits), 2);
  limits = {};
  limits.min_length = 5;
  limits.max_length = 4;
  EXPECT_EQ(exit_status(limits), 2);
  limits = {};
  limits.min_detour = 0.5;
  EXPECT_EQ(exit_status(limits), 2);
}

TEST(SampleTasks, ReportsWhyThereAreNoPairs) {
  GenerationSettings settings = pairs(1);
  settings.attempts_per_scenario = 3;
  const Scenario map = two_rooms(true);
  try {
    sample_tasks(map, settings, std::hypot(map.bounds().width(), map.bounds().height()));
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.exit_status(), 1);
    EXPECT_NE(std::string(e.what()).find("no connected pair of free positions"), std::string::npos);
  }
}

}  // namespace
}  // namespace slalom
