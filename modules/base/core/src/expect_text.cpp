// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/expect_text.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {

void expect_utf8(const std::string& text, const std::string& where, const std::string& expected) {
  const auto at = find_invalid_utf8(text);
  if (!at) return;
  const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(*at), '\n');
  throw file_error(where + ":" + std::to_string(line + 1), "contains a byte that is not UTF-8",
                   expected);
}

void expect_name(const std::string& name, const std::string& of_what) {
  constexpr std::size_t kMostBytes = 1000, kShown = 40;
  const std::string where = "name of " + of_what + " '" + printable_line(name.substr(0, kShown)) +
                            (name.size() > kShown ? "...'" : "'");
  const std::string expected = "at most 1000 bytes of UTF-8";
  if (name.size() > kMostBytes)
    throw file_error(where, "has " + count_text(name.size(), "byte"), expected);
  if (const auto at = find_invalid_utf8(name))
    throw file_error(where, "byte " + std::to_string(*at + 1) + " is not UTF-8", expected);
}

}  // namespace slalom
