// SPDX-License-Identifier: BSD-3-Clause
#include "message_bytes.h"
#include "recorded_runs.h"

#include <slalom/core/distance.h>
#include <slalom/rawlog/log_map.h>
#include <slalom/scenario/world.h>

#include <cmath>
#include <error_text.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using testing::kSecond;
using testing::Layout;
using testing::pose_numbers;

class LogMapTest : public testing::RecordedRunTest {
 protected:
  void add_scan(std::int64_t stamp, const std::vector<float>& ranges) {
    writer_.add({"/scan", "sensor_msgs/LaserScan", stamp,
                 testing::scan_bytes(Layout::CdrLittle, stamp, "base_link", -1, 1, 10, ranges)});
  }
  void add_odometry(std::int64_t stamp, const std::vector<double>& pose) {
    writer_.add({"/odom", "nav_msgs/Odometry", stamp,
                 testing::odometry_bytes(Layout::CdrLittle, stamp, "base_link", pose, 0, 0)});
  }
  void add_frame(std::int64_t stamp, const std::string& parent, const std::string& child,
                 const std::vector<double>& pose) {
    writer_.add({"/tf", "tf2_msgs/TFMessage", stamp,
                 testing::transform_bytes(Layout::CdrLittle, stamp, parent, child, pose)});
  }
  /// Four by three cells of 0.5 m from (10, 20).
  void add_grid(const std::vector<std::int8_t>& cells, double yaw = 0,
                const std::string& topic = "/map") {
    testing::ByteList grid(Layout::CdrLittle);
    grid.header(kSecond, "map").add(std::uint32_t{0}).add(std::uint32_t{0}).floats({0.5F});
    grid.add(std::uint32_t{4}).add(std::uint32_t{3}).doubles(pose_numbers(10, 20, yaw));
    grid.add(std::uint32_t(cells.size()));
    for (const std::int8_t cell : cells) grid.add(static_cast<std::uint8_t>(cell));
    writer_.add({topic, "nav_msgs/OccupancyGrid", kSecond, grid.bytes()});
  }
  /// A robot that drives from (11, 20.75) to (11.5, 20.75) in the map.
  void add_drive_in_map() {
    add_frame(kSecond, "map", "odom", pose_numbers(11, 20.75, 0));
    for (int i = 0; i <= 5; ++i)
      add_frame(kSecond * (i + 1), "odom", "base_link", pose_numbers(0.1 * i, 0, 0));
  }

  LogMap load(const LogMapOptions& options = {}) {
    testing::write_bytes(path("a.mcap"), writer_.bytes());
    return load_log_map(path("a.mcap"), options);
  }
  ::testing::AssertionResult refuses(std::initializer_list<std::string> words) {
    return throws_error(ErrorKind::File, path("a.mcap"), words, [&] { load(); });
  }

  testing::McapWriter writer_;
};

TEST_F(LogMapTest, OfARecordedRunShowsTheObstaclesThatWereThere) {
  RunSetup setup;
  setup.sensor.aperture_deg = 270;
  setup.sensor.rays = 541;
  setup.simulation.max_time = 12;
  auto method = testing::constant_method(0.5, 0.12);
  const auto run = testing::simulate_run(path("run.rawlog"), method, setup);
  ASSERT_GT(run.cycles.size(), 50U);
  const LogMap map = load_log_map(path("run.rawlog"), {});
  const Scenario scenario = testing::some_discs();
  const World world(scenario, setup.simulation.resolution);
  int occupied = 0, free = 0;
  for (unsigned y = 0; y < map.grid.getSizeY(); ++y)
    for (unsigned x = 0; x < map.grid.getSizeX(); ++x) {
      const TPoint2D cell(static_cast<double>(map.grid.idx2x(x)),
                          static_cast<double>(map.grid.idx2y(y)));
      if (!scenario.bounds().contains(cell)) continue;  // its walls are occupied
      const double clearance = world.distance_field().clearance(cell);
      const float value = map.grid.getCell(static_cast<int>(x), static_cast<int>(y));
      // A ray ends on the border of an obstacle, one cell from a center that it marks.
      constexpr double kCell = 0.08;  // the diagonal of a cell, with an allowance for rounding
      if (value < 0.5F) {
        ++occupied;
        EXPECT_LT(clearance, kCell) << cell.x << " " << cell.y;
      } else if (value > 0.5F) {
        ++free;
        double inside = HUGE_VAL;  // how deep in a disc
        for (const Disc& disc : scenario.primitives().discs)
          inside = std::min(inside, distance_between(cell, disc.center) - disc.radius);
        EXPECT_GT(inside, -kCell) << cell.x << " " << cell.y;
      }
    }
  EXPECT_GT(occupied, 200);
  EXPECT_GT(free, 10'000);
  const auto& poses = run.cycles;
  EXPECT_EQ(map.start.x, poses.front().observation.odometry.x);
  EXPECT_EQ(map.goal.x, poses.back().observation.odometry.x);
  EXPECT_EQ(map.goal.y, poses.back().observation.odometry.y);
}

TEST_F(LogMapTest, WhatTheRobotCoveredIsFreeAlsoWhereNoRayWas) {
  for (int i = 0; i <= 10; ++i) {
    add_odometry(kSecond * (i + 1), pose_numbers(0.2 * i, 0, 0));
    add_scan(kSecond * (i + 1) + 5, {4, 4, 4});
  }
  const LogMap map = load({0.05, 0.4});
  EXPECT_EQ(map.start.x, 0);
  EXPECT_EQ(map.goal.x, 2);
  for (double x = 0; x <= 2; x += 0.05)
    for (const double y : {-0.39, 0.0, 0.39})
      EXPECT_GT(map.grid.getPos(static_cast<float>(x), static_cast<float>(y)), 0.5F) << x;
  // Beside all rays: free up to four radii, then unknown.
  EXPECT_GT(map.grid.getPos(0.5F, 1.55F), 0.9F);
  EXPECT_EQ(map.grid.getPos(0.5F, 1.75F), 0.5F);
  const LogMap open = load({0.05, 0.4, true});
  EXPECT_GT(open.grid.getPos(0.5F, 1.75F), 0.9F);
}

TEST_F(LogMapTest, OfABagWithAMapIsThatMapAndTheDriveInIt) {
  add_grid({100, 0, 0, 0, 0, 0, 100, 0, 64, 65, 26, 25});
  add_drive_in_map();
  const LogMap map = load({0.05, 0.02});
  ASSERT_EQ(map.grid.getSizeX(), 4U);
  ASSERT_EQ(map.grid.getSizeY(), 3U);
  EXPECT_NEAR(map.grid.getXMin(), 10, 1e-6);
  EXPECT_NEAR(map.grid.getYMin(), 20, 1e-6);
  EXPECT_LT(map.grid.getCell(0, 0), 0.1F);
  EXPECT_GT(map.grid.getCell(1, 0), 0.9F);
  // The robot was in the cells around (11 to 11.5, 20.75).
  EXPECT_GT(map.grid.getCell(2, 1), 0.9F);
  EXPECT_EQ(map.grid.getCell(0, 2), 0.5F);
  EXPECT_LT(map.grid.getCell(1, 2), 0.1F);
  EXPECT_EQ(map.grid.getCell(2, 2), 0.5F);
  EXPECT_GT(map.grid.getCell(3, 2), 0.9F);
  EXPECT_NEAR(map.start.x, 11, 1e-9);
  EXPECT_NEAR(map.start.y, 20.75, 1e-9);
  EXPECT_NEAR(map.goal.x, 11.5, 1e-9);
  EXPECT_EQ(map.notes[0], "map of '/map'");
}

/// Columns of 0.5 m: the robot, unseen cells, a wall, unseen cells. Four radii reach the latter.
TEST_F(LogMapTest, UnseenCellsBesideTheDriveAreFreeButNotBehindObstacles) {
  const std::vector<std::int8_t> row{-1, 100, -1, 0};
  std::vector<std::int8_t> cells;
  for (int y = 0; y < 3; ++y) cells.insert(cells.end(), row.begin(), row.end());
  add_grid(cells);
  add_frame(kSecond, "map", "odom", pose_numbers(11.75, 20.25, 1.5707963267948966));
  for (int i = 0; i <= 5; ++i)
    add_frame(kSecond * (i + 1), "odom", "base_link", pose_numbers(0.1 * i, 0, 0));
  const LogMap map = load({0.05, 0.4});
  for (int y = 0; y < 3; ++y) {
    EXPECT_GT(map.grid.getCell(2, y), 0.9F);
    EXPECT_LT(map.grid.getCell(1, y), 0.1F);
    EXPECT_EQ(map.grid.getCell(0, y), 0.5F);
  }
  EXPECT_TRUE(mentions(map.notes.back(), {"unseen cells", "1.6 m", "--unknown-free"}));
}

TEST_F(LogMapTest, TheMapIsPreferredToCostmaps) {
  add_grid(std::vector<std::int8_t>(12, 100), 0, "/costmap");
  add_grid(std::vector<std::int8_t>(12, 0));
  add_grid(std::vector<std::int8_t>(12, 100), 0, "/local_costmap");
  add_drive_in_map();
  EXPECT_GT(load().grid.getCell(0, 0), 0.9F);
}

TEST_F(LogMapTest, WithoutTransformsToItTheMapIsNotUsed) {
  add_grid(std::vector<std::int8_t>(12, 0));
  for (int i = 0; i <= 10; ++i) {
    add_odometry(kSecond * (i + 1), pose_numbers(0.2 * i, 0, 0));
    add_scan(kSecond * (i + 1) + 5, {4, 4, 4});
  }
  const LogMap map = load();
  EXPECT_EQ(map.start.x, 0);
  ASSERT_GT(map.notes.size(), 1U);
  EXPECT_TRUE(mentions(map.notes[map.notes.size() - 2],
                       {"'/map' is not used", "from 'map' to 'base_footprint'"}));
}

TEST_F(LogMapTest, RefusesLogsWithoutADrive) {
  add_scan(kSecond, {4, 4, 4});
  EXPECT_TRUE(refuses({"has no odometry"}));
  add_odometry(kSecond / 2, pose_numbers(1, 2, 0));
  add_scan(2 * kSecond, {4, 4, 4});
  EXPECT_TRUE(refuses({"the robot does not move"}));
  add_odometry(3 * kSecond, pose_numbers(1e6, 2, 0));
  add_scan(4 * kSecond, {4, 4, 4});
  EXPECT_TRUE(refuses({"covers 1000", "at most 400 million cells of 0.05 m"}));
}

TEST_F(LogMapTest, RefusesARotatedMap) {
  add_grid(std::vector<std::int8_t>(12, 0), 0.1);
  add_drive_in_map();
  EXPECT_TRUE(refuses({"/map: is empty or rotated"}));
}

TEST_F(LogMapTest, ALogIsKnownByItsContentOrName) {
  testing::write_bytes(path("a"), writer_.bytes());
  testing::write_bytes(path("b.png"), "no log");
  EXPECT_TRUE(is_log(path("a")));
  EXPECT_TRUE(is_log("missing.rawlog"));
  EXPECT_FALSE(is_log(path("b.png")));
}

}  // namespace
}  // namespace slalom
