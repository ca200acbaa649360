// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace slalom {

/// The fields of CSV files by columns, trimmed and without quotes.
class CsvTable {
 public:
  /// Detects the separator: the most frequent of comma, semicolon and tab in the first line, or
  /// blanks if that has none of them. With `names` of its columns, the table has no header line.
  CsvTable(const std::string& content, const std::string& name,
           const std::vector<std::string>& names);

  /// The rows of several tables, one after another. A field of a column that a table does not have
  /// is empty.
  explicit CsvTable(const std::vector<CsvTable>& tables);

  const std::string& name() const { return name_; }  ///< of the file, or of all with commas
  std::size_t rows() const { return places_.size(); }
  char separator(std::size_t row) const { return files_[places_[row].file].separator; }
  bool has_blanks() const;  ///< as separators, any number of them
  const std::vector<std::string>& header() const { return header_; }
  const std::vector<std::string>& column(std::size_t i) const { return fields_[i]; }

  /// FILE:LINE of a row.
  std::string where(std::size_t row) const;
  /// The same, or "line LINE" where there is one file.
  std::string short_where(std::size_t row) const;
  /// Adds a column with that text in every row.
  void add_column(const std::string& id, const std::string& text);

 private:
  /// The number of the file that has a row, and its line there.
  struct Place {
    std::size_t file, line;
  };

  struct File {
    std::string name;
    char separator = ',';  ///< a blank for any number of blanks
  };

  std::string name_;
  std::vector<File> files_;
  std::vector<std::string> header_;
  bool has_header_;
  std::size_t first_line_ = 1;
  std::vector<std::vector<std::string>> fields_;
  std::vector<Place> places_;

  std::string where_of_header() const;
  void read_header(const std::vector<std::string>& record);
  void refuse_duplicate_names() const;
  void add(const std::vector<std::string>& record, std::size_t line);
};

}  // namespace slalom
