#include "map_readers.h"

#include <slalom/core/error.h>

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>

namespace slalom {
namespace {

using mrpt::maps::COccupancyGridMap2D;

/// MRPT's exceptions tell a call stack; the first line says what happened.
std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

template <typename Read>
void read_archive(const std::string& path, const std::string& expected, Read read) {
  mrpt::io::CFileGZInputStream file;
  if (!file.open(path)) throw file_error(path, "cannot be read", expected);
  try {
    auto archive = mrpt::serialization::archiveFrom(file);
    read(archive);
  } catch (const std::exception& e) {
    throw file_error(path, "is damaged or of another kind (" + first_line(e.what()) + ")",
                     expected);
  }
}

void expect_cells(const COccupancyGridMap2D& map, const std::string& path) {
  if (map.getSizeX() == 0 || map.getSizeY() == 0 || !(map.getResolution() > 0))
    throw file_error(path, "holds an empty map", "a map with cells");
}

}  // namespace

COccupancyGridMap2D read_gridmap(const std::string& path) {
  COccupancyGridMap2D map;
  read_archive(path, "an MRPT occupancy grid (.gridmap, .gridmap.gz)",
               [&map](auto& archive) { archive >> map; });
  expect_cells(map, path);
  return map;
}

COccupancyGridMap2D read_simplemap(const std::string& path, double resolution) {
  mrpt::maps::CSimpleMap poses_and_scans;
  read_archive(path, "an MRPT simplemap (.simplemap, .simplemap.gz)",
               [&](auto& archive) { archive >> poses_and_scans; });
  if (poses_and_scans.empty()) throw file_error(path, "holds no observations", "laser scans");
  COccupancyGridMap2D map(-1, 1, -1, 1, static_cast<float>(resolution));
  map.insertionOptions.maxOccupancyUpdateCertainty = 0.8F;
  map.loadFromSimpleMap(poses_and_scans);
  expect_cells(map, path);
  return map;
}

}  // namespace slalom
