#pragma once

#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/summary.h>
#include <slalom/results/run_record.h>

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace slalom {

/// What stands in one field of a table: nothing, a number, a count or a text.
using Field = std::variant<std::monostate, double, std::int64_t, std::string>;

/// A table as spreadsheets and databases know it: named columns, one kind of value each. Rows are
/// made when they are asked for, so that a million runs need no second copy. It refers to the
/// results that it was made from: they must outlive it.
struct DataTable {
  std::string name;                  ///< "runs": of the file or sheet
  std::string title;                 ///< for people
  std::vector<std::string> columns;  ///< ids
  std::size_t rows = 0;
  std::function<Field(std::size_t row, std::size_t column)> at;
};

/// One row per run: scenario, method, repetition, seed, outcome, every metric (empty where it is
/// not available) with the reasons beside it ("safety: collision; spl: ..."), every descriptor of
/// its scenario.
DataTable runs_table(const ResultTable& table);

/// One row per scenario with its descriptors.
DataTable scenarios_table(const ResultTable& table);

/// The wall-clock figures, one row per run: apart from the rest, for they differ every time.
DataTable timings_table(const ResultTable& table);

/// Key and text of everything that the campaign recorded of itself.
DataTable manifest_table(const ResultTable& table);

/// One row per method; for each column its estimate, interval, count and missing values.
DataTable summary_data(const SummaryTable& table);

/// One row per bin, in the same way. Its name is "METHOD_by_DESCRIPTOR".
DataTable cross_data(const CrossTable& table);

/// RFC 4180: a line of column names, then one line a row. Numbers read back exactly.
std::string render_csv(const DataTable& table);

/// {"name", "columns": [...], "rows": [[...], ...]}; empty fields are null.
std::string render_json(const DataTable& table);

}  // namespace slalom
