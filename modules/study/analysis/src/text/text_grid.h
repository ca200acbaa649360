// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace slalom {

/// Formats texts in aligned columns. A grid that is too wide is split into blocks, each beginning
/// with the first column.
class TextGrid {
 public:
  using Lines = std::vector<std::string>;  ///< of one cell

  explicit TextGrid(std::vector<std::string> header) : header_(std::move(header)) {}
  void align_right() { right_ = true; }  ///< all columns but the first
  void add_row(std::vector<Lines> cells) { rows_.push_back(std::move(cells)); }
  std::string text(std::size_t max_width = 120) const;

 private:
  std::vector<std::string> header_;
  std::vector<std::vector<Lines>> rows_;
  bool right_ = false;

  std::size_t width(std::size_t column) const;
  std::string padded(const std::string& text, std::size_t column) const;
  std::string row_text(const std::vector<Lines>& row, const std::vector<std::size_t>& block) const;
  std::string block_text(const std::vector<std::size_t>& block) const;
};

}  // namespace slalom
