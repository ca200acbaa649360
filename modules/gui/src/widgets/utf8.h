#pragma once

namespace slalom {

/// Whether `c` is a continuation byte of UTF-8.
inline bool is_continuation_byte(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

}  // namespace slalom
