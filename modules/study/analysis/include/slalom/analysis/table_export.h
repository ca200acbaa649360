// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cross_table.h>

#include <string>
#include <vector>

namespace slalom {

/// Cross tables in long form, one line per cell (RFC 4180 quoting, lines end with LF):
/// method,row_descriptor,bin_low,bin_high,metric,version,n,available,na,mean,deviation,low,high,
/// confidence,na_reasons. Fields without a value are empty; numbers are exact.
std::string render_csv(const std::vector<CrossTable>& tables);

/// The same as a JSON array of tables, with the ids of the runs of each row and NA counts by
/// reason.
std::string render_json(const std::vector<CrossTable>& tables);

/// Whether spreadsheets would take a field of a CSV line for a formula: more than one character,
/// the first of which is = + - @ or a tab, unless it is a number.
bool is_formula(const std::string& text);

/// A field of a CSV line, quoted if necessary. A formula is preceded by an apostrophe.
std::string csv_field(const std::string& text);

/// A line of CSV with these fields.
std::string csv_line(const std::vector<std::string>& fields);

}  // namespace slalom
