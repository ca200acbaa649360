// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace slalom {

/// Content of a line for log files.
struct ProgressLine {
  std::string what;
  std::size_t done = 0, total = 0;
};

/// Parses a line of make_terminal_progress(); none for other lines.
std::optional<ProgressLine> parse_progress_line(const std::string& line);

}  // namespace slalom
