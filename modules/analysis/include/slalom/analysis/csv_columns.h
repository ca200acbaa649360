#pragma once

#include <slalom/results/run_columns.h>

#include <string>
#include <vector>

namespace slalom {

/// What is known of a CSV's columns.
struct CsvColumnOptions {
  std::vector<std::string> up, down;  ///< columns of which more (less) is better
};

/// Any table of numbers as runs: CSV (RFC 4180, comma) with a header line. Columns "scenario_hash"
/// or "scenario", "method", "repetition" and "outcome" say what a row belongs to; without them each
/// row is a scenario of its own under the one method "all". All other columns that hold numbers are
/// metrics; empty fields, "NA" and "nan" are not available; columns with other texts are left out.
/// A column that holds only 0 and 1 is a rate. Throws Error (File) with the line where a row has
/// too many or too few fields, or there is none.
RunColumns columns_from_csv(const std::string& text, const std::string& name,
                            const CsvColumnOptions& options = {});

}  // namespace slalom
