// SPDX-License-Identifier: BSD-3-Clause
#include "map_files.h"
#include "npy_files.h"

#include <slalom/map_formats/barn.h>
#include <slalom/scenario/occupancy.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

using Cells = std::vector<std::int64_t>;

/// A world like those of BARN: rows 0 and 29 are walls, and one obstacle is in row 12, column 5.
Cells small_world() {
  Cells cells(900, 0);
  for (std::size_t column = 0; column < 30; ++column) cells[column] = cells[870 + column] = 1;
  cells[12 * 30 + 5] = 1;
  return cells;
}

/// BARN's map of a grid: 30 x 66 pixels, x is the row, column c in line 33 + c from below.
std::string map_of(const Cells& grid) {
  std::string pixels(std::size_t{30} * 66, '\xFF');
  for (std::size_t row = 0; row < 30; ++row)
    for (std::size_t column = 0; column < 30; ++column)
      if (grid[row * 30 + column] == 1) pixels[(65 - 33 - column) * 30 + row] = '\0';
  return "P5\n30  66  255\n" + pixels;
}

void write_world(const MapFolder& folder, int number) {
  const std::string n = std::to_string(number);
  for (const std::string inner : {"grid_files", "path_files", "map_files"})
    std::filesystem::create_directories(folder.path(inner));
  folder.write("grid_files/grid_" + n + ".npy", npy(30, 30, small_world()));
  folder.write("path_files/path_" + n + ".npy", npy(3, 2, {15, 0, 15, 0, 16, 1}));
  folder.write("map_files/map_pgm_" + n + ".pgm", map_of(small_world()));
}

testing::AssertionResult rejects(ErrorKind kind, const std::string& path, const std::string& where,
                                 std::initializer_list<std::string> words,
                                 const BarnOptions& options = {}) {
  return throws_error(kind, where, words, [&] { import_barn(path, options); });
}

TEST(Barn, PlacesCylindersAsBarn) {
  const MapFolder folder;
  write_world(folder, 7);
  const auto scenarios = import_barn(folder.path("grid_files/grid_7.npy"), {});
  ASSERT_EQ(scenarios.size(), 1U);
  const Scenario& world = scenarios[0];
  EXPECT_EQ(world.name(), "barn_7");
  EXPECT_EQ(world.bounds(), (Bounds{-4.5, 0, 0, 15}));
  // 30 behind the start, 33 on each side of it, 2 x 30 in the walls of the field, one obstacle.
  const auto& discs = world.primitives().discs;
  ASSERT_EQ(discs.size(), 30U + 2 * 33 + 60 + 1);
  double x_min = 0, x_max = -9, y_min = 9, y_max = 0;
  bool obstacle = false, back = false, side = false;
  const auto near = [](double a, double b) { return std::abs(a - b) < 1e-12; };
  for (const Disc& disc : discs) {
    const auto& [x, y] = std::pair(disc.center.x, disc.center.y);
    EXPECT_EQ(disc.radius, 0.075);
    x_min = std::min(x_min, x);
    x_max = std::max(x_max, x);
    y_min = std::min(y_min, y);
    y_max = std::max(y_max, y);
    obstacle = obstacle || (near(x, -4.425 + 0.15 * 12) && near(y, 5.175 + 0.15 * 5));
    back = back || (near(x, -2.175) && near(y, 0.075));
    side = side || (near(x, -0.075) && near(y, 5.025));
  }
  EXPECT_TRUE(obstacle && back && side);
  EXPECT_NEAR(x_min, -4.425, 1e-12);
  EXPECT_NEAR(x_max, -0.075, 1e-12);
  EXPECT_NEAR(y_min, 0.075, 1e-12);
  EXPECT_NEAR(y_max, 5.175 + 0.15 * 29, 1e-12);
}

TEST(Barn, HasTheTaskOfTheChallenge) {
  const MapFolder folder;
  write_world(folder, 7);
  const Scenario world = import_barn(folder.path("grid_files/grid_7.npy"), {})[0];
  EXPECT_EQ(world.start().x, -2.25);
  EXPECT_EQ(world.start().y, 3);
  EXPECT_NEAR(std::cos(world.start().phi), 0, 1e-15);
  EXPECT_GT(std::sin(world.start().phi), 0);
  EXPECT_EQ(world.goal().x, -2.25);
  EXPECT_EQ(world.goal().y, 13);
}

TEST(Barn, HasTheTaskOfThePublishedTrials) {
  // run_trials.py: x = -0.075 - 30 * 0.15 + 0.15 row, y = 0.075 + 5 + 0.15 column; y - 1 at the
  // start, whose x is in [-3.9, -0.5], and y + 4 * 0.075 at the goal.
  const MapFolder folder;
  write_world(folder, 7);
  BarnOptions options;
  options.task = BarnTask::Trials;
  const auto task_with = [&](const Cells& path) {
    folder.write("path_files/path_7.npy", npy(static_cast<int>(path.size() / 2), 2, path));
    return import_barn(folder.path("grid_files/grid_7.npy"), options)[0];
  };
  const Scenario middle = task_with({15, 0, 15, 0, 16, 1, 12, 29});
  EXPECT_NEAR(middle.start().x, -4.575 + 0.15 * 15, 1e-12);
  EXPECT_NEAR(middle.start().y, 4.075, 1e-12);
  EXPECT_NEAR(middle.start().phi, M_PI / 2, 1e-12);
  EXPECT_NEAR(middle.goal().x, -4.575 + 0.15 * 12, 1e-12);
  EXPECT_NEAR(middle.goal().y, 5.075 + 0.15 * 29 + 0.3, 1e-12);
  EXPECT_EQ(task_with({1, 0, 1, 29}).start().x, -3.9);
  EXPECT_EQ(task_with({28, 0, 28, 29}).start().x, -0.5);
  EXPECT_NE(middle.published_path(), nullptr);
}

TEST(Barn, RejectsTheTaskOfTheTrialsWithoutAPath) {
  const MapFolder folder;
  write_world(folder, 7);
  std::filesystem::remove_all(folder.path("path_files"));
  BarnOptions options;
  options.task = BarnTask::Trials;
  const std::string grid = folder.path("grid_files/grid_7.npy");
  EXPECT_TRUE(rejects(ErrorKind::File, grid, grid, {"has no path", "path_7.npy"}, options));
}

TEST(Barn, ImportsThePublishedPathWithItsDuplicatePoint) {
  const MapFolder folder;
  write_world(folder, 7);
  const Scenario world = import_barn(folder.path("grid_files/grid_7.npy"), {})[0];
  const PublishedPathPtr& path = world.published_path();
  ASSERT_NE(path, nullptr);
  ASSERT_EQ(path->points.size(), 3U);
  EXPECT_EQ(path->points[0].x, path->points[1].x);
  EXPECT_NEAR(path->points[0].x, -4.425 + 0.15 * 15, 1e-12);
  EXPECT_NEAR(path->points[0].y, 5.175, 1e-12);
  EXPECT_NEAR(path->points[2].x - path->points[1].x, 0.15, 1e-12);
  EXPECT_NEAR(path->points[2].y - path->points[1].y, 0.15, 1e-12);
  EXPECT_EQ(path->size_x(), 30);
  EXPECT_EQ(path->size_y(), 30);
}

TEST(Barn, ImportsTheSameObstaclesAsGrid) {
  const MapFolder folder;
  write_world(folder, 7);
  BarnOptions options;
  options.representation = Representation::Grid;
  const Scenario world = import_barn(folder.path("grid_files/grid_7.npy"), options)[0];
  const Occupancy cells = make_occupancy(world, 1);
  EXPECT_EQ(cells.size_x(), 30);
  EXPECT_EQ(cells.size_y(), 100);
  EXPECT_EQ(cells.count_occupied(), 30U + 2 * 33 + 60 + 1);
  EXPECT_TRUE(cells.occupied(12, 34 + 5));
  EXPECT_NEAR(cells.cell_center(12, 39).x, -4.425 + 0.15 * 12, 1e-5);
  EXPECT_NEAR(cells.cell_center(12, 39).y, 5.175 + 0.15 * 5, 1e-5);
  ASSERT_NE(world.published_path(), nullptr);
}

/// The world as Gazebo loads it: a model for each cylinder.
std::string gazebo_world_of(const Scenario& world, const std::string& more = "") {
  std::string sdf = "<sdf version='1.6'><world name='default'>";
  for (const Disc& disc : world.primitives().discs)
    sdf += "<model name='unit_cylinder'><static>1</static><pose frame=''>" +
           format_fixed(disc.center.x, 6) + " " + format_fixed(disc.center.y, 6) +
           " 0 0 0 0</pose><link name='link'><collision name='collision'><geometry><cylinder>"
           "<radius>0.075000</radius><length>1</length></cylinder></geometry></collision></link>"
           "</model>\n";
  return sdf + more + "</world></sdf>";
}

TEST(Barn, ImportsTheWorldsOfTheChallengeAsTheirGrids) {
  const MapFolder grids, worlds;
  for (const int number : {2, 11}) write_world(grids, number);
  std::filesystem::create_directories(worlds.path("path_files"));
  for (const std::string number : {"11", "2"}) {
    const Scenario from_grid = import_barn(grids.path("grid_files/grid_" + number + ".npy"), {})[0];
    worlds.write("world_" + number + ".world", gazebo_world_of(from_grid));
    std::filesystem::copy(grids.path("path_files/path_" + number + ".npy"),
                          worlds.path("path_files"));
  }
  EXPECT_TRUE(is_barn(worlds.path("")));
  EXPECT_TRUE(is_barn(worlds.path("world_11.world")));
  for (const BarnTask task : {BarnTask::Challenge, BarnTask::Trials})
    for (const Representation form : {Representation::Continuous, Representation::Grid}) {
      const BarnOptions options{"0-299/even", form, task};
      const auto expected = import_barn(grids.path(""), options);
      const auto imported = import_barn(worlds.path(""), options);
      ASSERT_EQ(imported.size(), 1U);
      EXPECT_EQ(imported[0].name(), "barn_2");
      EXPECT_EQ(imported[0].hash(), expected[0].hash());
      ASSERT_NE(imported[0].published_path(), nullptr);
      EXPECT_EQ(*imported[0].published_path(), *expected[0].published_path());
    }
}

/// The world of a grid without the cylinders whose eight neighbors are cylinders of the field.
Scenario as_written(const Scenario& world, const Cells& cells) {
  Primitives written;
  for (const Disc& disc : world.primitives().discs) {
    const auto row = std::lround((disc.center.x + 4.425) / 0.15),
               column = std::lround((disc.center.y - 5.175) / 0.15);
    bool is_inner = row > 0 && row < 29 && column > 0 && column < 29;
    for (long side = 0; side < 9 && is_inner; ++side)
      is_inner =
          cells[static_cast<std::size_t>((row + side / 3 - 1) * 30 + column + side % 3 - 1)] == 1;
    if (!is_inner) written.discs.push_back(disc);
  }
  return Scenario::continuous("written", world.bounds(), written, world.start(), world.goal());
}

TEST(Barn, RestoresTheCylindersThatTheWorldsOfTheChallengeLack) {
  // Two blocks that share a wall, one of which has a free pocket: cells of the wall beside it are
  // written, so it is known to be free.
  const MapFolder folder;
  Cells cells = small_world();
  for (std::size_t row = 10; row < 15; ++row)
    for (std::size_t column = 7; column < 16; ++column) cells[row * 30 + column] = 1;
  cells[12 * 30 + 13] = cells[12 * 30 + 12] = 0;
  folder.write("grid_7.npy", npy(30, 30, cells));
  const Scenario whole = import_barn(folder.path("grid_7.npy"), {})[0];
  const Scenario written = as_written(whole, cells);
  // Rows 11 to 13, columns 8 to 10: the cells that touch neither the border nor the pocket.
  ASSERT_EQ(written.primitives().discs.size() + 9, whole.primitives().discs.size());
  const std::string world = folder.write("world_7.world", gazebo_world_of(written));
  EXPECT_EQ(import_barn(world, {})[0].hash(), whole.hash());
}

TEST(Barn, RefusesWorldsThatAreNotOnItsGrid) {
  const MapFolder folder;
  write_world(folder, 7);
  const Scenario world = import_barn(folder.path("grid_files/grid_7.npy"), {})[0];
  const auto refuses = [&](const std::string& sdf, const std::string& reason) {
    const std::string path = folder.write("world_3.world", sdf);
    EXPECT_FALSE(is_barn(path));
    return rejects(ErrorKind::File, path, path, {"not a world of BARN", reason});
  };
  const std::string box =
      "<model name='box'><link name='l'><collision name='c'><geometry><box><size>1 1 1</size></box>"
      "</geometry></collision></link></model>";
  EXPECT_TRUE(refuses(gazebo_world_of(world, box), "other obstacles"));
  Primitives obstacles = world.primitives();
  obstacles.discs.back().center.x += 0.05;
  const auto changed = [&] {
    return Scenario::continuous("changed", world.bounds(), obstacles, world.start(), world.goal());
  };
  EXPECT_TRUE(refuses(gazebo_world_of(changed()), "a cylinder of radius 0.075 m is at"));
  obstacles.discs.back() = {{-2.175, 3}, 0.075};
  EXPECT_TRUE(refuses(gazebo_world_of(changed()), "a cylinder of radius 0.075 m is at"));
  obstacles.discs.erase(obstacles.discs.begin());
  obstacles.discs.pop_back();
  EXPECT_TRUE(refuses(gazebo_world_of(changed()), "not complete"));
}

TEST(Barn, ImportsSelectedWorldsOfAFolderInOrder) {
  const MapFolder folder;
  for (const int number : {0, 2, 10, 3, 11}) write_world(folder, number);
  EXPECT_TRUE(is_barn(folder.path("")));
  const auto names = [&](const std::string& path, const std::string& worlds) {
    BarnOptions options;
    options.worlds = worlds;
    std::string all;
    for (const Scenario& world : import_barn(path, options)) all += world.name() + " ";
    return all;
  };
  const std::string all_worlds = folder.path("");
  EXPECT_EQ(names(all_worlds, ""), "barn_0 barn_2 barn_3 barn_10 barn_11 ");
  EXPECT_EQ(names(folder.path("grid_files"), ""), "barn_0 barn_2 barn_3 barn_10 barn_11 ");
  EXPECT_EQ(names(all_worlds, "0-299/even"), "barn_0 barn_2 barn_10 ");
  EXPECT_EQ(names(all_worlds, "0-299/odd"), "barn_3 barn_11 ");
  EXPECT_EQ(names(all_worlds, "1-11/5"), "barn_11 ");
  EXPECT_EQ(names(all_worlds, "3, 0"), "barn_0 barn_3 ");
  EXPECT_EQ(names(all_worlds, "2-10"), "barn_2 barn_3 barn_10 ");
}

TEST(Barn, RejectsInvalidOrEmptySelections) {
  const MapFolder folder;
  write_world(folder, 4);
  for (const std::string worlds : {"x", "1-", "-3", "1-2/third", "1e9", "99999999999999999999"}) {
    BarnOptions options;
    options.worlds = worlds;
    EXPECT_TRUE(rejects(ErrorKind::Usage, folder.path(""), "--worlds " + worlds.substr(0, 2),
                        {"invalid selection"}, options))
        << worlds;
  }
  BarnOptions options;
  options.worlds = "5-9";
  EXPECT_TRUE(rejects(ErrorKind::Usage, folder.path(""), "--worlds 5-9",
                      {folder.path(""), "worlds from 4 to 4"}, options));
}

TEST(Barn, RecognizesGrids) {
  const MapFolder folder;
  EXPECT_FALSE(is_barn(folder.path("")));
  EXPECT_TRUE(is_barn("grid_0.npy"));
  for (const std::string name : {"grid_.npy", "grid_a.npy", "path_1.npy", "grid_1.npz",
                                 "agrid_1.npy", "grid_99999999999999999999.npy"})
    EXPECT_FALSE(is_barn(name)) << name;
  EXPECT_TRUE(
      rejects(ErrorKind::File, folder.path(""), folder.path(""), {"no BARN worlds", "grid_files"}));
}

TEST(Barn, RejectsInvalidGrids) {
  const MapFolder folder;
  const std::string small = folder.write("grid_1.npy", npy(2, 2, {0, 1, 1, 0}));
  EXPECT_TRUE(rejects(ErrorKind::File, small, small, {"2 x 2 cells", "30 x 30 cells"}));
  Cells cells = small_world();
  cells[31] = 2;
  const std::string two = folder.write("grid_2.npy", npy(30, 30, cells));
  EXPECT_TRUE(rejects(ErrorKind::File, two, two, {"2 in row 1, column 1", "expected 0", "1 ("}));
}

TEST(Barn, RejectsInvalidPaths) {
  const MapFolder folder;
  const std::string grid = folder.write("grid_1.npy", npy(30, 30, small_world()));
  const std::string path = folder.write("path_1.npy", npy(2, 2, {1, 0, 30, 1}));
  EXPECT_TRUE(
      rejects(ErrorKind::File, grid, path, {"point 1", "row 30, column 1", "from 0 to 29"}));
  folder.write("path_1.npy", npy(1, 3, {1, 0, 3}));
  EXPECT_TRUE(rejects(ErrorKind::File, grid, path, {"3 numbers per point"}));
}

TEST(Barn, RejectsAMapThatDiffersFromTheGrid) {
  const MapFolder folder;
  const std::string grid = folder.write("grid_1.npy", npy(30, 30, small_world()));
  Cells other = small_world();
  other[12 * 30 + 6] = 1;
  const std::string map = folder.write("map_pgm_1.pgm", map_of(other));
  EXPECT_TRUE(rejects(ErrorKind::File, grid, map, {"differs", "row 12, column 6"}));
  folder.write("map_pgm_1.pgm", "P2 1 1 255 0");
  EXPECT_TRUE(rejects(ErrorKind::File, grid, map, {"1 x 1 pixels", "30 x 66"}));
}

}  // namespace
}  // namespace slalom
