// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace slalom {

/// The fields of a CSV file by columns, trimmed and without quotes.
class CsvTable {
 public:
  /// Detects the separator: the most frequent of comma, semicolon and tab in the first line, or
  /// blanks if that has none of them. With `names` of its columns, the table has no header line.
  CsvTable(const std::string& content, const std::string& name,
           const std::vector<std::string>& names);

  const std::string& name() const { return name_; }  ///< of the file
  std::size_t rows() const { return lines_.size(); }
  std::size_t line(std::size_t row) const { return lines_[row]; }  ///< in the file
  char separator() const { return separator_; }  ///< a blank for any number of blanks
  const std::vector<std::string>& header() const { return header_; }
  const std::vector<std::string>& column(std::size_t i) const { return fields_[i]; }

  /// FILE:LINE of a row.
  std::string where(std::size_t row) const;

 private:
  std::string name_;
  char separator_ = ',';
  std::vector<std::string> header_;
  bool has_header_;
  std::vector<std::vector<std::string>> fields_;
  std::vector<std::size_t> lines_;

  void read_header(const std::vector<std::string>& record);
  void refuse_duplicate_names() const;
  void add(const std::vector<std::string>& record, std::size_t line);
};

}  // namespace slalom
