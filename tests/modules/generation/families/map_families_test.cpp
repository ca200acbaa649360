// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "family_samples.h"

#include <slalom/generation/map_window.h>
#include <slalom/scenario/world.h>

#include <cmath>

namespace slalom {
namespace {

Occupancy hall_cells() {
  return make_occupancy(Scenario::grid("hall", hall_map(""), {}, {}), 0.1);
}

TEST(Crop, CutsAWindowInMapCoordinates) {
  const auto crop = family("crop", "width = 8\nheight = 6\n");
  const Occupancy hall = hall_cells();
  RandomEngine engine(2);
  bool moved = false;
  for (int i = 0; i < 10; ++i) {
    const Occupancy window = make_occupancy(crop->generate("x", engine), 1);
    ASSERT_EQ(window.size_x(), 80);
    ASSERT_EQ(window.size_y(), 60);
    const auto corner = hall.to_cells(window.origin());
    const int x0 = int(std::lround(corner.x)), y0 = int(std::lround(corner.y));
    moved = moved || x0 != 0;
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 80; ++x)
        ASSERT_EQ(window.occupied(x, y), hall.occupied(x0 + x, y0 + y)) << x << ' ' << y;
  }
  EXPECT_TRUE(moved);
}

TEST(Crop, WindowsHaveTheRequiredFractionsOfCells) {
  MapWindowOptions options;
  options.width = options.height = 4;
  options.min_free = 0.5;
  options.min_occupied = 0.02;
  const MapWindows windows(hall_cells(), options);
  RandomEngine engine(2);
  for (int i = 0; i < 50; ++i) {
    const Occupancy window = windows.draw(engine);
    const double occupied = double(window.count_occupied()) / double(window.cells().size());
    EXPECT_GE(occupied, 0.02);
    EXPECT_LE(occupied, 0.5);
  }
}

TEST(Clutter, AddsObstaclesClearOfStartAndGoal) {
  const auto clutter = family("clutter", "width = 0\nheight = 0\nclear_radius = 0.7\n");
  const Occupancy hall = hall_cells();
  RandomEngine engine(2);
  for (int i = 0; i < 10; ++i) {
    const World world(clutter->generate("x", engine), 1);
    const Occupancy& cells = world.occupancy();
    ASSERT_EQ(cells.cells().size(), hall.cells().size());
    for (std::size_t k = 0; k < hall.cells().size(); ++k)
      ASSERT_GE(cells.cells()[k], hall.cells()[k]);
    EXPECT_GT(cells.count_occupied(), hall.count_occupied());
    const auto& start = world.scenario().start();
    EXPECT_GE(world.distance_field().clearance({start.x, start.y}), 0.7);
    EXPECT_GE(world.distance_field().clearance(world.scenario().goal()), 0.7);
  }
}

TEST(MapFamilies, RejectsInvalidOptions) {
  for (const std::string name : {"crop", "clutter"}) {
    EXPECT_NE(
        refusal(name, "min_free = 0.9\nmin_occupied = 0.2\n").find("min_occupied: contradicts"),
        std::string::npos);
    const auto rejects = [&](const std::string& ini, const GeneratorContext& context,
                             const std::string& where, std::initializer_list<std::string> words) {
      return throws_error(ErrorKind::Usage, where, words,
                          [&] { make_generator(name, IniFile::from_text(ini, "g.ini"), context); });
    };
    EXPECT_TRUE(
        rejects("", with_hall(), "g.ini: [generator." + name + "] map:", {"expected a map file"}));
    EXPECT_TRUE(rejects("[generator." + name + "]\nmap = hall\n", {},
                        "g.ini:2: [generator." + name + "] map:", {"cannot be loaded"}));
  }
}

}  // namespace
}  // namespace slalom
