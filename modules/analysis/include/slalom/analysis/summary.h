#pragma once

#include <slalom/analysis/cell.h>

#include <map>
#include <string>
#include <vector>

namespace slalom {

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

/// Throws Error (Usage) for an unknown column.
SummaryTable build_summary(const ResultTable& table, const std::vector<std::string>& column_ids,
                           const AnalysisOptions& options);

}  // namespace slalom
