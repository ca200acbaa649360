#pragma once

#include <slalom/map_formats/map_import.h>

#include <cstdint>
#include <string>
#include <vector>

namespace slalom {

/// No map that Slalom reads has more cells.
constexpr std::uint64_t kMaxCells = 400'000'000;

mrpt::maps::COccupancyGridMap2D read_gridmap(const std::string& path);
mrpt::maps::COccupancyGridMap2D read_simplemap(const std::string& path, double resolution);
mrpt::maps::COccupancyGridMap2D read_ros_map(const std::string& path);
mrpt::maps::COccupancyGridMap2D read_image_map(const std::string& path,
                                               const ImageMapOptions& options);

/// A grey picture, row 0 on top, 0 black to 255 white.
struct GreyImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
};

/// PGM (P5 binary or P2 text) by our own reader, other formats by MRPT. Throws Error (File).
GreyImage read_grey_image(const std::string& path);
/// Throws Error (File) where the head of a PNG, JPEG or BMP announces too many pixels.
void expect_possible_image(const std::string& bytes, const std::string& path);
GreyImage parse_pgm(const std::string& bytes, const std::string& path);

/// A whole file of at most `most` bytes. Throws Error (File).
std::string read_bytes(const std::string& path, std::uint64_t most = 4 * kMaxCells);

}  // namespace slalom
