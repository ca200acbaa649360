// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/error.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace slalom {

/// Serializes numbers and strings as little-endian bytes.
class ByteWriter {
 public:
  ByteWriter& u8(std::uint8_t value) {
    bytes_ += static_cast<char>(value);
    return *this;
  }
  ByteWriter& u64(std::uint64_t value) {
    char bytes[8];
    for (int i = 0; i < 8; ++i) bytes[i] = static_cast<char>(value >> (8 * i));
    bytes_.append(bytes, sizeof bytes);
    return *this;
  }
  ByteWriter& f64(double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return u64(bits);
  }
  ByteWriter& text(const std::string& value) {
    u64(value.size());
    bytes_ += value;
    return *this;
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Deserializes them with bounds checks. Throws Error (File) with source and position.
class ByteReader {
 public:
  /// The bytes must outlive it.
  ByteReader(std::string_view bytes, std::string where) : bytes_(bytes), where_(std::move(where)) {}

  std::uint8_t u8() { return static_cast<std::uint8_t>(*take(1)); }
  std::uint64_t u64() {
    const char* data = take(8);
    std::uint64_t value = 0;
    for (int i = 0; i < 8; ++i)
      value |= static_cast<std::uint64_t>(static_cast<unsigned char>(data[i])) << (8 * i);
    return value;
  }
  double f64() {
    const std::uint64_t bits = u64();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }
  std::string text() {
    const std::uint64_t size = u64();
    return {take(size), static_cast<std::size_t>(size)};
  }
  /// The number of items of at least `item_size` bytes each that follow.
  std::size_t count(std::size_t item_size) {
    const std::uint64_t value = u64();
    if (value > left() / item_size) throw broken("invalid item count");
    return static_cast<std::size_t>(value);
  }
  const char* take(std::uint64_t size) {
    if (size > left()) throw broken("unexpected end of data");
    const char* data = bytes_.data() + position_;
    position_ += static_cast<std::size_t>(size);
    return data;
  }
  void expect_version(std::uint8_t version) {
    if (u8() != version) throw broken("unsupported version");
  }
  void expect_end() const {
    if (left() != 0) throw broken("unexpected trailing bytes");
  }
  Error broken(const std::string& what) const {
    return file_error(where_, what + " at byte " + std::to_string(position_),
                      "content written by Slalom");
  }

 private:
  std::size_t left() const { return bytes_.size() - position_; }

  std::string_view bytes_;
  std::string where_;
  std::size_t position_ = 0;
};

}  // namespace slalom
