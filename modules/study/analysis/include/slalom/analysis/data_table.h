// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/summary.h>
#include <slalom/results/result_table.h>

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace slalom {

/// A field of a table: empty, a number, a count, a seed (any 64 bits) or a text.
using Field = std::variant<std::monostate, double, std::int64_t, std::uint64_t, std::string>;

/// A table with named columns, as in spreadsheets and databases. Fields are computed on demand, so
/// that large results are not copied. Refers to its source, which must outlive it.
struct DataTable {
  std::string name;                  ///< of the file or sheet: "runs"
  std::string title;                 ///< for display
  std::vector<std::string> columns;  ///< ids
  std::size_t rows = 0;
  std::function<Field(std::size_t row, std::size_t column)> at;
};

/// One row per run: scenario, method, repetition, seed, outcome (what `table` has no details of is
/// empty), every metric (empty if NA), the NA reasons ("safety: collision; spl: ..."), every
/// descriptor of its scenario.
DataTable runs_table(const ResultTable& table);

/// One row per scenario with its descriptors.
DataTable scenarios_table(const ResultTable& table);

/// The wall-clock measurements, one row per run with details. Separate because they are not
/// reproducible.
DataTable timings_table(const ResultTable& table);

/// Keys and values of the campaign's manifest.
DataTable manifest_table(const ResultTable& table);

/// One row per method; for each column its estimate, interval, count of values (".n") and of
/// runs without a value (".na").
DataTable summary_data(const SummaryTable& table);

/// One row per bin, with the same columns. Its name is "METHOD_by_DESCRIPTOR".
DataTable cross_data(const CrossTable& table);

/// RFC 4180: a line of column names, then one line per row. Numbers are exact.
std::string render_csv(const DataTable& table);

/// {"name", "columns": [...], "rows": [[...], ...]}; empty fields are null.
std::string render_json(const DataTable& table);

}  // namespace slalom
