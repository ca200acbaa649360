// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/result_table.h>

#include <map>
#include <string>
#include <vector>

namespace slalom {

/// Properties of the columns of a CSV file.
struct CsvColumnOptions {
  std::vector<std::string> up, down;  ///< columns of which more (less) is better
  /// The names of the columns that identify the run of a row; empty: known by their names.
  std::string method = "", scenario = "", repetition = "", outcome = "";
  /// Stated kinds and ranges of columns, which all values must have.
  std::map<std::string, QuantityKind> kinds = {};
  std::map<std::string, Range> ranges = {};
  /// Columns with these ids have their kind and range, unless others are stated.
  std::vector<QuantityInfo> known = {};
  /// Known columns that are NA in runs that failed; of others the name decides, but in a table with
  /// a column scenario_hash, which Slalom has exported.
  std::vector<std::string> known_conditional = {};
  /// Columns that are NA in runs that failed, and that are as they stand there.
  std::vector<std::string> conditional = {}, unconditional = {};
  /// Names of the columns of a table without a header line; empty: it has one.
  std::vector<std::string> names = {};
  /// The sheet of a workbook; empty: its only one with cells.
  std::string sheet = {};
  /// Outcomes that mean success, in any case; with one, unknown outcomes are failures.
  std::vector<std::string> success_words = {};
};

/// Reads "fell=count,score=amount". Throws Error (Usage).
std::map<std::string, QuantityKind> parse_column_kinds(const std::string& text);
/// Reads "score=0..1,time=0..". Throws Error (Usage).
std::map<std::string, Range> parse_column_ranges(const std::string& text);

/// Reads a table of numbers as runs: CSV (RFC 4180) with a header line, separated by commas,
/// semicolons, tabs or blanks. The columns "scenario_hash" or "scenario", "method", "repetition"
/// and "outcome", or what other programs call them ("planner", "world", "trial"), identify the run
/// of a row; without them each row is a scenario of its own, with method "all", and rows of the
/// same scenario and method are its repetitions in their order.
///
/// All other columns of numbers are metrics; true and false are 1 and 0, "85%" is 0.85, and words
/// such as "", "NA", "None" and "inf" are not available, with the word as the reason, as are
/// numbers from 3.4e38. A column that contains only 0 and 1 is a rate, unless another kind is
/// stated. Rates such as "collided" and "timeout", and "success", are outcomes, too. Times, lengths
/// and the like are NA in runs that failed, and complete in `unconditional`. Columns with other
/// text are in `unread`; what was taken as what is in `notes`.
///
/// Throws Error (File), with the line, for a row with a wrong number of fields, for a first line of
/// numbers, for two columns of one name, for a row without a method or scenario and for one of a
/// repetition that was there, for a value outside the range of a known id, for a negative time or
/// length of a success, for a score above 0 of a failure, for an unknown outcome and for outcomes
/// that contradict each other, and if there are no rows or no numbers.
ResultTable columns_from_csv(const std::string& text, const std::string& name,
                             const CsvColumnOptions& options = {});

/// A table as it stands in a file.
struct CsvFile {
  std::string text, name;
};

/// The same of the rows of several tables. If none of them has a column of methods, each is of one
/// method, with the name of its file. Throws Error (File) also if only some have one, for a table
/// that is given twice and for two methods of one name.
ResultTable columns_from_csv(const std::vector<CsvFile>& files,
                             const CsvColumnOptions& options = {});

/// The column that says whether a run collided, such as "collided"; null if there is none.
const ValueColumn* collision_column(const ResultTable& table);

/// Whether the name of a column is that of the time of a run, such as "duration [s]".
bool is_time_name(const std::string& name);

/// Decides the kind of each column over all tables: a column of 0 and 1 is a rate only if it is one
/// in all tables that have it.
void unify_kinds(std::vector<ResultTable>& tables);

}  // namespace slalom
