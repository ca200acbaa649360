// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct XXH3_state_s;

namespace slalom {

/// Streaming 128-bit content hash (XXH3). Numbers are hashed as little-endian bytes; -0.0 equals 0.
class Hasher {
 public:
  Hasher();
  ~Hasher();
  Hasher(const Hasher&) = delete;
  Hasher& operator=(const Hasher&) = delete;

  Hasher& add(std::string_view text);  ///< length, then bytes
  Hasher& add(double number);
  Hasher& add(std::uint64_t number);
  Hasher& add_bytes(const void* data, std::size_t size);

  std::string hex() const;  ///< 32 lower-case hexadecimal digits

 private:
  XXH3_state_s* state_;
};

/// Whether two numbers have the same representation, unlike ==: -0.0 differs from 0.0, and a NaN
/// equals itself.
bool same_bits(double a, double b);

}  // namespace slalom
