// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../text_lines.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The numbers that a log of a trajectory may contain.
constexpr std::size_t kTime = 0, kX = 1, kY = 2, kPhi = 3, kV = 4, kW = 5, kVy = 6, kCommandV = 7,
                      kCommandW = 8, kCommandVy = 9, kQx = 10, kQy = 11, kQz = 12, kQw = 13,
                      kLogQuantities = 14;
using LogRow = std::array<double, kLogQuantities>;  ///< SI units

/// The places of the columns of a log.
struct LogColumns {
  struct Source {
    std::size_t field = 0;
    double factor = 1;
  };
  std::vector<std::string> names;  ///< of all fields
  char separator = ',';            ///< a blank: any number of blanks and tabs
  bool first_line_has_numbers = false, has_header = true;
  std::array<std::optional<Source>, kLogQuantities> sources;
  std::optional<std::size_t> nanoseconds;  ///< the field of what is added to the time
  std::string message;                     ///< of ROS 2, whose fields these are; "" for other logs

  bool has(std::size_t quantity) const { return sources[quantity].has_value(); }
  bool has_heading() const { return has(kPhi) || has(kQz); }

  /// Overwrites the numbers of the row that the line contains. False if one is "nan" that is not a
  /// command.
  bool read(const std::string& line, LogRow& row, const TextLines& lines) const;
  /// "--columns t=NAME*FACTOR": the option that multiplies the numbers by a further factor.
  std::string scaled(std::size_t quantity, double factor) const;
  /// The columns that are not used, or the names of those of a log without header; "" if neither.
  std::string note() const;
};

/// Whether the line with '#' before a line of numbers names their columns. It does if it has a name
/// of the time, or all columns of --columns.
bool is_header_before(const std::string& line, const std::string& columns_option,
                      const TextLines& lines);

/// The columns of a log by its first line of content, or by the line with '#' before it, or by the
/// number of its fields, as those of messages that `ros2 topic echo --csv` prints. `columns` is
/// --columns. Throws Error (File, Usage).
LogColumns find_log_columns(const std::string& line, const std::string& columns,
                            const TextLines& lines);

}  // namespace slalom
