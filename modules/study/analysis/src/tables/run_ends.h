// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "csv_table.h"

#include <slalom/analysis/csv_columns.h>

#include <string>
#include <vector>

namespace slalom {

/// Takes from rates such as "collided", and from "success", how runs ended where the column of
/// outcomes does not say it; adds "success" if it is known. Returns what was taken. Throws Error
/// (File), with the line, for columns of a run that contradict each other.
std::vector<std::string> complete_outcomes(ResultTable& table, const CsvTable& csv,
                                           bool has_outcomes);

/// Makes times, lengths and the like NA in runs that failed; `unconditional` gets their values.
/// Returns the ids of these columns.
std::vector<std::string> make_conditional(ResultTable& table, const CsvColumnOptions& options);

}  // namespace slalom
