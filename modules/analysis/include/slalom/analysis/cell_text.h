#pragma once

#include <slalom/analysis/cross_table.h>

#include <string>
#include <vector>

namespace slalom {

/// Digits after the point that show three significant digits of the largest number in the cells,
/// 2 for a rate.
int digits_for(const std::vector<const Cell*>& cells, const Column& column);
int column_digits(const CrossTable& table, std::size_t column);

/// "0.93", or "-" where there is none.
std::string estimate_text(const Cell& cell, int digits);
/// "[0.88, 0.96]", or "".
std::string interval_text(const Cell& cell, int digits);
/// What stands behind the estimate: "56/60" for a rate (successes of values), otherwise "±0.05
/// n=60"; with " NA=4" where values are missing.
std::string support_text(const Cell& cell, const Column& column, int digits);

/// "optimality: 4 collision, 2 timeout", or "" where no value is missing.
std::string na_text(const Column& column, const std::map<std::string, std::size_t>& reasons);
/// Over all rows of a table.
std::map<std::string, std::size_t> na_of_column(const CrossTable& table, std::size_t column);

/// "1 run", "2 runs".
std::string count_text(std::size_t n, const std::string& noun);

/// "↑", "↓" or "": which way is better.
std::string direction_arrow(Direction direction);

/// Columns that `text` (UTF-8) takes on a terminal.
std::size_t display_width(const std::string& text);
/// Control characters, which could steer a terminal, become '?'.
std::string printable(const std::string& text);
/// Padded with blanks to `width`.
std::string pad_left(const std::string& text, std::size_t width);
std::string pad_right(const std::string& text, std::size_t width);

}  // namespace slalom
