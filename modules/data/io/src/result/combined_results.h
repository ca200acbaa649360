// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/result_table.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Rows of one result file: its table, in any order, and the checksums of the rows.
struct FileRows {
  ResultTable table;
  std::vector<std::int64_t> runs;
  std::vector<std::optional<std::int64_t>> scenarios;  ///< none for a damaged one
};

/// The part of a file to read, see read_results().
struct RowsToRead {
  std::optional<std::vector<std::string>> ids;
  bool details = false;
};
FileRows read_file_rows(const std::string& path, const RowsToRead& wanted);

/// The campaign_files() of a folder. Throws Error (File) if there are none.
std::vector<std::string> shards_in(const std::string& folder);

/// One table from the files of a campaign, the same as that of the file merged from them.
class CombinedResults {
 public:
  /// `source`: of the table.
  explicit CombinedResults(const std::string& source) { table_.source = source; }
  CombinedResults(const CombinedResults&) = delete;
  CombinedResults& operator=(const CombinedResults&) = delete;

  /// Adds the rows of a file that are new; those that are not must be equal. Wall-clock figures are
  /// those of the first file with the run. Throws Error (File), also for another campaign.
  void add(FileRows part);

  ResultTable finish();

 private:
  ResultTable table_;
  std::size_t files_ = 0;
  std::vector<std::int64_t> runs_;                      ///< checksums, as in FileRows
  std::vector<std::optional<std::int64_t>> scenarios_;  ///< the same
  NameIndex hashes_{table_.scenario_hashes}, methods_{table_.methods}, outcomes_{table_.outcomes};

  bool add_scenarios(FileRows& part);
  std::vector<std::size_t> find_new_runs(const FileRows& part) const;
  void add_runs(FileRows& part, const std::vector<std::size_t>& rows);
};

/// Sorts the rows of a table that was read, and adds the success of runs.
ResultTable finish_table(ResultTable table);

/// Rules of files with an imported table: the id of a column in the table, whether runs can have
/// the outcome, the table as it was written.
std::string id_of_imported(const std::string& id);
bool is_outcome_of_imported(const std::string& outcome);
ResultTable finish_imported(ResultTable table);

}  // namespace slalom
