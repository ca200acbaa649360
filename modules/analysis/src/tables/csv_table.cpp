// SPDX-License-Identifier: BSD-3-Clause
#include "csv_table.h"

#include <slalom/analysis/table_export.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {
namespace {

/// Reads records, and counts lines.
class CsvRecords {
 public:
  CsvRecords(const std::string& text, char separator) : text_(text), separator_(separator) {}

  bool at_end() const { return position_ >= text_.size(); }
  std::size_t line() const { return line_; }

  std::vector<std::string> next() {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (; position_ < text_.size(); ++position_) {
      const char c = text_[position_];
      if (quoted && c == '"' && position_ + 1 < text_.size() && text_[position_ + 1] == '"') {
        fields.back() += text_[++position_];
      } else if (c == '"') {
        quoted = !quoted;
      } else if (c == separator_ && !quoted) {
        fields.emplace_back();
      } else if (c == '\n' && !quoted) {
        ++position_;
        ++line_;
        break;
      } else if (c != '\r' || quoted) {
        line_ += c == '\n' ? 1 : 0;
        fields.back() += c;
      }
    }
    return fields;
  }

 private:
  const std::string& text_;
  char separator_;
  std::size_t position_ = 0, line_ = 1;
};

char separator_of(const std::string& text) {
  char best = ',';
  std::size_t most = 0;
  for (const char separator : {',', ';', '\t'}) {
    const std::size_t fields = CsvRecords(text, separator).next().size();
    if (fields > most) best = separator, most = fields;
  }
  return best;
}

/// The text of a field, without the apostrophe that csv_field() adds to formulas.
std::string text_of_field(const std::string& field) {
  const std::string text = trim(field);
  return !text.empty() && text[0] == '\'' && is_formula(text.substr(1)) ? text.substr(1) : text;
}

}  // namespace

CsvTable::CsvTable(const std::string& text, const std::string& name)
    : name_(name), separator_(separator_of(text)) {
  CsvRecords records(text, separator_);
  header_ = records.next();
  for (std::string& id : header_) id = text_of_field(id);
  require_names();
  fields_.resize(header_.size());
  while (!records.at_end()) {
    const std::size_t line = records.line();
    const std::vector<std::string> record = records.next();
    if (record.size() > 1 || !record[0].empty()) add(record, line);
  }
  if (rows() == 0) throw file_error(name_, "no rows", "a header line and rows of numbers");
}

std::string CsvTable::where(std::size_t row) const {
  return name_ + ":" + std::to_string(lines_[row]);
}

void CsvTable::require_names() const {
  double number = 0;
  const auto is_number = [&](const std::string& id) { return parse_number(id, number); };
  const auto is_no_name = [&](const std::string& id) { return id.empty() || is_number(id); };
  if (std::any_of(header_.begin(), header_.end(), is_number) &&
      std::all_of(header_.begin(), header_.end(), is_no_name))
    throw file_error(name_ + ":1", "line 1 has only numbers", "names of columns");
}

void CsvTable::add(const std::vector<std::string>& record, std::size_t line) {
  lines_.push_back(line);
  if (record.size() != header_.size())
    throw file_error(where(rows() - 1), std::to_string(record.size()) + " fields",
                     std::to_string(header_.size()) + " as in the header");
  for (std::size_t i = 0; i < record.size(); ++i) fields_[i].push_back(text_of_field(record[i]));
}

}  // namespace slalom
