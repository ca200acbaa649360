#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace slalom {

/// What a line for log files says.
struct ProgressLine {
  std::string what;
  std::size_t done = 0, total = 0;
};

/// Of a line of make_terminal_progress(); none for other lines.
std::optional<ProgressLine> parse_progress_line(const std::string& line);

}  // namespace slalom
