#include "map_readers.h"

#include <slalom/core/error.h>

#include <mrpt/img/CImage.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace slalom {
namespace {

/// Reads the header's and a P2's numbers: white space and # comments between them.
class PgmTokens {
 public:
  PgmTokens(const std::string& bytes, const std::string& path) : bytes_(bytes), path_(path) {}

  std::uint64_t number(std::uint64_t most, const char* what) {
    skip_blanks();
    if (at_ >= bytes_.size() || std::isdigit(static_cast<unsigned char>(bytes_[at_])) == 0)
      throw broken(std::string("has no ") + what);
    std::uint64_t value = 0;
    while (at_ < bytes_.size() && std::isdigit(static_cast<unsigned char>(bytes_[at_])) != 0) {
      value = 10 * value + static_cast<std::uint64_t>(bytes_[at_++] - '0');
      if (value > most) throw broken(std::string("has a ") + what + " that is too large");
    }
    return value;
  }

  void start_after(std::size_t position) { at_ = position; }
  std::size_t position() const { return at_; }
  Error broken(const std::string& what) const {
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

/// False as well where MRPT throws what OpenCV throws.
bool loads(mrpt::img::CImage& image, const std::string& path) {
  try {
    return image.loadFromFile(path, 0) && image.getWidth() > 0;
  } catch (const std::exception&) {
    return false;
  }
}

GreyImage read_with_mrpt(const std::string& path) {
  mrpt::img::CImage image;
  if (!loads(image, path))
    throw file_error(path, "is no image that can be read", "PGM, PNG, JPEG or BMP");
  GreyImage result;
  result.width = static_cast<int>(image.getWidth());
  result.height = static_cast<int>(image.getHeight());
  result.pixels.reserve(image.getWidth() * image.getHeight());
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x) result.pixels.push_back(*image(x, y, 0));
  return result;
}

}  // namespace

std::string read_bytes(const std::string& path, std::uint64_t most) {
  std::error_code ignored;
  const bool folder = std::filesystem::is_directory(path, ignored);  // opens, but cannot be read
  const std::uintmax_t size = std::filesystem::file_size(path, ignored);
  if (!ignored && size > most)
    throw file_error(path, "has " + std::to_string(size) + " bytes",
                     "at most " + std::to_string(most));
  std::ifstream file(path, std::ios::binary);
  std::stringstream content;
  if (file && !folder) content << file.rdbuf();
  if (!file || file.bad() || folder) throw file_error(path, "cannot be read", "a map file");
  return content.str();
}

GreyImage parse_pgm(const std::string& bytes, const std::string& path) {
  constexpr std::uint64_t kMaxSide = 1U << 20;
  PgmTokens tokens(bytes, path);
  const bool binary = bytes.compare(0, 2, "P5") == 0;
  if (!binary && bytes.compare(0, 2, "P2") != 0)
    throw tokens.broken("does not begin with P5 or P2");
  tokens.start_after(2);
  const std::uint64_t width = tokens.number(kMaxSide, "width");
  const std::uint64_t height = tokens.number(kMaxSide, "height");
  const std::uint64_t white = tokens.number(255, "largest grey value");
  if (width == 0 || height == 0 || white == 0 || width * height > kMaxCells)
    throw tokens.broken("has an impossible size");
  GreyImage image{static_cast<int>(width), static_cast<int>(height), {}};
  const std::uint64_t count = width * height;
  if (binary) {
    const std::size_t begin = tokens.position() + 1;  // one white space after the header
    if (bytes.size() < begin || bytes.size() - begin < count) throw tokens.broken("ends too early");
    image.pixels.assign(bytes.begin() + static_cast<std::ptrdiff_t>(begin),
                        bytes.begin() + static_cast<std::ptrdiff_t>(begin + count));
  } else {
    if (bytes.size() < count) throw tokens.broken("ends too early");
    for (std::uint64_t i = 0; i < count; ++i)
      image.pixels.push_back(static_cast<std::uint8_t>(tokens.number(white, "grey value")));
  }
  if (white != 255)
    for (std::uint8_t& pixel : image.pixels)
      pixel = static_cast<std::uint8_t>(std::min<std::uint64_t>(255, pixel * 255U / white));
  return image;
}

GreyImage read_grey_image(const std::string& path) {
  const std::string bytes = read_bytes(path);
  if (bytes.size() > 1 && bytes[0] == 'P' && (bytes[1] == '5' || bytes[1] == '2'))
    return parse_pgm(bytes, path);
  expect_possible_image(bytes, path);
  return read_with_mrpt(path);
}

}  // namespace slalom
