// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace slalom {

/// Throws Error (File) at `where` and the line of the first byte that is not UTF-8.
void expect_utf8(const std::string& text, const std::string& where, const std::string& expected);

/// Throws Error (File) for a name that is longer than 1,000 bytes or not UTF-8: names of methods,
/// scenarios and columns come from files of others, and go to tables, pages and messages.
void expect_name(const std::string& name, const std::string& of_what);

}  // namespace slalom
