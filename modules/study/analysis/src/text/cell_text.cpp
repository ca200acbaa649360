// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/cell_text.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

/// Fixed decimals; very large numbers in shortest form.
std::string number_text(double number, int digits) {
  return std::abs(number) < 1e9 ? format_fixed(number, digits) : format_number(number);
}

}  // namespace

int digits_for(const std::vector<const Cell*>& cells, const Column& column) {
  if (column.info.is_rate()) return 2;
  double largest = 0;
  for (const Cell* cell : cells) {
    if (cell->estimate) largest = std::max(largest, std::abs(*cell->estimate));
  }
  if (largest == 0) return 2;
  return std::clamp(2 - static_cast<int>(std::floor(std::log10(largest))), 0, 4);
}

int column_digits(const CrossTable& table, std::size_t column) {
  std::vector<const Cell*> cells;
  for (const CrossRow& row : table.rows) cells.push_back(&row.cells[column]);
  return digits_for(cells, table.columns[column]);
}

std::string estimate_text(const Cell& cell, int digits) {
  if (cell.median_interval) return "median " + number_text(*cell.median, digits);
  return cell.estimate ? number_text(*cell.estimate, digits) : "-";
}

std::string interval_text(const Cell& cell, int digits) {
  const std::optional<Interval>& interval = stated_interval(cell);
  if (!interval) return "";
  return "[" + number_text(interval->low, digits) + ", " + number_text(interval->high, digits) +
         "]";
}

std::string value_text(const Cell& cell, int digits) {
  const std::string interval = interval_text(cell, digits);
  return estimate_text(cell, digits) + (interval.empty() ? "" : " " + interval);
}

std::string estimate_text(double estimate, const std::optional<Interval>& interval, int digits) {
  std::string text = format_fixed(estimate, digits);
  if (interval)
    text += " [" + format_fixed(interval->low, digits) + ", " +
            format_fixed(interval->high, digits) + "]";
  return text;
}

const std::optional<Interval>& stated_interval(const Cell& cell) {
  return cell.median_interval ? cell.median_interval : cell.interval;
}

std::string support_text(const Cell& cell, const Column& column, int digits) {
  std::string text;
  if (column.info.is_rate() && cell.estimate) {
    const double successes = *cell.estimate * static_cast<double>(cell.available);
    text = std::to_string(std::llround(successes)) + "/" + std::to_string(cell.available);
    const std::size_t missing = cell.n - cell.available;
    return missing == 0 ? text : text + " NA=" + std::to_string(missing);
  }
  if (cell.median_interval) text = "mean " + number_text(*cell.estimate, digits) + " ";
  if (cell.deviation) text += "±" + number_text(*cell.deviation, digits) + " ";
  return text + values_text(cell);
}

std::string values_text(const Cell& cell) {
  const std::string text = "n = " + std::to_string(cell.available);
  return cell.available == cell.n ? text : text + " of " + std::to_string(cell.n);
}

std::string na_text(const Column& column, const std::map<std::string, std::size_t>& reasons) {
  std::vector<std::string> parts;
  for (const auto& [reason, n] : reasons) parts.push_back(std::to_string(n) + " " + reason);
  return parts.empty() ? "" : column.info.id + ": " + join(parts, ", ");
}

std::map<std::string, std::size_t> na_of_column(const CrossTable& table, std::size_t column) {
  std::map<std::string, std::size_t> reasons;
  for (const CrossRow& row : table.rows) {
    for (const auto& [reason, n] : row.cells[column].na) reasons[reason] += n;
  }
  return reasons;
}

std::string percent_text(double fraction) {
  return format_number(std::round(fraction * 1e12) / 1e10);
}

std::string share_text(double fraction) {
  constexpr int kMostDigits = 4;  // more are the rounding of a mean
  for (int digits = 0; digits <= kMostDigits; ++digits) {
    const double scale = 100 * std::pow(10, digits);
    const double shown = std::round(fraction * scale) / scale;
    if (shown > 0 && shown < 1) return format_fixed(100 * fraction, digits);
  }
  return format_fixed(100 * fraction, 0);
}

std::string direction_arrow(Direction direction) {
  if (direction == Direction::Up) return "↑";
  return direction == Direction::Down ? "↓" : "";
}

std::size_t display_width(const std::string& text) {
  const auto starts_character = [](unsigned char c) { return (c & 0xC0u) != 0x80u; };
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), starts_character));
}

std::string pad_left(const std::string& text, std::size_t width) {
  const std::size_t used = display_width(text);
  return std::string(used < width ? width - used : 0, ' ') + text;
}

std::string pad_right(const std::string& text, std::size_t width) {
  const std::size_t used = display_width(text);
  return text + std::string(used < width ? width - used : 0, ' ');
}

std::string p_number_text(double p) {
  return p < 0.0001 ? "< 0.0001" : format_fixed(p, 4);
}

std::string p_text(double p) {
  return p < 0.0001 ? "p " + p_number_text(p) : "p = " + p_number_text(p);
}

bool is_p_column(const std::string& name) {
  return name == "p" || name == "p_holm" || name == "p (Holm)" || name == "iman_davenport_p";
}

}  // namespace slalom
