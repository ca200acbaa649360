// SPDX-License-Identifier: BSD-3-Clause
#include "map_readers.h"

#include <slalom/core/error.h>
#include <slalom/core/read_file.h>
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
#include <optional>

namespace slalom {
namespace {

using mrpt::maps::COccupancyGridMap2D;

/// The first message of an MRPT exception text, which consists of "Message: ...", "Location: ...".
std::string first_message(const std::string& text) {
  for (std::string line : split(text, '\n')) {
    constexpr char kTitle[] = "Message:";
    if (starts_with(line, kTitle)) line = trim(line.substr(sizeof kTitle - 1));
    if (!line.empty() && !starts_with(line, "====")) return line;
  }
  return "no reason given";
}

void open_compressed(mrpt::io::CFileGZInputStream& file, const std::string& path,
                     const std::string& expected) {
  require_regular_file(path, expected, kMaxMapSize);
  if (!file.open(path)) throw file_error(path, "cannot be read", expected);
}

template <typename Read>
void read_archive(const std::string& path, const std::string& expected, Read read) {
  mrpt::io::CFileGZInputStream file;
  open_compressed(file, path, expected);
  try {
    auto archive = mrpt::serialization::archiveFrom(file);
    read(archive);
  } catch (const std::exception& e) {
    throw file_error(path, "is corrupt or of another type (" + first_message(e.what()) + ")",
                     expected);
  }
}

/// Size and extent of a grid in the header of a file.
struct GridHeader {
  std::uint32_t size_x, size_y;
  float x_min, x_max, y_min, y_max, resolution;  // m
};

/// The header and the position of the cells.
struct GridFile {
  GridHeader header;
  std::size_t cells_at;     ///< offset, bytes
  bool cells_are_readable;  ///< one byte each, of a supported version
};

/// Reads the header of a grid file: the length of the class name, the name, version and bits of a
/// cell (one byte each), then a GridHeader, followed by the cells. It is checked before MRPT reads
/// the file, because MRPT allocates memory for any declared number of cells (in 32 bits) and for
/// extent / resolution. nullopt for other types of files, which MRPT rejects.
std::optional<GridFile> read_grid_header(const std::string& path, const std::string& expected) {
  mrpt::io::CFileGZInputStream file;
  open_compressed(file, path, expected);
  std::array<char, 256> bytes{};
  const std::size_t got = file.Read(bytes.data(), bytes.size());
  const std::size_t name_size = static_cast<unsigned char>(bytes[0]) & 0x7fU, at = name_size + 3;
  if (got > bytes.size() || got < at + sizeof(GridHeader)) return std::nullopt;
  const std::string name(&bytes[1], name_size);
  if (name != "COccupancyGridMap2D" && name != "mrpt::maps::COccupancyGridMap2D")
    return std::nullopt;
  GridFile result;
  std::memcpy(&result.header, &bytes[at],
              sizeof result.header);  // little-endian, as are the supported machines
  constexpr char kMinVersion = 3, kBits = 8;
  result.cells_at = at + sizeof result.header;
  result.cells_are_readable = bytes[at - 2] >= kMinVersion && bytes[at - 1] == kBits;
  return result;
}

/// Reads up to `count` bytes of a compressed file, block by block to bound memory by the content.
std::string read_up_to(mrpt::io::CFileGZInputStream& file, std::size_t count) {
  constexpr std::size_t kBlockSize = std::size_t{1} << 20;
  std::string all;
  while (all.size() < count) {
    const std::size_t offset = all.size(), wanted = std::min(kBlockSize, count - offset);
    all.resize(offset + wanted);
    const std::size_t got = file.Read(&all[offset], wanted);
    if (got == 0 || got > wanted) {
      all.resize(offset);
      break;
    }
    all.resize(offset + got);
  }
  return all;
}

/// Checks that options follow the cells and that the rest of the compressed file can be read.
void check_trailer(mrpt::io::CFileGZInputStream& file, const std::string& path,
                   const std::string& expected) {
  std::array<char, 1U << 16> options{};
  const std::size_t first = file.Read(options.data(), options.size());
  if (first == 0) throw file_error(path, "is truncated after its cells", expected);
  if (first > options.size() || file.Read(options.data(), options.size()) > options.size())
    throw file_error(path, "is corrupt", expected);
}

/// Reads the grid exactly as stored. MRPT would move its corner to a multiple of the resolution,
/// reject it if its size changed thereby, and allocate memory as declared by the options after the
/// cells.
COccupancyGridMap2D read_cells(const std::string& path, const std::string& expected,
                               const GridFile& grid) {
  mrpt::io::CFileGZInputStream file;
  open_compressed(file, path, expected);
  read_up_to(file, grid.cells_at);
  const GridHeader& header = grid.header;
  const std::size_t count = std::size_t{header.size_x} * header.size_y;
  const std::string cells = read_up_to(file, count);
  if (cells.size() < count)
    throw file_error(path,
                     "is truncated after " + std::to_string(cells.size()) + " of " +
                         std::to_string(count) + " cells",
                     expected);
  check_trailer(file, path, expected);
  auto map = make_grid_map(static_cast<int>(header.size_x), static_cast<int>(header.size_y),
                           header.resolution, {header.x_min, header.y_min});
  for (std::size_t y = 0; y < header.size_y; ++y)
    std::memcpy(map.getRow(static_cast<int>(y)), &cells[y * header.size_x], header.size_x);
  return map;
}

bool matches_extent(float low, float high, float resolution, std::uint32_t size) {
  const double cells = (static_cast<double>(high) - low) / resolution;
  return std::abs(cells - size) <= 1 + 1e-4 * size;
}

void check_header(const GridHeader& header, const std::string& path) {
  const std::uint64_t size_x = header.size_x, size_y = header.size_y;
  if (size_x == 0 || size_y == 0 || size_x > kMaxCells / size_y)
    throw file_error(
        path, "declares " + std::to_string(size_x) + " x " + std::to_string(size_y) + " cells",
        "1 to " + std::to_string(kMaxCells) + " cells");
  const bool possible =
      header.resolution > 0 && std::isfinite(header.resolution) &&
      matches_extent(header.x_min, header.x_max, header.resolution, header.size_x) &&
      matches_extent(header.y_min, header.y_max, header.resolution, header.size_y);
  if (!possible)
    throw file_error(path,
                     "has cells of " + std::to_string(header.resolution) + " m, " +
                         std::to_string(size_x) + " x " + std::to_string(size_y) +
                         ", which do not match its extent",
                     "a consistent grid");
}

/// Checks the extent of the poses: MRPT grows a grid to contain all poses, and crashes if it is
/// too large.
void check_pose_extent(const mrpt::maps::CSimpleMap& map, double resolution,
                       const std::string& path) {
  double x_min = 0, x_max = 0, y_min = 0, y_max = 0;
  bool finite = true;
  for (const auto& keyframe : map) {
    const mrpt::poses::CPose3D at = keyframe.pose->getMeanVal();
    finite = finite && std::isfinite(at.x()) && std::isfinite(at.y());
    x_min = std::min(x_min, at.x());
    x_max = std::max(x_max, at.x());
    y_min = std::min(y_min, at.y());
    y_max = std::max(y_max, at.y());
  }
  constexpr double kScanRange = 100;  // m, on each side
  const double cells = (x_max - x_min + 2 * kScanRange) / resolution *
                       ((y_max - y_min + 2 * kScanRange) / resolution);
  if (!finite || !(cells <= static_cast<double>(kMaxCells)))
    throw file_error(path,
                     "has poses too far apart for cells of " + format_number(resolution) + " m",
                     "at most " + std::to_string(kMaxCells) + " cells");
}

void check_not_empty(const COccupancyGridMap2D& map, const std::string& path) {
  if (map.getSizeX() == 0 || map.getSizeY() == 0 || !(map.getResolution() > 0))
    throw file_error(path, "contains an empty map", "a map with cells");
}

}  // namespace

COccupancyGridMap2D read_gridmap(const std::string& path) {
  const std::string expected = "an MRPT occupancy grid (.gridmap, .gridmap.gz)";
  if (const auto grid = read_grid_header(path, expected)) {
    check_header(grid->header, path);
    if (grid->cells_are_readable) return read_cells(path, expected, *grid);
    throw file_error(path, "unsupported version", expected);
  }
  COccupancyGridMap2D map = one_cell_map();
  read_archive(path, expected, [&map](auto& archive) { archive >> map; });
  check_not_empty(map, path);
  return map;
}

COccupancyGridMap2D read_simplemap(const std::string& path, double resolution) {
  if (!(resolution > 0) || !std::isfinite(resolution))
    throw usage_error(path, "invalid resolution " + format_number(resolution) + " m",
                      "a resolution > 0");
  const std::string expected = "an MRPT simplemap (.simplemap, .simplemap.gz)";
  mrpt::maps::CSimpleMap poses_and_scans;
  read_archive(path, expected, [&](auto& archive) { archive >> poses_and_scans; });
  if (poses_and_scans.empty()) throw file_error(path, "contains no observations", "laser scans");
  check_pose_extent(poses_and_scans, resolution, path);
  COccupancyGridMap2D map(-1, 1, -1, 1, static_cast<float>(resolution));
  map.insertionOptions.maxOccupancyUpdateCertainty = 0.8F;
  map.loadFromSimpleMap(poses_and_scans);
  check_not_empty(map, path);
  return map;
}

}  // namespace slalom
