// SPDX-License-Identifier: BSD-3-Clause
#include "map_readers.h"

#include <slalom/core/error.h>

#include <optional>

namespace slalom {
namespace {

struct ImageSize {
  const char* kind;
  std::uint64_t width, height;
};

/// A byte of the file; 0 beyond its end.
std::uint64_t byte_at(const std::string& bytes, std::size_t at) {
  return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0;
}

std::uint64_t big_endian(const std::string& bytes, std::size_t at, std::size_t count) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < count; ++i) number = number << 8U | byte_at(bytes, at + i);
  return number;
}

/// The absolute value: a negative height means top-down row order.
std::uint64_t bmp_side(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 4; i > 0; --i)
    number = number << 8U | static_cast<std::uint32_t>(byte_at(bytes, at + i - 1));
  return number > 0x80000000U ? 0U - number : number;
}

/// The frame header (SOF) among the segments of a JPEG.
std::optional<ImageSize> jpeg_size(const std::string& bytes) {
  std::size_t at = 2;
  while (at + 9 < bytes.size() && byte_at(bytes, at) == 0xFF) {
    const std::uint64_t marker = byte_at(bytes, at + 1);
    const bool is_frame =
        marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
    if (is_frame)
      return ImageSize{"JPEG", big_endian(bytes, at + 7, 2), big_endian(bytes, at + 5, 2)};
    at += marker == 0xFF ? 1 : 2 + static_cast<std::size_t>(big_endian(bytes, at + 2, 2));
  }
  return std::nullopt;
}

std::optional<ImageSize> declared_size(const std::string& bytes) {
  if (bytes.compare(1, 3, "PNG") == 0)
    return ImageSize{"PNG", big_endian(bytes, 16, 4), big_endian(bytes, 20, 4)};
  if (bytes.compare(0, 2, "BM") == 0)
    return ImageSize{"BMP", bmp_side(bytes, 18), bmp_side(bytes, 22)};
  if (bytes.compare(0, 2, "\xFF\xD8") == 0) return jpeg_size(bytes);
  return std::nullopt;
}

}  // namespace

void check_image_size(const std::string& bytes, const std::string& path) {
  if (bytes.size() < 24) return;  // too short for any header; rejected by the decoder
  const auto size = declared_size(bytes);
  if (!size || size->height == 0 || size->width <= kMaxCells / size->height) return;
  throw file_error(path,
                   std::string("is a ") + size->kind + " of " + std::to_string(size->width) +
                       " x " + std::to_string(size->height) + " pixels",
                   "at most " + std::to_string(kMaxCells) + " pixels");
}

}  // namespace slalom
