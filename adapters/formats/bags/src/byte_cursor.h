// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/bags/bag.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <vector>

namespace slalom {

/// How numbers are stored. Packed is that of ROS 1, of MCAP and of bags of ROS 1: little-endian
/// without gaps, texts with their length. In CDR a number is at a multiple of its size, and the
/// length of a text includes a terminating zero (OMG formal/2002-06-51, section 15.3; in ROS 2
/// after the header of RTPS, formal/2019-04-03, section 10.2).
enum class ByteLayout { Packed, CdrLittleEndian, CdrBigEndian };

/// Reads numbers, texts and sequences from bytes. Throws Error (File) at `place` beyond their end.
class ByteCursor {
 public:
  ByteCursor(std::string_view bytes, const BagPlace& place, ByteLayout layout = ByteLayout::Packed)
      : bytes_(bytes), place_(place), layout_(layout) {}

  bool at_end() const { return position_ == bytes_.size(); }
  std::size_t left() const { return bytes_.size() - position_; }

  std::string_view take(std::uint64_t size) {
    if (size > left()) throw place_.error("ends too early or states a wrong size");
    const std::string_view part = bytes_.substr(position_, static_cast<std::size_t>(size));
    position_ += part.size();
    return part;
  }

  template <typename T>
  T get() {
    align(sizeof(T));
    std::array<char, sizeof(T)> bytes{};
    const std::string_view from = take(sizeof(T));
    std::copy(from.begin(), from.end(), bytes.begin());
    if (is_swapped()) std::reverse(bytes.begin(), bytes.end());
    T value;
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
  }

  std::string_view text() {
    std::string_view text = take(get<std::uint32_t>());
    if (layout_ != ByteLayout::Packed && !text.empty()) text.remove_suffix(1);
    return text;
  }

  /// The length of a sequence whose elements have at least `item_size` bytes each.
  std::size_t count(std::size_t item_size) {
    const auto count = get<std::uint32_t>();
    if (count > left() / item_size) throw place_.error("states a wrong number of elements");
    return count;
  }

  template <typename T>
  std::vector<T> sequence() {
    std::vector<T> items(count(sizeof(T)));
    if (is_swapped()) {
      for (T& item : items) item = get<T>();
    } else if (!items.empty()) {
      align(sizeof(T));
      const std::string_view from = take(items.size() * sizeof(T));
      std::memcpy(items.data(), from.data(), from.size());
    }
    return items;
  }

 private:
  bool is_swapped() const { return layout_ == ByteLayout::CdrBigEndian; }
  void align(std::size_t size) {
    if (layout_ != ByteLayout::Packed) take((size - position_ % size) % size);
  }

  std::string_view bytes_;
  const BagPlace& place_;
  ByteLayout layout_;
  std::size_t position_ = 0;
};

}  // namespace slalom
