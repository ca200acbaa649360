// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/io/result_file.h>
#include <slalom/results/result_table.h>

#include <string>

namespace slalom {

/// A quantity that is not one of Slalom's: a metric with its values of the runs of a table, or a
/// descriptor with those of its scenarios.
struct OwnColumn {
  ValueColumn values;
  bool is_descriptor = false;
  std::string source;  ///< the text of what computes it, for readers of the results
};

/// The key of a manifest with the source of an own column, before its id.
constexpr const char* kOwnColumnPrefix = "own_column.";

/// Writes the results of a file to another one, which has that column as well; `table` is what
/// read_results() reads from the file. Throws Error: Usage, with the run or scenario, for a value
/// outside of the column's range, and for an id that a column has or cannot have; otherwise as
/// ResultFile::create() does.
void write_with_column(const ResultFile& file, const ResultTable& table, const OwnColumn& column,
                       const std::string& path);

}  // namespace slalom
