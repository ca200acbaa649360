// SPDX-License-Identifier: BSD-3-Clause
#include "map_readers.h"

#include <slalom/core/error.h>

#include <csetjmp>
#include <cstring>
#include <new>
#include <png.h>

namespace slalom {
namespace {

/// A decoder of a PNG in memory. Keeps messages of libpng off standard error.
class PngDecoder {
 public:
  explicit PngDecoder(const std::string& bytes) : bytes_(bytes) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore);
    info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
    if (info_ == nullptr) throw std::bad_alloc();
    png_set_read_fn(png_, this, read_bytes);
  }
  ~PngDecoder() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngDecoder(const PngDecoder&) = delete;
  PngDecoder& operator=(const PngDecoder&) = delete;

  /// Selects gray of 8 bits, followed by alpha if the image has any. Returns false if it fails.
  bool read_header() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_info(png_, info_);
    const auto color = png_get_color_type(png_, info_);
    png_set_strip_16(png_);
    if (color == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(png_);
    if (color == PNG_COLOR_TYPE_GRAY) png_set_expand_gray_1_2_4_to_8(png_);
    if (png_get_valid(png_, info_, PNG_INFO_tRNS) != 0) png_set_tRNS_to_alpha(png_);
    constexpr int kNoWarning = 1;
    if ((color & PNG_COLOR_MASK_COLOR) != 0)
      png_set_rgb_to_gray(png_, kNoWarning, 0.299, 0.587);  // as OpenCV weights red and green
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    return true;
  }

  std::size_t width() const { return png_get_image_width(png_, info_); }
  std::size_t height() const { return png_get_image_height(png_, info_); }
  std::size_t channels() const { return png_get_channels(png_, info_); }

  /// Returns false if it fails.
  bool read_rows(std::vector<png_bytep>& rows) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_image(png_, rows.data());
    png_read_end(png_, nullptr);
    return true;
  }

 private:
  [[noreturn]] static void fail(png_structp png, png_const_charp) { png_longjmp(png, 1); }
  static void ignore(png_structp, png_const_charp) {}

  static void read_bytes(png_structp png, png_bytep to, std::size_t size) {
    auto& decoder = *static_cast<PngDecoder*>(png_get_io_ptr(png));
    if (size > decoder.bytes_.size() - decoder.at_) png_error(png, "truncated");
    std::memcpy(to, decoder.bytes_.data() + decoder.at_, size);
    decoder.at_ += size;
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

GrayImage to_gray_image(const std::vector<std::uint8_t>& bytes, const PngDecoder& decoder) {
  GrayImage image;
  image.width = static_cast<int>(decoder.width());
  image.height = static_cast<int>(decoder.height());
  const std::size_t channels = decoder.channels(), count = bytes.size() / channels;
  image.pixels.resize(count);
  for (std::size_t i = 0; i < count; ++i) image.pixels[i] = bytes[i * channels];
  if (channels < 2) return image;
  image.transparent.resize(count);
  for (std::size_t i = 0; i < count; ++i) image.transparent[i] = bytes[i * channels + 1] < 255;
  return image;
}

}  // namespace

bool is_png(const std::string& bytes) {
  return bytes.compare(0, 8, "\x89PNG\r\n\x1A\n") == 0;
}

GrayImage parse_png(const std::string& bytes, const std::string& path) {
  const auto malformed = [&path] { return file_error(path, "malformed PNG", "a PNG image"); };
  PngDecoder decoder(bytes);
  if (!decoder.read_header()) throw malformed();
  const std::size_t row_size = decoder.width() * decoder.channels();
  std::vector<std::uint8_t> pixels(row_size * decoder.height());
  std::vector<png_bytep> rows(decoder.height());
  for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = pixels.data() + y * row_size;
  if (!decoder.read_rows(rows)) throw malformed();
  return to_gray_image(pixels, decoder);
}

}  // namespace slalom
