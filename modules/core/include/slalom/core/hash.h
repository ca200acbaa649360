#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct XXH3_state_s;

namespace slalom {

/// Streaming 128-bit content hash (XXH3). Numbers are fed as little-endian bytes; -0.0 counts as 0.
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

}  // namespace slalom
