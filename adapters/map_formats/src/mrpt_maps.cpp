#include "map_readers.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/scenario/grid_map.h>

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDF.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <optional>

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

/// What the head of a file says about a grid's cells.
struct GridHead {
  std::uint32_t size_x, size_y;
  float x_min, x_max, y_min, y_max, resolution;  // m
};

/// The head and where the cells begin.
struct GridFile {
  GridHead head;
  std::size_t cells_at;     ///< bytes
  bool cells_are_readable;  ///< one byte each, in a version whose order is known
};

/// MRPT takes memory for whatever number of cells a file announces (counted in 32 bits), and again
/// for those that extent and resolution make, so the head of the file is looked at first: the
/// length of the class name and the name, version and bits of a cell (one byte each), then a
/// GridHead, after which come the cells. nullopt for other kinds of files, which are left to MRPT
/// to refuse.
std::optional<GridFile> read_grid_head(const std::string& path, const std::string& expected) {
  mrpt::io::CFileGZInputStream file;
  open_packed(file, path, expected);
  std::array<char, 256> bytes{};
  const std::size_t got = file.Read(bytes.data(), bytes.size());
  const std::size_t name_size = static_cast<unsigned char>(bytes[0]) & 0x7fU, at = name_size + 3;
  if (got > bytes.size() || got < at + sizeof(GridHead)) return std::nullopt;
  const std::string name(&bytes[1], name_size);
  if (name != "COccupancyGridMap2D" && name != "mrpt::maps::COccupancyGridMap2D")
    return std::nullopt;
  GridFile result;
  std::memcpy(&result.head, &bytes[at],
              sizeof result.head);  // MRPT writes, and these machines are, little-endian
  constexpr char kOldestKnownVersion = 3, kBits = 8;
  result.cells_at = at + sizeof result.head;
  result.cells_are_readable = bytes[at - 2] >= kOldestKnownVersion && bytes[at - 1] == kBits;
  return result;
}

/// The next bytes of a packed file, taken piece by piece: no more memory than there is content.
std::string read_some(mrpt::io::CFileGZInputStream& file, std::size_t count) {
  constexpr std::size_t kPiece = std::size_t{1} << 20;
  std::string all;
  while (all.size() < count) {
    const std::size_t before = all.size(), wanted = std::min(kPiece, count - before);
    all.resize(before + wanted);
    const std::size_t got = file.Read(&all[before], wanted);
    if (got == 0 || got > wanted) {
      all.resize(before);
      break;
    }
    all.resize(before + got);
  }
  return all;
}

/// MRPT's options come after the cells; a packed file that is damaged shows at its end.
void expect_sound_end(mrpt::io::CFileGZInputStream& file, const std::string& path,
                      const std::string& expected) {
  std::array<char, 1U << 16> options{};
  const std::size_t first = file.Read(options.data(), options.size());
  if (first == 0) throw file_error(path, "ends after its cells", expected);
  if (first > options.size() || file.Read(options.data(), options.size()) > options.size())
    throw file_error(path, "is damaged", expected);
}

/// The cells of a grid as they are in the file. MRPT would move its corner to a multiple of the
/// resolution, refuse one that has another size afterwards, and take memory for whatever the
/// options behind the cells announce.
COccupancyGridMap2D read_cells(const std::string& path, const std::string& expected,
                               const GridFile& grid) {
  mrpt::io::CFileGZInputStream file;
  open_packed(file, path, expected);
  read_some(file, grid.cells_at);
  const GridHead& head = grid.head;
  const std::size_t count = std::size_t{head.size_x} * head.size_y;
  const std::string cells = read_some(file, count);
  if (cells.size() < count)
    throw file_error(
        path,
        "ends after " + std::to_string(cells.size()) + " of " + std::to_string(count) + " cells",
        expected);
  expect_sound_end(file, path, expected);
  auto map = make_grid_map(static_cast<int>(head.size_x), static_cast<int>(head.size_y),
                           head.resolution, {head.x_min, head.y_min});
  for (std::size_t y = 0; y < head.size_y; ++y)
    std::memcpy(map.getRow(static_cast<int>(y)), &cells[y * head.size_x], head.size_x);
  return map;
}

bool fills(float low, float high, float resolution, std::uint32_t size) {
  const double cells = (static_cast<double>(high) - low) / resolution;
  return std::abs(cells - size) <= 1 + 1e-4 * size;
}

void expect_possible_head(const GridHead& head, const std::string& path) {
  const std::uint64_t size_x = head.size_x, size_y = head.size_y;
  if (size_x == 0 || size_y == 0 || size_x > kMaxCells / size_y)
    throw file_error(
        path, "announces " + std::to_string(size_x) + " x " + std::to_string(size_y) + " cells",
        "1 to " + std::to_string(kMaxCells) + " cells");
  const bool possible = head.resolution > 0 && std::isfinite(head.resolution) &&
                        fills(head.x_min, head.x_max, head.resolution, head.size_x) &&
                        fills(head.y_min, head.y_max, head.resolution, head.size_y);
  if (!possible)
    throw file_error(path,
                     "has cells of " + std::to_string(head.resolution) + " m, " +
                         std::to_string(size_x) + " x " + std::to_string(size_y) +
                         " of which do not fill its extent",
                     "a grid that fits together");
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
  if (map.getSizeX() == 0 || map.getSizeY() == 0 || !(map.getResolution() > 0))
    throw file_error(path, "holds an empty map", "a map with cells");
}

}  // namespace

COccupancyGridMap2D read_gridmap(const std::string& path) {
  const std::string expected = "an MRPT occupancy grid (.gridmap, .gridmap.gz)";
  if (const auto grid = read_grid_head(path, expected)) {
    expect_possible_head(grid->head, path);
    if (grid->cells_are_readable) return read_cells(path, expected, *grid);
    throw file_error(path, "is of a version that is not known", expected);
  }
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
