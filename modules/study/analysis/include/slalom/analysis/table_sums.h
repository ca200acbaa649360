// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cell_sums.h>
#include <slalom/analysis/table_types.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace slalom {

/// The rows of cross tables: a specification with its bins.
struct BinnedRows {
  QuantityInfo descriptor;  ///< id "all" for a single row with all runs
  std::vector<Bin> bins;
};
/// The bins over the scenarios of `table`, see make_bins().
BinnedRows bin_rows(const BinSpec& spec, const ResultTable& table);

/// The row of each run.
class RunRows {
 public:
  static constexpr std::uint32_t kOutside = 0xFFFFFFFF, kUndescribed = 0xFFFFFFFE;

  RunRows(const BinnedRows& rows, const ResultTable& table);
  std::uint32_t operator()(std::size_t run) const {
    if (rows_.empty()) return 0;
    return rows_[scenario_ != nullptr ? (*scenario_)[run] : run];
  }

 private:
  std::vector<std::uint32_t> rows_;             ///< one per scenario, or per run; none: all 0
  const std::vector<std::uint32_t>* scenario_;  ///< null: one per run
};

/// Cross tables and a summary of results that are added part by part, such as the shards of a
/// campaign. Memory depends on the size of the tables and of a part, not on the number of runs. The
/// numbers do not depend on how the runs are divided into parts, as long as all runs of a scenario
/// are in the same part. Without medians and the runs of rows.
class TableSums {
 public:
  /// `method`: restricts the tables to one; empty: all.
  TableSums(std::vector<BinnedRows> rows, std::vector<std::string> metrics,
            std::string method = "");

  void add(const ResultTable& part);

  /// Per rows and method; rows outermost. Throws Error (Usage) for a metric that was in no part.
  std::vector<CrossTable> cross_tables(const AnalysisOptions& options) const;
  /// Summary over rows with a single bin, with all runs. Throws as cross_tables() does.
  SummaryTable summary(std::size_t rows, const AnalysisOptions& options) const;

 private:
  struct Row {
    std::size_t runs = 0, failures = 0;
    RowSums cells;  ///< one per metric
  };
  /// A run, and its row, counted over all methods.
  struct RunInRow {
    std::uint32_t run, row;
  };
  struct Rows {
    std::size_t outside = 0, undescribed = 0;
    std::vector<Row> rows;
  };
  struct Method {
    std::map<std::string, std::size_t> outcomes;
    std::vector<Rows> tables;  ///< one per BinnedRows
  };

  std::vector<BinnedRows> rows_;
  std::vector<std::string> metrics_;
  std::string method_;
  std::vector<std::optional<Column>> columns_;  ///< parallel to metrics_
  std::vector<std::string> known_metrics_;      ///< of the last part, for messages
  std::map<std::string, Method> methods_;
  std::vector<std::string> scenarios_;  ///< names and hashes of those that are kept by cells
  std::map<std::string, std::uint32_t> scenario_keys_;
  std::size_t parts_ = 0;

  std::vector<Method*> methods_of(const ResultTable& part);
  void count_outcomes(const ResultTable& part, const std::vector<Method*>& methods);
  void add_values(std::size_t table, const ResultTable& part, const std::vector<Method*>& methods,
                  const std::vector<RunInRow>& runs);
  void add_table(std::size_t table, const ResultTable& part, const std::vector<Method*>& methods,
                 const std::vector<std::uint32_t>& order);
  void end_part(const ResultTable& part, const std::vector<Method*>& methods);
  std::vector<Column> columns() const;
  std::vector<Cell> cells_of(const Row& row, const AnalysisOptions& options) const;
};

}  // namespace slalom
