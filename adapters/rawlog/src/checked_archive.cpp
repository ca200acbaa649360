#include "checked_archive.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string_view>

namespace slalom {
namespace {

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

/// Numbers of MRPT's archives are little-endian.
std::uint32_t number_in(const char* data) {
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
  look_at(data, count);
  return count;
}

std::size_t CheckedArchive::write(const void*, std::size_t) {
  throw std::logic_error("an archive that is only read");
}

void CheckedArchive::look_at(const char* data, std::size_t size) {
  const std::string_view text(data, size);
  if (ends_with(text, "CObservation2DRangeScan")) {
    place_ = Place::InScan;
  } else if (place_ == Place::InScan && ends_with(text, "CPose3D")) {
    place_ = Place::BehindPose;
    last_count_ = 0;
  } else if (place_ == Place::BehindPose && size == sizeof last_count_) {
    constexpr std::size_t kBytesPerRay = 5;  // a range and whether it is valid
    last_count_ = number_in(data);
    if (last_count_ > (bytes_.size() - position_) / kBytesPerRay) {
      refusal_ = "a scan claims more rays than the file has bytes";
      throw std::runtime_error(refusal_);
    }
    if (last_count_ == 0) place_ = Place::Elsewhere;
  } else if (place_ == Place::BehindPose && last_count_ > 0 &&
             size == sizeof(float) * last_count_) {
    place_ = Place::Elsewhere;  // these were the ranges
  }
}

}  // namespace slalom
