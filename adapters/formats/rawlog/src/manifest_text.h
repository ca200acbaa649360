// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/run_record.h>

#include <string>

namespace slalom {

/// Formats a manifest as lines "key = value", sorted by key. A value of several lines (or with
/// leading or trailing blanks) follows its key, indented by two blanks.
std::string manifest_to_text(const Manifest& manifest);

/// Parses it. Throws Error (File) with location `where` and the line.
Manifest manifest_from_text(const std::string& text, const std::string& where);

}  // namespace slalom
