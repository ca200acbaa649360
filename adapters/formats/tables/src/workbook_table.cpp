// SPDX-License-Identifier: BSD-3-Clause
#include "foreign_table.h"

#include <slalom/analysis/table_export.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/xml/xml_file.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <unzip.h>
#include <utility>

namespace slalom {
namespace {

using tinyxml2::XMLElement;

constexpr const char* kExpected = "a workbook (.xlsx)";
constexpr std::size_t kMaxColumns = 16384, kMaxRows = 1048576;  // those of Excel

/// The parts of a workbook, a zip archive.
class Package {
 public:
  explicit Package(const std::string& path) : path_(path), zip_(unzOpen64(path.c_str())) {
    if (zip_ == nullptr) throw file_error(path, "is not a zip archive or is damaged", kExpected);
  }
  ~Package() { unzClose(zip_); }
  Package(const Package&) = delete;
  Package& operator=(const Package&) = delete;

  bool has(const std::string& part) const { return unzLocateFile(zip_, part.c_str(), 1) == UNZ_OK; }

  XmlFile read(const std::string& part) const {
    const std::string where = path_ + ": " + part;
    unz_file_info64 info;
    if (!has(part) ||
        unzGetCurrentFileInfo64(zip_, &info, nullptr, 0, nullptr, 0, nullptr, 0) != UNZ_OK)
      throw file_error(where, "is missing", kExpected);
    if (info.uncompressed_size > kMaxXmlSize)
      throw file_error(where, "is larger than 64 MB", "a table of that size as CSV");
    std::string text(info.uncompressed_size, '\0');
    int length = -1;
    if (unzOpenCurrentFile(zip_) == UNZ_OK) {
      length = unzReadCurrentFile(zip_, text.data(), static_cast<unsigned>(text.size()));
      if (unzCloseCurrentFile(zip_) != UNZ_OK) length = -1;  // the checksum
    }
    if (length < 0 || static_cast<std::size_t>(length) != text.size())
      throw file_error(where, "is damaged", kExpected);
    return XmlFile::parse(text, where);
  }

 private:
  std::string path_;
  unzFile zip_;
};

/// The name without the prefix of a namespace, which some programs write.
const char* local_name(const char* name) {
  const char* colon = std::strrchr(name, ':');
  return colon == nullptr ? name : colon + 1;
}

std::vector<const XMLElement*> parts_of(const XMLElement& parent, const char* name) {
  std::vector<const XMLElement*> found;
  for (auto e = parent.FirstChildElement(); e != nullptr; e = e->NextSiblingElement())
    if (std::strcmp(local_name(e->Name()), name) == 0) found.push_back(e);
  return found;
}

/// The texts of all elements <t> in the order of the document: a text may be of several runs.
std::string text_in(const XMLElement& element) {
  std::string text;
  for (auto e = element.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
    const char* name = local_name(e->Name());
    if (std::strcmp(name, "t") == 0 && e->GetText() != nullptr) text += e->GetText();
    if (std::strcmp(name, "r") == 0) text += text_in(*e);
  }
  return text;
}

std::vector<std::string> shared_texts(const Package& package) {
  std::vector<std::string> texts;
  if (!package.has("xl/sharedStrings.xml")) return texts;
  const XmlFile file = package.read("xl/sharedStrings.xml");
  for (const XMLElement* element : parts_of(file.root(), "si")) texts.push_back(text_in(*element));
  return texts;
}

/// The parts of the sheets of a workbook by name, in their order.
std::vector<std::pair<std::string, std::string>> sheets_of(const Package& package) {
  std::map<std::string, std::string> targets;
  const XmlFile relations = package.read("xl/_rels/workbook.xml.rels");
  for (const XMLElement* relation : parts_of(relations.root(), "Relationship")) {
    const std::string target = xml_attribute(*relation, "Target");
    targets[xml_attribute(*relation, "Id")] =
        starts_with(target, "/") ? target.substr(1) : "xl/" + target;
  }
  std::vector<std::pair<std::string, std::string>> sheets;
  const XmlFile workbook = package.read("xl/workbook.xml");
  for (const XMLElement* list : parts_of(workbook.root(), "sheets"))
    for (const XMLElement* sheet : parts_of(*list, "sheet"))
      for (auto a = sheet->FirstAttribute(); a != nullptr; a = a->Next())
        if (std::strcmp(a->Name(), "id") != 0 && std::strcmp(local_name(a->Name()), "id") == 0)
          sheets.emplace_back(xml_attribute(*sheet, "name"), targets[a->Value()]);
  return sheets;
}

/// Whether a format shows a number, a fraction of a day, as a time: "h:mm:ss", not a date.
bool shows_time(const std::string& format) {
  return format.find(':') != std::string::npos && format.find_first_of("yd") == std::string::npos;
}

/// The numbers of the styles of cells that show times.
std::set<std::string> styles_of_times(const Package& package) {
  std::set<std::string> formats = {"18", "19", "20", "21", "45", "46", "47"}, styles;
  if (!package.has("xl/styles.xml")) return styles;
  const XmlFile file = package.read("xl/styles.xml");
  for (const XMLElement* list : parts_of(file.root(), "numFmts"))
    for (const XMLElement* format : parts_of(*list, "numFmt"))
      if (shows_time(lower_case(xml_attribute(*format, "formatCode"))))
        formats.insert(xml_attribute(*format, "numFmtId"));
  for (const XMLElement* list : parts_of(file.root(), "cellXfs")) {
    std::size_t style = 0;
    for (const XMLElement* cell : parts_of(*list, "xf")) {
      if (formats.count(xml_attribute(*cell, "numFmtId")) > 0) styles.insert(std::to_string(style));
      ++style;
    }
  }
  return styles;
}

/// The fields of a sheet.
class Sheet {
 public:
  /// Numbers of cells with one of the styles `times` are read as seconds.
  Sheet(const XmlFile& file, const std::vector<std::string>& texts,
        const std::set<std::string>& times)
      : file_(file), texts_(texts), times_(times) {
    for (const XMLElement* data : parts_of(file.root(), "sheetData"))
      for (const XMLElement* row : parts_of(*data, "row")) read_row(*row);
  }

  bool empty() const { return rows_.empty(); }

  std::string csv() const {
    std::string text;
    std::size_t line = 0;
    for (const auto& [row, fields] : rows_) {
      text.append(row - line, '\n');  // a row is on the line of its number
      line = row + 1;
      std::vector<std::string> all = fields;
      all.resize(columns_);
      text += csv_line(all);
    }
    return text;
  }

 private:
  const XmlFile& file_;
  const std::vector<std::string>& texts_;
  const std::set<std::string>& times_;
  std::vector<std::pair<std::size_t, std::vector<std::string>>> rows_;  // by number from 0
  std::size_t columns_ = 0, next_row_ = 0;

  void read_row(const XMLElement& element) {
    const std::size_t row = row_of(element);
    std::vector<std::string> fields;
    std::size_t next = 0;
    for (const XMLElement* cell : parts_of(element, "c")) {
      const std::size_t column = column_of(*cell, next);
      std::string text = text_of(*cell);
      std::replace(text.begin(), text.end(), '\n', ' ');  // a row remains a line
      next = column + 1;
      if (text.empty()) continue;
      fields.resize(next);
      fields[column] = text;
    }
    next_row_ = row + 1;
    if (fields.empty()) return;
    columns_ = std::max(columns_, fields.size());
    rows_.emplace_back(row, std::move(fields));
    if (columns_ * rows_.size() > kMaxFields)
      throw file_.error(element, "more than " + std::to_string(kMaxFields) + " fields",
                        "a table of that size as CSV");
  }

  std::size_t row_of(const XMLElement& element) const {
    const std::string text = xml_attribute(element, "r");
    long long row = static_cast<long long>(next_row_) + 1;
    if ((!text.empty() && !parse_integer(text, row)) || row <= static_cast<long long>(next_row_) ||
        row > static_cast<long long>(kMaxRows))
      throw file_.error(element, "row '" + text + "'", "rows in their order");
    return static_cast<std::size_t>(row) - 1;
  }

  /// The column of a reference such as AB12; without one, the next.
  std::size_t column_of(const XMLElement& cell, std::size_t next) const {
    const std::string reference = xml_attribute(cell, "r");
    std::size_t column = reference.empty() ? next + 1 : 0;
    for (const char c : reference) {
      if (c < 'A' || c > 'Z' || column > kMaxColumns) break;
      column = column * 26 + static_cast<std::size_t>(c - 'A') + 1;
    }
    if (column <= next || column > kMaxColumns)
      throw file_.error(cell, "cell '" + reference + "'", "cells in their order");
    return column - 1;
  }

  std::string text_of(const XMLElement& cell) const {
    const std::string type = xml_attribute(cell, "t");
    if (type == "inlineStr") {
      const auto texts = parts_of(cell, "is");
      return texts.empty() ? "" : text_in(*texts[0]);
    }
    const auto values = parts_of(cell, "v");
    const std::string value = values.empty() ? "" : xml_text(values[0]);
    if (type == "e") return "NA";  // of a formula, such as #DIV/0!
    constexpr double kSecondsPerDay = 86400;
    double days = 0;
    if ((type.empty() || type == "n") && times_.count(xml_attribute(cell, "s")) > 0 &&
        parse_number(value, days))
      return format_number(std::round(days * kSecondsPerDay * 1e6) / 1e6);
    if (type != "s" || value.empty()) return value;
    long long index = -1;
    if (!parse_integer(value, index) || index < 0 || index >= static_cast<long long>(texts_.size()))
      throw file_.error(cell, "shared text '" + value + "'",
                        "less than " + std::to_string(texts_.size()));
    return texts_[static_cast<std::size_t>(index)];
  }
};

}  // namespace

ForeignTable table_from_workbook(const std::string& path, const std::string& sheet) {
  const Package package(path);
  const std::vector<std::string> texts = shared_texts(package);
  const std::set<std::string> times = styles_of_times(package);
  std::vector<std::string> names;
  std::string csv;
  for (const auto& [name, part] : sheets_of(package)) {
    if (!sheet.empty() && name != sheet) {
      names.push_back(name);
      continue;
    }
    const XmlFile file = package.read(part);
    const Sheet fields(file, texts, times);
    if (fields.empty() && sheet.empty()) continue;
    csv = fields.csv();
    if (!sheet.empty()) return {csv};
    names.push_back(name);
  }
  if (!sheet.empty()) throw usage_error("--sheet", "'" + sheet + "'", expected_name(sheet, names));
  if (names.size() > 1)
    throw file_error(path, "has tables in " + count_text(names.size(), "sheet"),
                     "--sheet with one of " + join(names, ", ").substr(0, 1000));
  if (names.empty()) throw file_error(path, "has no cells", "a header line and rows of numbers");
  return {csv};
}

}  // namespace slalom
