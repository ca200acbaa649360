// SPDX-License-Identifier: BSD-3-Clause
#include "map_files.h"

#include <slalom/map_formats/map_import.h>
#include <slalom/scenario/occupancy.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

/// Three cells of 1 m: free, occupied, unknown.
std::string write_three_cells(const MapFolder& folder) {
  folder.write("map.pgm", "P2 3 1 255 254 0 205");
  return folder.write("map.yaml", "image: map.pgm\nresolution: 1\norigin: [0, 0, 0]\n");
}

std::vector<bool> occupied_cells(const mrpt::maps::COccupancyGridMap2D& map) {
  const auto scenario = Scenario::grid("three", map, {0.5, 0.5, 0}, {0.5, 0.5});
  const Occupancy occupancy = make_occupancy(scenario, 1);
  return {occupancy.occupied(0, 0), occupancy.occupied(1, 0), occupancy.occupied(2, 0)};
}

TEST(LoadMap, UnknownCellsAreOccupiedByDefault) {
  const MapFolder folder;
  const std::string path = write_three_cells(folder);
  EXPECT_EQ(occupied_cells(load_occupancy_grid(path)), (std::vector<bool>{false, true, true}));
  MapImportOptions options;
  options.unknown_is_free = true;
  EXPECT_EQ(occupied_cells(load_map(path, options)), (std::vector<bool>{false, true, false}));
}

TEST(LoadMap, RejectsUnknownFormats) {
  const MapFolder folder;
  for (const std::string name : {"map.txt", "gridmap", "map.gz", "map.YAML"}) {
    const std::string path = folder.write(name, "x");
    EXPECT_TRUE(throws_error(ErrorKind::File, path + ": ",
                             {"unknown",
                              ".gridmap[.gz], .simplemap[.gz], a ROS map_server .yaml, "
                              "a MovingAI .map, an image (.pgm, .png, .jpg, .bmp), a world "
                              "(.world, .sdf, .xml) or a folder of BARN"},
                             [&] { load_occupancy_grid(path); }));
  }
}

}  // namespace
}  // namespace slalom
