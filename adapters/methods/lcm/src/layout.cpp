// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/lcm/layout.h>

#include <vector>

namespace slalom {
namespace {

constexpr std::size_t kFingerprint = 8, kInteger = 4, kDouble = 8, kFloat = 4;  // bytes

/// Skips a message field by field, never beyond its end.
class LayoutCursor {
 public:
  LayoutCursor(const void* data, std::size_t size) : data_(data), remaining_(size), size_(size) {}

  bool skip_field(char field) {
    switch (field) {
      case 'b':
        return skip(1);
      case 'i':
        return skip(kInteger);
      case 'l':
      case 'd':
        return skip(kDouble);
      case 's':
        return string();
      case 'n':
        return array_size();
      case 'D':
        return array(kDouble);
      case 'F':
        return array(kFloat);
      case 'S':
        return strings();
      default:
        return false;
    }
  }
  bool skip(std::size_t bytes) {
    if (bytes > remaining_) return false;
    remaining_ -= bytes;
    return true;
  }
  bool at_end() const { return remaining_ == 0; }

 private:
  bool integer(std::int32_t& value) {
    const auto at = static_cast<int>(size_ - remaining_);
    if (!skip(kInteger)) return false;
    __int32_t_decode_array(data_, at, kInteger, &value, 1);
    return true;
  }
  /// Lengths include the terminating zero.
  bool string() {
    std::int32_t length = 0;
    return integer(length) && length >= 1 && skip(static_cast<std::size_t>(length));
  }
  bool array_size() {
    std::int32_t size = 0;
    if (!integer(size) || size < 0) return false;
    sizes_.push_back(static_cast<std::size_t>(size));
    return true;
  }
  bool array(std::size_t element) {
    return sizes_.front() <= remaining_ / element && skip(sizes_.front() * element);
  }
  bool strings() {
    for (std::size_t i = 0; i < sizes_.back(); ++i)
      if (!string()) return false;
    return true;
  }

  const void* data_;
  std::size_t remaining_, size_;
  std::vector<std::size_t> sizes_;
};

}  // namespace

bool has_layout(const void* data, std::size_t size, const char* layout) {
  LayoutCursor cursor(data, size);
  if (!cursor.skip(kFingerprint)) return false;
  for (; *layout != '\0'; ++layout)
    if (!cursor.skip_field(*layout)) return false;
  return cursor.at_end();
}

}  // namespace slalom
