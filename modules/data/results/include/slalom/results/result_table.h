// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/privileged.h>
#include <slalom/results/run_record.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// Outcome of a run without a known one, as in imported tables.
constexpr const char* kUnknownOutcome = kNotRecorded;

/// The values of one quantity, one per row: a number, or the reason why it is not available. Takes
/// 8 bytes per row: a reason is stored as the payload of a NaN.
class ValueColumn {
 public:
  explicit ValueColumn(QuantityInfo info) : info_(std::move(info)) {}

  const QuantityInfo& info() const { return info_; }
  void reserve(std::size_t rows) { numbers_.reserve(rows); }
  void add(const Value& value);
  void add_number(double number);  ///< NA ("not a finite number") unless finite
  void add_na(const std::string& reason);
  void pad(std::size_t rows);  ///< adds NA ("not recorded") up to this size

  std::size_t size() const { return numbers_.size(); }
  bool is_na(std::size_t row) const { return numbers_[row] != numbers_[row]; }
  double number(std::size_t row) const { return numbers_[row]; }  ///< NaN where NA
  const std::string& reason(std::size_t row) const;               ///< requires is_na(row)

  /// Reorders rows: row i gets the value of row order[i].
  void reorder(const std::vector<std::size_t>& order);
  /// Replaces the value of a row.
  void set_na(std::size_t row, const std::string& reason);
  void set_id(const std::string& id) { info_.id = id; }
  /// States another kind of the same values, with its range.
  void set_kind(QuantityKind kind, const Range& range);

  /// Measured wall-clock time: not repeatable.
  bool wall_clock = false;

 private:
  QuantityInfo info_;
  std::vector<double> numbers_;
  std::vector<std::string> reasons_;
  std::map<std::string, std::uint32_t> indexes_;  ///< into reasons_, by reason

  double na_number(const std::string& reason);
};

/// A column for a wall-clock figure.
ValueColumn wall_clock_column(const std::string& id);

/// Data that identify and explain a run beyond its keys and values.
struct RunDetails {
  std::uint64_t seed = 0;
  std::string outcome_detail, trajectory_hash;
  double wall_seconds = 0;
};

/// The runs of one or more result files as columns: a million runs with 40 metrics take 350 MB.
/// Names are stored once; runs refer to them by index. Wall-clock figures are metrics with
/// `wall_clock`. "success" is always a metric of the runs of a result file.
struct ResultTable {
  std::string source;  ///< file, for messages
  Manifest manifest;
  std::vector<std::string> scenario_hashes, scenario_names;  ///< parallel
  std::vector<std::string> methods;                          ///< sorted
  std::vector<std::string> outcomes;                         ///< success first, others sorted
  std::vector<std::uint32_t> scenario, method, outcome, repetition;  ///< one per run
  std::vector<ValueColumn> metrics;                                  ///< one value per run
  std::vector<ValueColumn> descriptors;                              ///< one value per scenario
  /// Metrics of a foreign table that are NA in failed runs, with the values of these runs, too: the
  /// time of a failure, or what says nothing about performance. One value per run.
  std::vector<ValueColumn> unconditional;
  std::vector<RunDetails> details;  ///< one per run, or none if they were not read
  /// What was damaged in the file and is therefore missing: "run 0123abcd/nd/0". The descriptors of
  /// a damaged scenario are NA.
  std::vector<std::string> damaged;
  /// Columns of a foreign table that are no metrics, and why: "line 7: 'DNF' is not a number".
  std::vector<std::pair<std::string, std::string>> unread;
  /// Why no run can end in time, by the hash of the scenario; see lack_of_time.h.
  std::map<std::string, std::string> lack_of_time;
  std::vector<std::string> notes;  ///< how a foreign table was read, where that is not obvious

  std::size_t size() const { return scenario.size(); }
};

/// The key of a manifest with the files of a table that was imported.
constexpr const char* kImportedKey = "imported_from";

/// Whether a manifest is that of an imported table.
bool is_imported(const Manifest& manifest);
/// Whether the runs are of a foreign table, as it was read or imported.
bool is_foreign(const ResultTable& table);

/// Success by the outcome: 1 or 0; NA, with the outcome as reason, if that is unknown or
/// inconclusive (such as an unsolvable scenario).
Value success_of(const std::string& outcome);

/// Adds the metric "success" derived from the outcome if it is missing.
void add_success(ResultTable& columns);

/// lack_of_time_note() of the table.
std::string note_on_time(const ResultTable& table);

/// Adds each name to `names` once; for columns that refer to names by index.
class NameIndex {
 public:
  explicit NameIndex(std::vector<std::string>& names) : names_(names) {}
  std::uint32_t index_of(const std::string& name);

 private:
  std::vector<std::string>& names_;
  std::map<std::string, std::uint32_t> indexes_;
};

/// Sorts the methods by name, and the outcomes: success first, the others by name.
void sort_names(ResultTable& columns);

/// Throws Error (File) for a name of a method or scenario that expect_name() refuses.
void expect_names(const ResultTable& columns);

/// Sorts the names, scenarios by name and hash, and runs by scenario, method and repetition.
void sort_rows(ResultTable& columns);

/// Removes the runs in the other scenarios; the names of these stay.
void keep_runs_in(ResultTable& columns, const std::vector<bool>& scenarios);

/// Null if there is none.
const ValueColumn* find_metric(const ResultTable& columns, const std::string& id);
const ValueColumn* find_descriptor(const ResultTable& columns, const std::string& id);
/// The metric with the values of failed runs, too, if the table has them.
const ValueColumn* find_unconditional(const ResultTable& columns, const std::string& id);

/// Puts the mark behind the names of those methods, so that all that is made of the table shows it.
/// Ids of runs, names of files and random streams of tables have the names without it.
void mark_privileged(ResultTable& table, const PrivilegedMethods& methods);
/// The same as the manifest says. Nothing changes in a table with marks.
void mark_privileged(ResultTable& table);
/// The name as it is marked in the table; a name that is in it, or is not marked, stays.
std::string marked_name(const ResultTable& table, const std::string& method);
/// The name without the mark, if its method is privileged: foreign tables have names such as RRT*.
std::string unmarked_name(const ResultTable& table, const std::string& method);
/// The footnote that explains the marks of the table; "" without marks.
std::string privileged_footnote(const ResultTable& table);

/// Id of a run, as for a RunRecord: "hash8/method/repetition".
std::string run_id(const ResultTable& columns, std::size_t run);

/// Whether an outcome is a failure of the method: neither a success, nor inconclusive (such as an
/// unsolvable scenario), nor unknown.
bool is_failure(const std::string& outcome);

}  // namespace slalom
