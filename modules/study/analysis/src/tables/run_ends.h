// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "csv_table.h"

#include <slalom/analysis/csv_columns.h>

#include <string>
#include <vector>

namespace slalom {

/// Whether a column of 0 and 1 with this name says how runs ended.
bool is_end_name(const std::string& name);

/// Takes from rates such as "collided", from counts such as "collisions", and from "success", how
/// runs ended where the column of outcomes does not say it; adds "success" if it is known. Returns
/// what was taken. Throws Error (File), with the line, for columns of a run that contradict each
/// other, such as a score above 0 of a failure.
std::vector<std::string> complete_outcomes(ResultTable& table, const CsvTable& csv,
                                           bool has_outcomes, const CsvColumnOptions& options);

/// Makes times, lengths and the like NA in runs that did not succeed or, in a table that knows
/// successes, whose end is not known; `unconditional` gets their values. Returns notes about these
/// columns, and about those that count in such runs. `is_export`: ids of known columns mean what
/// they do in Slalom.
std::vector<std::string> make_conditional(ResultTable& table, const CsvTable& csv, bool is_export,
                                          const CsvColumnOptions& options);

}  // namespace slalom
