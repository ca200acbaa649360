// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/bins.h>
#include <slalom/analysis/cell.h>
#include <slalom/analysis/trend.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// One row of a cross table: the runs of a method in the scenarios of one bin.
struct CrossRow {
  Bin bin;
  std::size_t n = 0;                 ///< number of runs
  std::vector<std::size_t> runs;     ///< indexes into the table's runs, in their order
  std::vector<std::string> run_ids;  ///< their ids, if AnalysisOptions::run_ids
  std::vector<Cell> cells;           ///< one per column
};

/// Cross table of scenario properties (rows) and performance of one method (columns).
struct CrossTable {
  std::string title;  ///< e.g. "nd by density"
  std::string method;
  QuantityInfo descriptor;  ///< of the rows; id "all" for a single row with all runs
  std::vector<Column> columns;
  std::vector<CrossRow> rows;
  /// One per column; none for measured times and with too few scenarios. All tables of one analysis
  /// are one family of tests.
  std::vector<std::optional<Trend>> trends;
  std::size_t outside = 0;         ///< runs whose scenario's value lies outside all bins
  std::size_t undescribed = 0;     ///< runs whose scenario has no value
  std::vector<std::string> notes;  ///< text for both; empty if no run is left out
  double confidence = 0.95;
  std::string footnote;  ///< of the mark of privileged methods; empty if there is none
};

/// Summary of all runs of one method.
struct MethodSummary {
  std::string method;
  std::size_t n = 0;
  std::map<std::string, std::size_t> outcomes;  ///< runs by outcome
  std::vector<Cell> cells;                      ///< one per column
};

struct SummaryTable {
  std::vector<Column> columns;
  std::vector<MethodSummary> methods;  ///< sorted by name
  std::vector<std::string> outcomes;   ///< all that occur: success first, the others by name
  double confidence = 0.95;
  std::string footnote;  ///< of the mark of privileged methods; empty if there is none
};

}  // namespace slalom
