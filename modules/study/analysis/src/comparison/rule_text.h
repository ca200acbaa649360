// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The groups of an extended regular expression of POSIX that matches all of the text, the whole
/// first; those that took no part are nullopt. Nothing if it does not match. The C library's, since
/// each source with std::regex takes seconds to compile.
std::optional<std::vector<std::optional<std::string>>> match_rule(const std::string& text,
                                                                  const char* pattern);

}  // namespace slalom
