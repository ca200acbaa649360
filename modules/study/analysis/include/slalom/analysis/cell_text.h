// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/table_types.h>

#include <string>
#include <vector>

namespace slalom {

/// The number of decimals that shows three significant digits of the largest number in the cells;
/// 2 for a rate.
int digits_for(const std::vector<const Cell*>& cells, const Column& column);
int column_digits(const CrossTable& table, std::size_t column);

/// "0.93", or "-" if there is none; "median 12.3" if it has an interval, and the mean none.
std::string estimate_text(const Cell& cell, int digits);
/// The interval of estimate_text(): "[0.88, 0.96]", or "".
std::string interval_text(const Cell& cell, int digits);
/// Both, "0.93 [0.88, 0.96]".
std::string value_text(const Cell& cell, int digits);
/// "0.93 [0.88, 0.96]", or "0.93" without an interval.
std::string estimate_text(double estimate, const std::optional<Interval>& interval, int digits);
/// The interval of the median if there is one, otherwise of the mean.
const std::optional<Interval>& stated_interval(const Cell& cell);
/// Sample size and deviation of the estimate: "42/56" for a rate (successes of values), with "
/// NA=4" if runs have no value, otherwise "±0.05 n = 56 of 60", after "mean 12.9 " if the estimate
/// is a median.
std::string support_text(const Cell& cell, const Column& column, int digits);
/// "n = 56", or "n = 56 of 60" if only 56 of 60 runs have a value, on which the estimate depends.
std::string values_text(const Cell& cell);

/// "optimality: 4 collision, 2 timeout", or "" if no value is missing.
std::string na_text(const Column& column, const std::map<std::string, std::size_t>& reasons);
/// Over all rows of a table.
std::map<std::string, std::size_t> na_of_column(const CrossTable& table, std::size_t column);

/// "95" for 0.95: percent without the digits that binary fractions add.
std::string percent_text(double fraction);

/// "87" for 0.871, "99.8" for 0.998: percent that are 0 or 100 only if the fraction is 0 or 1.
std::string share_text(double fraction);

/// "↑", "↓" or "": the direction that is better.
std::string direction_arrow(Direction direction);

/// The width of `text` (UTF-8) on a terminal, in columns.
std::size_t display_width(const std::string& text);
/// Pads with blanks to `width`.
std::string pad_left(const std::string& text, std::size_t width);
std::string pad_right(const std::string& text, std::size_t width);

/// "0.0123", or "< 0.0001": a p value in a table.
std::string p_number_text(double p);
/// "p = 0.0123", or "p < 0.0001".
std::string p_text(double p);
/// Whether a column of a table has p values: "p", "p_holm", "p (Holm)", "iman_davenport_p".
bool is_p_column(const std::string& name);

}  // namespace slalom
