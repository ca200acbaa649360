// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/map_formats/map_import.h>

#include <cstdint>
#include <string>
#include <vector>

namespace slalom {

/// Maximum number of cells of maps that Slalom reads.
constexpr std::uint64_t kMaxCells = 400'000'000;

mrpt::maps::COccupancyGridMap2D read_gridmap(const std::string& path);
mrpt::maps::COccupancyGridMap2D read_simplemap(const std::string& path, double resolution);
/// `notes` as in MapImportOptions.
mrpt::maps::COccupancyGridMap2D read_ros_map(const std::string& path,
                                             std::vector<std::string>* notes = nullptr);
mrpt::maps::COccupancyGridMap2D read_image_map(const std::string& path,
                                               const ImageMapOptions& options);

/// A gray-scale image, row 0 on top, pixels from 0 (black) to `white`.
struct GrayImage {
  int width = 0, height = 0;
  std::vector<std::uint16_t> pixels;
  std::uint16_t white = 255;      ///< 1 to 65535; beyond 255 of PGM files with two bytes a pixel
  std::vector<bool> transparent;  ///< pixels that are not opaque; empty if the image has no alpha

  bool is_transparent(std::size_t pixel) const {
    return !transparent.empty() && transparent[pixel];
  }
};

/// Reads PGM (P5 binary or P2 text) by parse_pgm(), PNG by parse_png(), other formats by MRPT,
/// which drops their alpha. Throws Error (File).
GrayImage read_gray_image(const std::string& path);
/// Throws Error (File) if the header of a PNG, JPEG or BMP declares too many pixels.
void check_image_size(const std::string& bytes, const std::string& path);
GrayImage parse_pgm(const std::string& bytes, const std::string& path);
bool is_png(const std::string& bytes);
GrayImage parse_png(const std::string& bytes, const std::string& path);

/// The fields of a line, separated by any number of blanks, tabs, commas and semicolons.
std::vector<std::string> separated_fields(const std::string& line);

/// Maximum size of map files: four characters for each cell.
constexpr std::uint64_t kMaxMapSize = 4 * kMaxCells;

}  // namespace slalom
