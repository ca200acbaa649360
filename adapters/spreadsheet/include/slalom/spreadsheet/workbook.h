#pragma once

#include <slalom/analysis/data_table.h>

#include <string>
#include <vector>

namespace slalom {

/// Writes an .xlsx workbook, one sheet per table: a bold first row that stays in view and can be
/// filtered by, numbers as numbers, counts without decimals, texts as texts (never formulas), empty
/// fields empty. Sheets are named after their tables, shortened and numbered where the format asks
/// for it. The same tables give the same sheets. Memory does not grow with the rows. Throws Error
/// (Usage) for a table that has more rows or columns than the format holds (1,048,576 x 16,384),
/// Error (Job) when it cannot be written; `path` is whole or as it was.
void write_workbook(const std::vector<DataTable>& tables, const std::string& path);

}  // namespace slalom
