#pragma once

namespace slalom {

/// Whether a byte of UTF-8 only continues a letter.
inline bool continues_letter(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

}  // namespace slalom
