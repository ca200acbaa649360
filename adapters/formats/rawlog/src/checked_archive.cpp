// SPDX-License-Identifier: BSD-3-Clause
#include "checked_archive.h"

#include <slalom/core/text.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string_view>

namespace slalom {
namespace {

/// Decodes a little-endian number, as in MRPT's archives.
std::uint32_t read_uint32(const char* data) {
  std::uint32_t number = 0;
  for (int i = 3; i >= 0; --i) number = (number << 8) | static_cast<unsigned char>(data[i]);
  return number;
}

}  // namespace

std::size_t CheckedArchive::read(void* to, std::size_t size) {
  const std::size_t count = std::min(size, bytes_.size() - position_);
  const char* data = bytes_.data() + position_;
  std::memcpy(to, data, count);
  position_ += count;
  inspect(data, count);
  return count;
}

std::size_t CheckedArchive::write(const void*, std::size_t) {
  throw std::logic_error("archive is read-only");
}

void CheckedArchive::inspect(const char* data, std::size_t size) {
  const std::string_view text(data, size);
  if (ends_with(text, "CObservation2DRangeScan")) {
    state_ = State::InScan;
  } else if (state_ == State::InScan && ends_with(text, "CPose3D")) {
    state_ = State::AfterPose;
    last_count_ = 0;
  } else if (state_ == State::AfterPose && size == sizeof last_count_) {
    constexpr std::size_t kBytesPerRay = 5;  // range and validity flag
    last_count_ = read_uint32(data);
    if (last_count_ > (bytes_.size() - position_) / kBytesPerRay) {
      error_ = "the ray count of a scan exceeds the size of the file";
      throw std::runtime_error(error_);
    }
    if (last_count_ == 0) state_ = State::Outside;
  } else if (state_ == State::AfterPose && last_count_ > 0 && size == sizeof(float) * last_count_) {
    state_ = State::Outside;  // these were the ranges
  }
}

}  // namespace slalom
