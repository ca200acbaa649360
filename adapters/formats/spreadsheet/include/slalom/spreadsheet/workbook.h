// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/data_table.h>

#include <string>
#include <vector>

namespace slalom {

/// Writes an .xlsx workbook, one sheet per table: a bold, frozen header row with filters, numbers
/// as numbers, counts without decimals, texts as texts (never formulas), empty fields as empty
/// cells. Sheets are named after their tables, shortened and numbered if necessary. The same tables
/// give the same sheets. Memory does not grow with the rows. Throws Error (Usage) for a table that
/// exceeds the limits of the format (1,048,576 rows x 16,384 columns), Error (Job) if it cannot be
/// written; `path` is then unchanged.
void write_workbook(const std::vector<DataTable>& tables, const std::string& path);

}  // namespace slalom
