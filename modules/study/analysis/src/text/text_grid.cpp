// SPDX-License-Identifier: BSD-3-Clause
#include "text_grid.h"

#include <slalom/analysis/cell_text.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr const char* kGap = "  ";

std::string without_trailing_blanks(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

}  // namespace

std::size_t TextGrid::width(std::size_t column) const {
  std::size_t widest = display_width(header_[column]);
  for (const auto& row : rows_) {
    for (const std::string& line : row[column]) widest = std::max(widest, display_width(line));
  }
  return widest;
}

std::string TextGrid::padded(const std::string& text, std::size_t column) const {
  return right_ && column > 0 ? pad_left(text, width(column)) : pad_right(text, width(column));
}

std::string TextGrid::row_text(const std::vector<Lines>& row,
                               const std::vector<std::size_t>& block) const {
  std::size_t height = 0;
  for (const std::size_t column : block) height = std::max(height, row[column].size());
  std::string text;
  for (std::size_t line = 0; line < height; ++line) {
    std::string joined;
    for (const std::size_t column : block) {
      const bool has_line = line < row[column].size();
      joined += padded(has_line ? row[column][line] : "", column) + kGap;
    }
    text += without_trailing_blanks(joined) + "\n";
  }
  return text;
}

std::string TextGrid::block_text(const std::vector<std::size_t>& block) const {
  std::vector<Lines> header, rule;
  for (std::size_t column = 0; column < header_.size(); ++column) {
    header.push_back({header_[column]});
    std::string line;
    for (std::size_t i = 0; i < width(column); ++i) line += "─";
    rule.push_back({line});
  }
  std::string text = row_text(header, block) + row_text(rule, block);
  for (const auto& row : rows_) text += row_text(row, block);
  return text;
}

std::string TextGrid::text(std::size_t max_width) const {
  std::string result;
  std::vector<std::size_t> block = {0};
  std::size_t used = width(0);
  for (std::size_t column = 1; column < header_.size(); ++column) {
    const std::size_t needed = width(column) + 2;
    if (used + needed > max_width && block.size() > 1) {
      result += block_text(block) + "\n";
      block = {0};
      used = width(0);
    }
    block.push_back(column);
    used += needed;
  }
  return result + block_text(block);
}

}  // namespace slalom
