// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "byte_cursor.h"

#include <string>

namespace slalom {

/// Writes numbers, texts and sequences as ByteCursor reads them, little-endian. Messages in CDR
/// begin with their representation, which is not counted in the alignment.
class WireWriter {
 public:
  explicit WireWriter(ByteLayout layout = ByteLayout::Packed) : layout_(layout) {
    if (is_aligned()) bytes_ = std::string("\0\1\0\0", kRepresentation);
  }

  template <typename T>
  WireWriter& add(T value) {
    if (is_aligned())
      bytes_.append((sizeof(T) - (bytes_.size() - kRepresentation) % sizeof(T)) % sizeof(T), '\0');
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), &value, sizeof(T));
    bytes_.append(bytes.data(), bytes.size());
    return *this;
  }
  WireWriter& doubles(std::initializer_list<double> values) {
    for (const double value : values) add(value);
    return *this;
  }
  WireWriter& text(std::string_view text) {
    add(static_cast<std::uint32_t>(text.size() + (is_aligned() ? 1 : 0))).raw(text);
    if (is_aligned()) bytes_ += '\0';
    return *this;
  }
  template <typename T>
  WireWriter& sequence(const std::vector<T>& items) {
    add(static_cast<std::uint32_t>(items.size()));
    for (const T item : items) add(item);
    return *this;
  }
  WireWriter& raw(std::string_view bytes) {
    bytes_ += bytes;
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  static constexpr std::size_t kRepresentation = 4;  ///< bytes

  bool is_aligned() const { return layout_ != ByteLayout::Packed; }

  ByteLayout layout_;
  std::string bytes_;
};

}  // namespace slalom
