// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The largest number of fields of a table, which fits in memory.
constexpr std::size_t kMaxFields = 20000000;

/// A table of another program as CSV, for columns_from_csv().
struct ForeignTable {
  std::string csv;
  std::vector<std::string> success_words = {};
};

/// Reads a benchmark database of OMPL, as ompl_benchmark_statistics.py makes it, a workbook
/// (.xlsx), or a table as JSON. nullopt for any other file. Throws Error (File) for a damaged one.
///
/// OMPL: the scenario is the experiment, the method the planner, the outcome the description of
/// `status`, of which "exact solution" is a success; all other columns of `runs` are values, with
/// "_" for blanks.
///
/// A workbook: the sheet of that name, without one its only sheet with cells. Formulas have the
/// value with which they were saved.
std::optional<ForeignTable> read_foreign_table(const std::string& path, const std::string& sheet);

/// A table as JSON; nullopt for any other text. NaN and infinities, which Python writes, are empty
/// fields. Known are
/// - the results of Bench-MR: the scenario is the environment with the number of its run, the
///   method the planner. Numbers and truth values of `stats` are values, of lists their length. A
///   path that is found, does not collide and ends at the goal is a success; a plan without `stats`
///   is a failure. Smoothed paths are left out;
/// - an array of objects, a row each; values in objects within are columns A.B;
/// - an object of arrays of the same length, a column each;
/// - an object of such tables, a method each; one named METHOD--SCENARIO, as in Arena's, is of that
///   scenario. A table may be in further objects.
std::optional<ForeignTable> table_from_json(const std::string& text, const std::string& name);

/// The sheet of a workbook, a line per row.
ForeignTable table_from_workbook(const std::string& path, const std::string& sheet);

}  // namespace slalom
