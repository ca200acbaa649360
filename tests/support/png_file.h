// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <zlib.h>

namespace slalom {

/// Writes an RGB picture of 8 bits per channel, `rgb` row by row from the top, as PNG without row
/// filters: of drawings with few colors the files are half as large as with those that MRPT writes.
inline void write_flat_png(const std::string& path, std::uint32_t width, std::uint32_t height,
                           const std::string& rgb) {
  const auto number = [](std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8)
      bytes += static_cast<char>((value >> shift) & 0xFFU);
    return bytes;
  };
  const auto chunk = [&](const std::string& type, const std::string& data) {
    const std::string content = type + data;
    const auto* bytes = reinterpret_cast<const Bytef*>(content.data());
    const auto sum = static_cast<std::uint32_t>(crc32(0, bytes, static_cast<uInt>(content.size())));
    return number(static_cast<std::uint32_t>(data.size())) + content + number(sum);
  };
  std::string rows;
  const std::size_t row = std::size_t{3} * width;
  for (std::size_t y = 0; y < height; ++y) rows += '\0' + rgb.substr(y * row, row);
  uLongf size = compressBound(static_cast<uLong>(rows.size()));
  std::string packed(size, '\0');
  compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
            reinterpret_cast<const Bytef*>(rows.data()), static_cast<uLong>(rows.size()),
            Z_BEST_COMPRESSION);
  packed.resize(size);
  const std::string depth_and_type("\x08\x02\0\0\0", 5);
  std::ofstream(path, std::ios::binary)
      << "\x89PNG\r\n\x1a\n" + chunk("IHDR", number(width) + number(height) + depth_and_type) +
             chunk("IDAT", packed) + chunk("IEND", "");
}

}  // namespace slalom
