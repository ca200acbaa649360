// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/printable.h>

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace slalom {
namespace {

bool is_control(unsigned char c) {
  return c < 0x20 || c == 0x7F;
}

/// Bytes of the character that begins with `first`; 0 where no character does. RFC 3629.
std::size_t utf8_length(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

/// Restricts the second byte, so that each character has one form, and neither surrogates nor
/// numbers above U+10FFFF are accepted.
bool is_second_byte(unsigned char first, unsigned char second) {
  const unsigned char least = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const unsigned char most = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  return second >= least && second <= most;
}

/// Bytes of the character at `i`; 0 where there is none.
std::size_t character_length(const std::string& text, std::size_t i) {
  const auto byte = [&text](std::size_t at) { return static_cast<unsigned char>(text[at]); };
  const std::size_t length = utf8_length(byte(i));
  if (length < 2) return length;
  if (i + length > text.size() || !is_second_byte(byte(i), byte(i + 1))) return 0;
  for (std::size_t k = 2; k < length; ++k)
    if (byte(i + k) < 0x80 || byte(i + k) > 0xBF) return 0;
  return length;
}

/// Whether the character at `i` changes the direction of the text after it, which would show
/// another text than there is: U+061C, U+200E, U+200F, U+202A to U+202E and U+2066 to U+2069.
bool is_direction_control(const std::string& text, std::size_t i) {
  const std::string_view two(text.data() + i, std::min<std::size_t>(2, text.size() - i));
  if (two == "\xd8\x9c") return true;
  if (i + 2 >= text.size()) return false;
  const auto third = static_cast<unsigned char>(text[i + 2]);
  if (two == "\xe2\x80") return third == 0x8E || third == 0x8F || (third >= 0xAA && third <= 0xAE);
  return two == "\xe2\x81" && third >= 0xA6 && third <= 0xA9;
}

/// Bytes of the character at `i` that can be shown; 0 where there is none. U+0080 to U+009F are
/// control characters, too.
std::size_t shown_length(const std::string& text, std::size_t i) {
  const auto first = static_cast<unsigned char>(text[i]);
  const bool control =
      (is_control(first) && first != '\t') ||
      (first == 0xC2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xA0);
  return control || is_direction_control(text, i) ? 0 : character_length(text, i);
}

std::string number_of(char c) {
  return fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
}

}  // namespace

std::string printable_line(const std::string& text) {
  std::string line;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = shown_length(text, i);
    const bool line_break = text[i] == '\n' || text[i] == '\r';
    line += length > 0 ? text.substr(i, length) : line_break ? " " : number_of(text[i]);
    i += std::max<std::size_t>(length, 1);
  }
  return line;
}

std::optional<std::size_t> find_invalid_utf8(const std::string& text) {
  std::size_t i = 0;
  while (i < text.size()) {
    const std::size_t length = character_length(text, i);
    if (length == 0) return i;
    i += length;
  }
  return std::nullopt;
}

bool is_text(const std::string& content) {
  return std::none_of(content.begin(), content.end(), [](char c) {
    return is_control(static_cast<unsigned char>(c)) && (c < '\t' || c > '\r');
  });
}

}  // namespace slalom
