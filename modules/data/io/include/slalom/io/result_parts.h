// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/result_table.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// The results of a folder with the shards of a campaign, file by file: memory does not grow with
/// the number of runs.
class ResultParts {
 public:
  /// Files are read on up to `jobs` threads; the results do not depend on their number. Throws
  /// Error (File) if there are none, and for files of different campaigns.
  explicit ResultParts(const std::string& folder, int jobs = 1);

  /// The campaign without runs and scenarios, with the infos of all columns but wall-clock figures.
  /// Its descriptors have the values that read_values() read, in any order.
  const ResultTable& outline() const { return outline_; }
  std::size_t files() const { return files_.size(); }
  /// Whether no two files contain the same scenario, as those of shards.
  bool are_disjoint() const { return disjoint_; }

  /// Reads the values of a descriptor in all scenarios, 8 bytes each.
  void read_values(const std::string& descriptor);

  /// Calls `use` with the results of each file, one after the other, as read_results() returns
  /// them. At most `jobs` of them are in memory. Throws Error (File).
  void for_each(const std::vector<std::string>& ids,
                const std::function<void(ResultTable&)>& use) const;

 private:
  std::vector<std::string> files_;
  int jobs_;
  ResultTable outline_;
  bool disjoint_ = true;

  void check_files();
};

}  // namespace slalom
