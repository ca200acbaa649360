#pragma once

#include <slalom/results/result_table.h>

#include <string>
#include <vector>

namespace slalom {

/// Properties of the columns of a CSV file.
struct CsvColumnOptions {
  std::vector<std::string> up, down;  ///< columns of which more (less) is better
};

/// Reads a table of numbers as runs: CSV (RFC 4180, comma) with a header line. Columns
/// "scenario_hash" or "scenario", "method", "repetition" and "outcome" identify the run of a row;
/// without them each row is a scenario of its own, with method "all". All other numeric columns are
/// metrics; empty fields, "NA" and "nan" are not available; non-numeric columns are ignored. A
/// column that contains only 0 and 1 is a rate. Throws Error (File), with the line if a row has a
/// wrong number of fields, and if there are no rows.
ResultTable columns_from_csv(const std::string& text, const std::string& name,
                             const CsvColumnOptions& options = {});

}  // namespace slalom
