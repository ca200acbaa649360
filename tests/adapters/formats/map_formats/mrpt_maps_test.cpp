// SPDX-License-Identifier: BSD-3-Clause
#include "map_files.h"
#include "map_readers.h"

#include <slalom/scenario/grid_map.h>

#include <gtest/gtest.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/io/CFileOutputStream.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <cstring>

namespace slalom {
namespace {

using mrpt::maps::COccupancyGridMap2D;

// Maps of real environments, from Debian's package mrpt-common.
const std::string kData = "/usr/share/mrpt/datasets/";
const std::string kCampus = kData + "2006-MalagaCampus.gridmap.gz";
const std::string kRadioMap = kData + "uwb_ro-localization_demo_map.gridmap.gz";
const std::string kLaboratory = kData + "localization_demo.simplemap.gz";
const std::string kBuilding = kData + "malaga-cs-fac-building.simplemap.gz";

// MRPT's file format of grids: length of the class name (1 byte, with the highest bit set), the
// name, version and bits of a cell (1 byte each), sizes (2 x 4), x_min, x_max, y_min, y_max (4 x
// 4), resolution (4), then one byte per cell.
std::size_t sizes_at(const std::string& bytes) {
  return (static_cast<unsigned char>(bytes[0]) & 0x7fU) + 3;
}
std::size_t cells_at(const std::string& bytes) {
  return sizes_at(bytes) + 28;
}

testing::AssertionResult rejects_file(const std::string& path,
                                      std::initializer_list<std::string> words) {
  return throws_error(ErrorKind::File, path + ": ", words, [&] { load_occupancy_grid(path); });
}

template <typename Number>
Number number_at(const std::string& bytes, std::size_t at) {
  Number number;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

void expect_as_in_file(const std::string& path) {
  const COccupancyGridMap2D map = load_occupancy_grid(path);
  const std::string bytes = decompressed(path);
  const auto size_x = number_at<std::uint32_t>(bytes, sizes_at(bytes));
  ASSERT_EQ(map.getSizeX(), size_x);
  ASSERT_EQ(map.getSizeY(), number_at<std::uint32_t>(bytes, sizes_at(bytes) + 4));
  EXPECT_EQ(map.getXMin(), number_at<float>(bytes, sizes_at(bytes) + 8));
  EXPECT_FLOAT_EQ(map.getXMax(), number_at<float>(bytes, sizes_at(bytes) + 12));
  EXPECT_EQ(map.getYMin(), number_at<float>(bytes, sizes_at(bytes) + 16));
  EXPECT_FLOAT_EQ(map.getYMax(), number_at<float>(bytes, sizes_at(bytes) + 20));
  EXPECT_EQ(map.getResolution(), number_at<float>(bytes, sizes_at(bytes) + 24));
  for (std::size_t y = 0; y < map.getSizeY(); ++y)
    ASSERT_EQ(
        std::memcmp(map.getRow(static_cast<int>(y)), &bytes[cells_at(bytes) + y * size_x], size_x),
        0)
        << "row " << y;
}

template <typename Object>
std::string archived(const MapFolder& folder, const Object& object, const std::string& name) {
  mrpt::io::CFileGZOutputStream file(folder.path(name));
  auto archive = mrpt::serialization::archiveFrom(file);
  archive << object;
  return folder.path(name);
}

/// A grid file without compression, so that tests can change single bytes.
std::string plain_grid(const MapFolder& folder) {
  mrpt::io::CFileOutputStream file(folder.path("plain.gridmap"));
  auto archive = mrpt::serialization::archiveFrom(file);
  archive << make_grid_map(7, 5, 0.5, {-1, 2});
  return folder.path("plain.gridmap");
}

std::string with_sizes(const std::string& bytes, std::uint32_t size_x, std::uint32_t size_y) {
  std::string changed = bytes;
  std::memcpy(&changed[sizes_at(changed)], &size_x, 4);
  std::memcpy(&changed[sizes_at(changed) + 4], &size_y, 4);
  return changed;
}

TEST(ReadGridmap, ReadsMapsOfRealEnvironmentsExactly) {
  expect_as_in_file(kCampus);
  expect_as_in_file(kRadioMap);
}

TEST(ReadGridmap, ReadsGridsWrittenByMrpt) {
  const MapFolder folder;
  COccupancyGridMap2D map = make_grid_map(7, 5, 0.5, {-1, 2});
  map.setCell(6, 1, 0.0F);
  for (const std::string name : {"map.gridmap", "map.gridmap.gz"}) {
    const COccupancyGridMap2D copy = load_occupancy_grid(archived(folder, map, name));
    EXPECT_EQ(copy.getRawMap(), map.getRawMap());
    EXPECT_EQ(copy.getXMin(), -1);
    // The center of cell (6, 1): (-1 + 6.5 * 0.5, 2 + 1.5 * 0.5).
    EXPECT_LT(copy.getPos(2.25F, 2.75F), 0.1F);
    EXPECT_GT(copy.getPos(2.25F, 2.25F), 0.9F);
  }
}

TEST(ReadGridmap, RejectsAMissingFile) {
  EXPECT_TRUE(rejects_file("/nowhere/a.gridmap",
                           {"cannot be read", "MRPT occupancy grid (.gridmap, .gridmap.gz)"}));
}

TEST(ReadGridmap, RejectsAnotherTypeOfObject) {
  const MapFolder folder;
  const std::string path = archived(folder, mrpt::maps::CSimplePointsMap(), "points.gridmap.gz");
  EXPECT_TRUE(rejects_file(path, {"corrupt or of another type ("}));
}

TEST(ReadGridmap, RejectsTextAndEmptyFiles) {
  const MapFolder folder;
  for (const std::string bytes : {"", "This is not a map.\n"}) {
    const std::string path = folder.write("text.gridmap.gz", bytes);
    EXPECT_TRUE(rejects_file(path, {"corrupt or of another type ("}));
    EXPECT_FALSE(rejects_file(path, {"===="}));
  }
}

TEST(ReadGridmap, RejectsTruncatedFiles) {
  const MapFolder folder;
  const std::string plain = bytes_of_file(plain_grid(folder));
  for (std::size_t size = 0; size < cells_at(plain) + 35; ++size) {
    const std::string path = folder.write("cut.gridmap", plain.substr(0, size));
    EXPECT_TRUE(rejects_file(path, {})) << size;
  }
  const std::string packed = bytes_of_file(kRadioMap);
  for (const std::size_t size : {10U, 100U, 10000U, 30000U}) {
    const std::string path = folder.write("cut.gridmap.gz", packed.substr(0, size));
    EXPECT_TRUE(rejects_file(path, {})) << size;
  }
}

/// A grid whose corner is not a multiple of its resolution, as other programs may write it.
std::string unaligned_grid(const MapFolder& folder) {
  auto map = make_grid_map(7, 5, 0.3, {0.1, -0.95});
  map.setCell(2, 3, 0.0F);
  return archived(folder, map, "unaligned.gridmap.gz");
}

TEST(ReadGridmap, KeepsACornerThatMrptWouldMove) {
  const MapFolder folder;
  const auto map = load_occupancy_grid(unaligned_grid(folder));
  EXPECT_EQ(map.getSizeX(), 7U);
  EXPECT_EQ(map.getSizeY(), 5U);
  EXPECT_EQ(map.getXMin(), 0.1F);
  EXPECT_EQ(map.getYMin(), -0.95F);
  EXPECT_LT(map.getCell(2, 3), 0.1F);
  EXPECT_GT(map.getCell(3, 2), 0.9F);
}

TEST(ReadGridmap, RejectsATruncatedGridWithAnUnalignedCorner) {
  const MapFolder folder;
  const std::string plain = decompressed(unaligned_grid(folder));
  const auto cut = [&](std::size_t size) {
    return folder.write("cut.gridmap", plain.substr(0, size));
  };
  EXPECT_TRUE(
      rejects_file(cut(cells_at(plain) + 34), {"truncated after 34 of 35 cells", "an MRPT"}));
  EXPECT_TRUE(rejects_file(cut(cells_at(plain) + 35), {"truncated after its cells", "an MRPT"}));
}

TEST(ReadGridmap, RejectsACorruptGzStream) {
  const MapFolder folder;
  std::string packed = bytes_of_file(kRadioMap);
  for (std::size_t i = 5000; i < 5100; ++i) packed[i] = static_cast<char>(~packed[i]);
  const std::string path = folder.write("corrupt.gridmap.gz", packed);
  EXPECT_TRUE(rejects_file(path, {"is corrupt;"}));
}

TEST(ReadGridmap, RejectsHugeAndEmptySizesBeforeAllocatingMemory) {
  const MapFolder folder;
  const std::string plain = bytes_of_file(plain_grid(folder));
  ASSERT_EQ(number_at<std::uint32_t>(plain, sizes_at(plain)), 7U);
  // 65536 * 65536 is 0 in 32 bits.
  for (const auto& [x, y] : {std::pair{65536U, 65536U}, {4000000000U, 1U}, {0U, 5U}, {7U, 0U}}) {
    const std::string path = folder.write("huge.gridmap", with_sizes(plain, x, y));
    EXPECT_TRUE(rejects_file(path, {" " + std::to_string(x) + " x " + std::to_string(y) + " cells",
                                    "1 to 400000000 cells"}));
  }
}

TEST(ReadGridmap, RejectsAnExtentThatDoesNotMatchTheCells) {
  const MapFolder folder;
  const std::string plain = bytes_of_file(plain_grid(folder));
  const std::size_t x_max_at = sizes_at(plain) + 12, resolution_at = sizes_at(plain) + 24;
  const auto changed_grid = [&](std::size_t at, float number) {
    std::string changed = plain;
    std::memcpy(&changed[at], &number, 4);
    return folder.write("changed.gridmap", changed);
  };
  ASSERT_NO_THROW(load_occupancy_grid(changed_grid(resolution_at, 0.5F)));
  for (const float resolution : {0.0F, -0.5F, NAN, INFINITY, 1e-9F, 0.25F})
    EXPECT_TRUE(rejects_file(changed_grid(resolution_at, resolution),
                             {" m, 7 x 5", "do not match its extent", "a consistent grid"}))
        << resolution;
  for (const float x_max : {-1.0F, 1e9F, NAN, INFINITY, 4.0F})
    EXPECT_TRUE(rejects_file(changed_grid(x_max_at, x_max), {"do not match its extent"})) << x_max;
}

bool is_near_occupied(const COccupancyGridMap2D& map, float x, float y) {
  const float cell = map.getResolution();
  for (const float dx : {-cell, 0.0F, cell})
    for (const float dy : {-cell, 0.0F, cell})
      if (map.getPos(x + dx, y + dy) < 0.5F) return true;
  return false;
}

/// Checks that no pose of the robot is occupied, and that most laser beams end within one cell of
/// an occupied cell.
void expect_grid_matches_scans(const std::string& path) {
  mrpt::maps::CSimpleMap poses_and_scans;
  {
    mrpt::io::CFileGZInputStream file(path);
    auto archive = mrpt::serialization::archiveFrom(file);
    archive >> poses_and_scans;
  }
  const COccupancyGridMap2D map = load_occupancy_grid(path);
  EXPECT_FLOAT_EQ(map.getResolution(), 0.05F);
  std::size_t free_poses = 0, ends = 0, ends_occupied = 0;
  for (const auto& keyframe : poses_and_scans) {
    const mrpt::poses::CPose3D at = keyframe.pose->getMeanVal();
    free_poses +=
        map.getPos(static_cast<float>(at.x()), static_cast<float>(at.y())) >= 0.49F ? 1 : 0;
    mrpt::maps::CSimplePointsMap points;
    keyframe.sf->insertObservationsInto(points, at);
    for (std::size_t k = 0; k < points.size(); ++k) {
      float x = 0, y = 0;
      points.getPoint(k, x, y);
      ++ends;
      ends_occupied += is_near_occupied(map, x, y) ? 1 : 0;
    }
  }
  EXPECT_GT(poses_and_scans.size(), 10U);
  EXPECT_EQ(free_poses, poses_and_scans.size());
  EXPECT_GT(static_cast<double>(ends_occupied), 0.8 * static_cast<double>(ends));
}

TEST(ReadSimplemap, BuildsAGridThatMatchesTheScans) {
  expect_grid_matches_scans(kLaboratory);
  expect_grid_matches_scans(kBuilding);
}

TEST(ReadSimplemap, UsesTheResolutionOfTheOptions) {
  MapImportOptions options;
  options.simplemap_resolution = 0.2;
  EXPECT_FLOAT_EQ(load_map(kLaboratory, options).getResolution(), 0.2F);
}

TEST(ReadSimplemap, RejectsCorruptOrEmptyFiles) {
  const MapFolder folder;
  const std::string cut =
      folder.write("cut.simplemap.gz", bytes_of_file(kLaboratory).substr(0, 20000));
  EXPECT_TRUE(rejects_file(cut, {"corrupt or of another type ("}));
  const std::string grid = archived(folder, make_grid_map(2, 2, 1, {0, 0}), "grid.simplemap");
  EXPECT_TRUE(rejects_file(grid, {"corrupt or of another type ("}));
  const std::string empty = archived(folder, mrpt::maps::CSimpleMap(), "empty.simplemap");
  EXPECT_TRUE(rejects_file(empty, {"no observations", "laser scans"}));
}

/// One scan at each x (m), with an obstacle 1 m ahead.
mrpt::maps::CSimpleMap scans_at(const std::vector<double>& positions) {
  mrpt::maps::CSimpleMap map;
  for (const double x : positions) {
    auto scan = mrpt::obs::CObservation2DRangeScan::Create();
    scan->resizeScan(3);
    for (std::size_t i = 0; i < 3; ++i) {
      scan->setScanRange(i, 1);
      scan->setScanRangeValidity(i, true);
    }
    auto frame = mrpt::obs::CSensoryFrame::Create();
    frame->insert(scan);
    map.insert(mrpt::poses::CPose3DPDFGaussian::Create(mrpt::poses::CPose3D(x, 0, 0)), frame);
  }
  return map;
}

TEST(ReadSimplemap, RejectsPosesTooFarApart) {
  const MapFolder folder;
  const std::string far = archived(folder, scans_at({0, 1e9}), "far.simplemap");
  EXPECT_TRUE(rejects_file(far, {"poses too far apart", "0.05 m", "at most 400000000 cells"}));
  const std::string nowhere = archived(folder, scans_at({0, NAN}), "nowhere.simplemap");
  EXPECT_TRUE(rejects_file(nowhere, {"poses too far apart", "0.05 m", "at most 400000000 cells"}));
}

TEST(ReadSimplemap, RejectsAnInvalidResolution) {
  MapImportOptions options;
  options.simplemap_resolution = 0;
  EXPECT_TRUE(throws_error(ErrorKind::Usage, kLaboratory + ": ", {"resolution 0 m", "> 0"},
                           [&] { load_map(kLaboratory, options); }));
}

}  // namespace
}  // namespace slalom
