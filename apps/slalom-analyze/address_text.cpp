// SPDX-License-Identifier: BSD-3-Clause
#include "address_text.h"

#include <cctype>

namespace slalom {

std::string address_text(const std::string& text) {
  constexpr const char* kDigits = "0123456789ABCDEF";
  std::string address;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = std::isalnum(byte) != 0 || c == '/' || c == '-' || c == '_' || c == '.';
    if (plain)
      address += c;
    else
      address += std::string("%") + kDigits[byte / 16] + kDigits[byte % 16];
  }
  return address;
}

}  // namespace slalom
