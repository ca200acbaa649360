// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/quiet_standard_error.h>
#include <slalom/core/temporary_file.h>
#include <slalom/core/text.h>
#include <slalom/spreadsheet/workbook.h>

#include <set>
#include <xlsxwriter.h>

namespace slalom {
namespace {

constexpr std::size_t kMaxRows = 1048576, kMaxColumns = 16384, kMaxText = 32767;
constexpr std::size_t kMaxSheetName = 31;

/// Cell formats, created once per workbook.
struct Formats {
  lxw_format* header;
  lxw_format* number;
  lxw_format* count;

  explicit Formats(lxw_workbook* book)
      : header(workbook_add_format(book)),
        number(workbook_add_format(book)),
        count(workbook_add_format(book)) {
    format_set_bold(header);
    format_set_bottom(header, LXW_BORDER_THIN);
    format_set_num_format(number, "0.0000");
    format_set_num_format(count, "0");
  }
};

/// A valid sheet name, unique ignoring case.
std::string sheet_name(const std::string& requested, std::set<std::string>& used) {
  std::string base = requested.empty() ? "table" : requested;
  for (char& c : base) {
    if (std::string("[]:*?/\\'").find(c) != std::string::npos ||
        static_cast<unsigned char>(c) < ' ')
      c = '_';
  }
  for (int number = 1;; ++number) {
    const std::string end = number == 1 ? "" : "_" + std::to_string(number);
    const std::string name = base.substr(0, kMaxSheetName - end.size()) + end;
    if (used.insert(lower_case(name)).second) return name;
  }
}

/// A double holds whole numbers exactly only up to 2^53; larger ones, such as seeds, are texts.
template <typename Integer>
void write_integer(lxw_worksheet* sheet, lxw_row_t row, lxw_col_t column, Integer number,
                   const Formats& formats) {
  constexpr double kExact = 9007199254740992;
  const auto rounded = static_cast<double>(number);
  if (rounded > -kExact && rounded < kExact)
    worksheet_write_number(sheet, row, column, rounded, formats.count);
  else
    worksheet_write_string(sheet, row, column, std::to_string(number).c_str(), nullptr);
}

void write_field(lxw_worksheet* sheet, lxw_row_t row, lxw_col_t column, const Field& field,
                 const Formats& formats) {
  if (const auto* number = std::get_if<double>(&field)) {
    worksheet_write_number(sheet, row, column, *number, formats.number);
  } else if (const auto* count = std::get_if<std::int64_t>(&field)) {
    write_integer(sheet, row, column, *count, formats);
  } else if (const auto* seed = std::get_if<std::uint64_t>(&field)) {
    write_integer(sheet, row, column, *seed, formats);
  } else if (const auto* text = std::get_if<std::string>(&field)) {
    worksheet_write_string(sheet, row, column, text->substr(0, kMaxText).c_str(), nullptr);
  }
}

void write_sheet(lxw_workbook* book, const DataTable& table, const std::string& name,
                 const Formats& formats) {
  lxw_worksheet* sheet = workbook_add_worksheet(book, name.c_str());
  const auto columns = static_cast<lxw_col_t>(table.columns.size());
  const auto rows = static_cast<lxw_row_t>(table.rows);
  for (lxw_col_t column = 0; column < columns; ++column)
    worksheet_write_string(sheet, 0, column, table.columns[column].c_str(), formats.header);
  for (lxw_row_t row = 0; row < rows; ++row) {
    for (lxw_col_t column = 0; column < columns; ++column)
      write_field(sheet, row + 1, column, table.at(row, column), formats);
  }
  if (columns == 0) return;
  worksheet_freeze_panes(sheet, 1, 0);
  worksheet_autofilter(sheet, 0, 0, rows, static_cast<lxw_col_t>(columns - 1));
  worksheet_set_column(sheet, 0, static_cast<lxw_col_t>(columns - 1), 14, nullptr);
}

void check_size(const DataTable& table) {
  if (table.rows >= kMaxRows || table.columns.size() > kMaxColumns)
    throw usage_error("table '" + table.name + "'",
                      "has " + std::to_string(table.rows) + " rows and " +
                          std::to_string(table.columns.size()) + " columns, too many for .xlsx",
                      "at most 1048575 rows and 16384 columns; csv has no limit");
}

/// The library prints errors of writing, too.
lxw_error close_quietly(lxw_workbook* book) {
  const QuietStandardError quiet;
  return workbook_close(book);
}

}  // namespace

void write_workbook(const std::vector<DataTable>& tables, const std::string& path) {
  for (const DataTable& table : tables) check_size(table);
  TemporaryFile temporary(path);
  lxw_workbook_options options = {};
  options.constant_memory = LXW_TRUE;
  lxw_workbook* book = workbook_new_opt(temporary.name().c_str(), &options);
  if (!book) throw job_error(path, "cannot be written: out of memory");
  const Formats formats(book);
  std::set<std::string> used;
  for (const DataTable& table : tables)
    write_sheet(book, table, sheet_name(table.name, used), formats);
  const lxw_error error = close_quietly(book);
  if (error != LXW_NO_ERROR)
    throw job_error(path, std::string("cannot be written: ") + lxw_strerror(error));
  temporary.publish();
}

}  // namespace slalom
