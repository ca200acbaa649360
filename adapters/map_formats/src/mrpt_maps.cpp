#include "map_readers.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDF.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace slalom {
namespace {

using mrpt::maps::COccupancyGridMap2D;

/// MRPT's exceptions are pages of "Message: ...", "Location: ...": the first thing that they say.
std::string first_words(const std::string& text) {
  for (std::string line : split(text, '\n')) {
    constexpr char kTitle[] = "Message:";
    if (line.rfind(kTitle, 0) == 0) line = trim(line.substr(sizeof kTitle - 1));
    if (!line.empty() && line.rfind("====", 0) != 0) return line;
  }
  return "no reason given";
}

void open_packed(mrpt::io::CFileGZInputStream& file, const std::string& path,
                 const std::string& expected) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored) || !file.open(path))
    throw file_error(path, "cannot be read", expected);
}

template <typename Read>
void read_archive(const std::string& path, const std::string& expected, Read read) {
  mrpt::io::CFileGZInputStream file;
  open_packed(file, path, expected);
  try {
    auto archive = mrpt::serialization::archiveFrom(file);
    read(archive);
  } catch (const std::exception& e) {
    throw file_error(path, "is damaged or of another kind (" + first_words(e.what()) + ")",
                     expected);
  }
}

/// MRPT takes memory for whatever number of cells a file announces (counted in 32 bits), so the
/// head of the file is looked at first: the length of the class name and the name, version and bits
/// of a cell (one byte each), size x and size y. Other kinds of files are left to MRPT to refuse.
void expect_possible_sizes(const std::string& path, const std::string& expected) {
  mrpt::io::CFileGZInputStream file;
  open_packed(file, path, expected);
  std::array<unsigned char, 256> head{};
  const std::size_t got = file.Read(head.data(), head.size());
  const std::size_t name_size = head[0] & 0x7fU, sizes_at = name_size + 3;
  if (got > head.size() || got < sizes_at + 8) return;
  const std::string name(head.begin() + 1, head.begin() + 1 + static_cast<int>(name_size));
  if (name != "COccupancyGridMap2D" && name != "mrpt::maps::COccupancyGridMap2D") return;
  const auto number_at = [&head](std::size_t at) {
    return head[at] | head[at + 1] << 8U | head[at + 2] << 16U |
           static_cast<std::uint64_t>(head[at + 3]) << 24U;
  };
  const std::uint64_t size_x = number_at(sizes_at), size_y = number_at(sizes_at + 4);
  if (size_x == 0 || size_y == 0 || size_x > kMaxCells / size_y)
    throw file_error(
        path, "announces " + std::to_string(size_x) + " x " + std::to_string(size_y) + " cells",
        "1 to " + std::to_string(kMaxCells) + " cells");
}

/// MRPT lets a grid grow to wherever a pose is, and does not survive one that is too large.
void expect_possible_poses(const mrpt::maps::CSimpleMap& map, double resolution,
                           const std::string& path) {
  double x_min = 0, x_max = 0, y_min = 0, y_max = 0;
  bool finite = true;
  for (std::size_t i = 0; i < map.size(); ++i) {
    mrpt::poses::CPose3DPDF::ConstPtr pose;
    mrpt::obs::CSensoryFrame::ConstPtr frame;
    map.get(i, pose, frame);
    const mrpt::poses::CPose3D at = pose->getMeanVal();
    finite = finite && std::isfinite(at.x()) && std::isfinite(at.y());
    x_min = std::min(x_min, at.x());
    x_max = std::max(x_max, at.x());
    y_min = std::min(y_min, at.y());
    y_max = std::max(y_max, at.y());
  }
  constexpr double kSight = 100;  // m, on each side
  const double cells =
      (x_max - x_min + 2 * kSight) / resolution * ((y_max - y_min + 2 * kSight) / resolution);
  if (!finite || !(cells <= static_cast<double>(kMaxCells)))
    throw file_error(path,
                     "has poses too far apart for cells of " + format_number(resolution) + " m",
                     "at most " + std::to_string(kMaxCells) + " cells");
}

void expect_cells(const COccupancyGridMap2D& map, const std::string& path) {
  if (map.getSizeX() == 0 || map.getSizeY() == 0 || !(map.getResolution() > 0) ||
      !std::isfinite(map.getResolution()))
    throw file_error(path, "holds an empty map", "a map with cells");
}

}  // namespace

COccupancyGridMap2D read_gridmap(const std::string& path) {
  const std::string expected = "an MRPT occupancy grid (.gridmap, .gridmap.gz)";
  expect_possible_sizes(path, expected);
  COccupancyGridMap2D map;
  read_archive(path, expected, [&map](auto& archive) { archive >> map; });
  expect_cells(map, path);
  return map;
}

COccupancyGridMap2D read_simplemap(const std::string& path, double resolution) {
  if (!(resolution > 0) || !std::isfinite(resolution))
    throw usage_error(path, "cells of " + format_number(resolution) + " m", "a resolution > 0");
  const std::string expected = "an MRPT simplemap (.simplemap, .simplemap.gz)";
  mrpt::maps::CSimpleMap poses_and_scans;
  read_archive(path, expected, [&](auto& archive) { archive >> poses_and_scans; });
  if (poses_and_scans.empty()) throw file_error(path, "holds no observations", "laser scans");
  expect_possible_poses(poses_and_scans, resolution, path);
  COccupancyGridMap2D map(-1, 1, -1, 1, static_cast<float>(resolution));
  map.insertionOptions.maxOccupancyUpdateCertainty = 0.8F;
  map.loadFromSimpleMap(poses_and_scans);
  expect_cells(map, path);
  return map;
}

}  // namespace slalom
