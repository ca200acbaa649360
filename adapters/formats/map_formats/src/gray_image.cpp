// SPDX-License-Identifier: BSD-3-Clause
#include "map_readers.h"

#include <slalom/core/error.h>
#include <slalom/core/quiet_standard_error.h>
#include <slalom/core/read_file.h>

#include <mrpt/img/CImage.h>

#include <algorithm>
#include <cctype>

namespace slalom {
namespace {

/// Reads the numbers of a PGM header or P2 image, separated by white space and # comments.
class PgmTokens {
 public:
  PgmTokens(const std::string& bytes, const std::string& path) : bytes_(bytes), path_(path) {}

  std::uint64_t number(std::uint64_t max, const char* what) {
    skip_blanks();
    if (at_ >= bytes_.size() || std::isdigit(static_cast<unsigned char>(bytes_[at_])) == 0)
      throw malformed(std::string("has no ") + what);
    std::uint64_t value = 0;
    while (at_ < bytes_.size() && std::isdigit(static_cast<unsigned char>(bytes_[at_])) != 0) {
      value = 10 * value + static_cast<std::uint64_t>(bytes_[at_++] - '0');
      if (value > max) throw malformed(std::string("has a ") + what + " that is too large");
    }
    return value;
  }

  void seek(std::size_t position) { at_ = position; }
  std::size_t position() const { return at_; }
  Error malformed(const std::string& what) const {
    return file_error(path_, what + " at byte " + std::to_string(at_), "a PGM image (P5 or P2)");
  }

 private:
  void skip_blanks() {
    while (at_ < bytes_.size()) {
      if (bytes_[at_] == '#') {
        while (at_ < bytes_.size() && bytes_[at_] != '\n') ++at_;
      } else if (std::isspace(static_cast<unsigned char>(bytes_[at_])) != 0) {
        ++at_;
      } else {
        return;
      }
    }
  }

  const std::string& bytes_;
  const std::string& path_;
  std::size_t at_ = 0;
};

/// The pixels of a P5: two bytes each, the higher one first, where white is beyond one byte
/// (netpbm's pgm(5)). Values above white are white.
std::vector<std::uint16_t> binary_pixels(const char* bytes, std::size_t count,
                                         std::uint16_t white) {
  std::vector<std::uint16_t> pixels(count);
  for (std::uint16_t& pixel : pixels) {
    unsigned value = static_cast<unsigned char>(*bytes++);
    if (white > 255) value = value << 8 | static_cast<unsigned char>(*bytes++);
    pixel = static_cast<std::uint16_t>(std::min<unsigned>(value, white));
  }
  return pixels;
}

/// Returns false also if OpenCV throws. It and its decoders print errors and warnings themselves.
bool try_load(mrpt::img::CImage& image, const std::string& path) {
  const QuietStandardError quiet;
  try {
    return image.loadFromFile(path, 0) && image.getWidth() > 0;
  } catch (const std::exception&) {
    return false;
  }
}

GrayImage read_with_mrpt(const std::string& path) {
  mrpt::img::CImage image;
  if (!try_load(image, path)) throw file_error(path, "unsupported image", "PGM, PNG, JPEG or BMP");
  GrayImage result;
  result.width = static_cast<int>(image.getWidth());
  result.height = static_cast<int>(image.getHeight());
  result.pixels.reserve(image.getWidth() * image.getHeight());
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x) result.pixels.push_back(*image(x, y, 0));
  return result;
}

}  // namespace

GrayImage parse_pgm(const std::string& bytes, const std::string& path) {
  constexpr std::uint64_t kMaxSide = 1U << 20;
  PgmTokens tokens(bytes, path);
  const bool binary = bytes.compare(0, 2, "P5") == 0;
  if (!binary && bytes.compare(0, 2, "P2") != 0)
    throw tokens.malformed("does not start with P5 or P2");
  tokens.seek(2);
  const std::uint64_t width = tokens.number(kMaxSide, "width");
  const std::uint64_t height = tokens.number(kMaxSide, "height");
  const std::uint64_t white = tokens.number(65535, "maximum gray value");
  if (width == 0 || height == 0 || white == 0 || width * height > kMaxCells)
    throw tokens.malformed("has an invalid size");
  GrayImage image;
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  image.white = static_cast<std::uint16_t>(white);
  const std::uint64_t count = width * height;
  if (binary) {
    const std::size_t begin = tokens.position() + 1;  // one white-space character after the header
    const std::size_t bytes_per_pixel = white > 255 ? 2 : 1;
    if (bytes.size() < begin || (bytes.size() - begin) / bytes_per_pixel < count)
      throw tokens.malformed("is truncated");
    image.pixels = binary_pixels(bytes.data() + begin, count, image.white);
  } else {
    if (bytes.size() < count) throw tokens.malformed("is truncated");
    for (std::uint64_t i = 0; i < count; ++i)
      image.pixels.push_back(static_cast<std::uint16_t>(tokens.number(white, "gray value")));
  }
  return image;
}

GrayImage read_gray_image(const std::string& path) {
  const std::string bytes = read_file(path, "an image", kMaxMapSize);
  if (bytes.size() > 1 && bytes[0] == 'P' && (bytes[1] == '5' || bytes[1] == '2'))
    return parse_pgm(bytes, path);
  check_image_size(bytes, path);
  return is_png(bytes) ? parse_png(bytes, path) : read_with_mrpt(path);
}

}  // namespace slalom
