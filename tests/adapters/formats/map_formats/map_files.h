// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "error_text.h"

#include <mrpt/io/CFileGZInputStream.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdlib.h>
#include <string>
#include <vector>
#include <zlib.h>

namespace slalom {

/// A temporary folder for the files of one test.
class MapFolder {
 public:
  MapFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "slalom-maps-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no folder " + pattern);
    folder_ = pattern;
  }
  ~MapFolder() { std::filesystem::remove_all(folder_); }
  MapFolder(const MapFolder&) = delete;
  MapFolder& operator=(const MapFolder&) = delete;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }

 private:
  std::filesystem::path folder_;
};

inline std::string bytes_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The decompressed content of a file.
inline std::string decompressed(const std::string& path) {
  mrpt::io::CFileGZInputStream file(path);
  std::string all, part(1 << 16, '\0');
  while (const std::size_t got = file.Read(part.data(), part.size())) all.append(part, 0, got);
  return all;
}

/// Big-endian, as in PNG.
inline std::string four_bytes(std::uint32_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xff);
  return bytes;
}

/// The color types of PNG.
inline constexpr char kGray = 0, kRgb = 2, kPalette = 3, kGrayAlpha = 4, kRgbAlpha = 6;

inline std::string png_chunk(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  const auto* bytes = reinterpret_cast<const unsigned char*>(body.data());
  const auto sum = crc32(0, bytes, static_cast<unsigned>(body.size()));
  return four_bytes(static_cast<std::uint32_t>(data.size())) + body +
         four_bytes(static_cast<std::uint32_t>(sum));
}

/// A PNG of `samples`, whose rows have equal sizes. `chunks` are between its header and its pixels.
inline std::string png(std::uint32_t width, std::uint32_t height, char bits, char color_type,
                       const std::string& samples, const std::string& chunks = "") {
  const std::size_t row = samples.size() / height;
  std::string lines;
  for (std::size_t y = 0; y < height; ++y) lines += '\0' + samples.substr(y * row, row);
  std::string packed(compressBound(lines.size()), '\0');
  unsigned long size = packed.size();
  compress(reinterpret_cast<unsigned char*>(packed.data()), &size,
           reinterpret_cast<const unsigned char*>(lines.data()), lines.size());
  packed.resize(size);
  const std::string header =
      four_bytes(width) + four_bytes(height) + bits + color_type + std::string(3, '\0');
  return "\x89PNG\r\n\x1A\n" + png_chunk("IHDR", header) + chunks + png_chunk("IDAT", packed) +
         png_chunk("IEND", "");
}

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace slalom
