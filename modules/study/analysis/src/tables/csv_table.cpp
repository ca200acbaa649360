// SPDX-License-Identifier: BSD-3-Clause
#include "csv_table.h"

#include <slalom/analysis/table_export.h>
#include <slalom/core/error.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <set>

namespace slalom {
namespace {

constexpr char kBlanks = ' ';  // the separator of fields with any number of blanks between them

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
      } else if (is_separator(c) && !quoted) {
        if (separator_ != kBlanks || !fields.back().empty()) fields.emplace_back();
      } else if (c == '\n' && !quoted) {
        ++position_;
        ++line_;
        break;
      } else if (c != '\r' || quoted) {
        line_ += c == '\n' ? 1 : 0;
        fields.back() += c;
      }
    }
    if (separator_ == kBlanks && fields.size() > 1 && fields.back().empty()) fields.pop_back();
    return fields;
  }

 private:
  const std::string& text_;
  char separator_;
  std::size_t position_ = 0, line_ = 1;

  bool is_separator(char c) const {
    return c == separator_ || (separator_ == kBlanks && c == '\t');
  }
};

bool is_blank(const std::vector<std::string>& record) {
  return record.size() == 1 && trim(record[0]).empty();
}

/// Whether blanks separate fields: the first two lines have the same number of words, as one name
/// with blanks in it and its numbers do not.
bool has_columns_of_words(const std::string& text) {
  CsvRecords records(text, kBlanks);
  const std::size_t words = records.next().size();
  std::vector<std::string> second(1);
  while (is_blank(second) && !records.at_end()) second = records.next();
  return words > 1 && second.size() == words;
}

/// The separator that gives the first line `columns` fields, if they are known, else the most.
char separator_of(const std::string& text, std::size_t columns) {
  char best = ',';
  std::size_t most = 0;
  for (const char separator : {',', ';', '\t', kBlanks}) {
    const std::size_t fields = CsvRecords(text, separator).next().size();
    if (fields == columns) return separator;
    if (separator != kBlanks && fields > most) best = separator, most = fields;
  }
  return most == 1 && has_columns_of_words(text) ? kBlanks : best;
}

/// The text from the header line on, without empty lines, Excel's line "sep=;" and the mark of a
/// comment before it.
std::string from_header(const std::string& text) {
  std::size_t begin = text.find_first_not_of("\r\n");
  if (begin < text.size() && text.compare(begin, 4, "sep=") == 0 && begin + 6 <= text.size() &&
      (text[begin + 5] == '\n' || text[begin + 5] == '\r'))
    begin = text.find_first_not_of("\r\n", begin + 5);
  if (begin < text.size() && text[begin] == '#') begin = text.find_first_not_of("# \t", begin);
  return text.substr(std::min(begin, text.size()));
}

/// The number, from 1, of the line in which the last `size` bytes of a text begin.
std::size_t line_of(const std::string& text, std::size_t size) {
  const auto end = text.end() - static_cast<std::ptrdiff_t>(size);
  return static_cast<std::size_t>(std::count(text.begin(), end, '\n')) + 1;
}

/// The text of a field, without the apostrophe that csv_field() adds to formulas.
std::string text_of_field(const std::string& field) {
  const std::string text = trim(field);
  return !text.empty() && text[0] == '\'' && is_formula(text.substr(1)) ? text.substr(1) : text;
}

}  // namespace

CsvTable::CsvTable(const std::string& content, const std::string& name,
                   const std::vector<std::string>& names)
    : name_(name), header_(names), has_header_(names.empty()) {
  const std::string text = has_header_ ? from_header(content) : content;
  first_line_ = line_of(content, text.size());
  files_ = {{name, separator_of(text, header_.size())}};
  CsvRecords records(text, files_[0].separator);
  if (has_header_) read_header(records.next());
  refuse_duplicate_names();
  fields_.resize(header_.size());
  while (!records.at_end()) {
    const std::size_t line = first_line_ + records.line() - 1;
    const std::vector<std::string> record = records.next();
    if (!is_blank(record)) add(record, line);
  }
  if (rows() == 0) throw file_error(name_, "no rows", "a header line and rows of numbers");
}

CsvTable::CsvTable(const std::vector<CsvTable>& tables) : has_header_(true) {
  for (const CsvTable& table : tables) {
    for (const std::string& id : table.header_)
      if (!contains(header_, id)) header_.push_back(id);
    for (const Place& place : table.places_)
      places_.push_back({files_.size() + place.file, place.line});
    files_.insert(files_.end(), table.files_.begin(), table.files_.end());
  }
  for (const File& file : files_) name_ += (name_.empty() ? "" : ", ") + file.name;
  for (const std::string& id : header_) {
    std::vector<std::string>& fields = fields_.emplace_back();
    for (const CsvTable& table : tables) {
      const auto found = std::find(table.header_.begin(), table.header_.end(), id);
      const auto i = static_cast<std::size_t>(found - table.header_.begin());
      if (found == table.header_.end())
        fields.insert(fields.end(), table.rows(), "");
      else
        fields.insert(fields.end(), table.fields_[i].begin(), table.fields_[i].end());
    }
  }
}

std::string CsvTable::where(std::size_t row) const {
  return files_[places_[row].file].name + ":" + std::to_string(places_[row].line);
}

std::string CsvTable::short_where(std::size_t row) const {
  return files_.size() > 1 ? where(row) : "line " + std::to_string(places_[row].line);
}

std::string CsvTable::where_of_header() const {
  return name_ + ":" + std::to_string(first_line_);
}

bool CsvTable::has_blanks() const {
  return std::any_of(files_.begin(), files_.end(),
                     [](const File& file) { return file.separator == kBlanks; });
}

void CsvTable::add_column(const std::string& id, const std::string& text) {
  header_.push_back(id);
  fields_.emplace_back(rows(), text);
}

void CsvTable::read_header(const std::vector<std::string>& record) {
  for (const std::string& id : record) header_.push_back(text_of_field(id));
  double number = 0;
  const auto is_number = [&](const std::string& id) { return parse_number(id, number); };
  const auto is_no_name = [&](const std::string& id) { return id.empty() || is_number(id); };
  if (std::any_of(header_.begin(), header_.end(), is_number) &&
      std::all_of(header_.begin(), header_.end(), is_no_name))
    throw file_error(where_of_header(), "the first line has only numbers",
                     "names of columns; for a table without them --names NAME,... with " +
                         count_text(header_.size(), "name"));
}

void CsvTable::refuse_duplicate_names() const {
  std::set<std::string> names;
  for (const std::string& id : header_)
    if (!id.empty() && !names.insert(id).second)
      throw file_error(has_header_ ? where_of_header() : "--names",
                       "duplicate column '" + printable_line(id) + "'", "each name once");
}

void CsvTable::add(const std::vector<std::string>& record, std::size_t line) {
  places_.push_back({0, line});
  if (record.size() != header_.size())
    throw file_error(
        where(rows() - 1), count_text(record.size(), "field"),
        std::to_string(header_.size()) + (has_header_ ? " as in the header" : " as in --names"));
  for (std::size_t i = 0; i < record.size(); ++i) fields_[i].push_back(text_of_field(record[i]));
}

}  // namespace slalom
