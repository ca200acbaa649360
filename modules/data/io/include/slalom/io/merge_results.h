// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/run_record.h>

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace slalom {

/// The key of a manifest with the shard, such as "3/16"; absent for a complete campaign.
constexpr const char* kShardKey = "shard";

/// The result files of a folder, by name: those of shards if there are any (a file that was merged
/// from them is left out), else all; files that cannot be read are among them. Throws Error (File)
/// if the folder cannot be read.
std::vector<std::string> campaign_files(const std::string& folder);

/// Contents of a result file.
struct ResultCounts {
  Manifest manifest;
  std::size_t runs = 0;
  std::map<std::string, std::size_t> outcomes;  ///< runs by outcome
  double wall_seconds = 0;                      ///< of all its runs together
};

/// Throws Error (File).
ResultCounts count_results(const std::string& path);

/// One result file from the runs of several ones of the same campaign, in a temporary file until
/// publish(). Rows are copied without being decoded.
class MergedResults {
 public:
  /// `first` is the file whose campaign it is; its manifest is that of the merged file, without the
  /// shard. Throws Error: File unless it can be read, or if there is a file of another kind at
  /// `path`; Job when it cannot be written.
  MergedResults(const std::string& path, const std::string& first);
  ~MergedResults();
  MergedResults(const MergedResults&) = delete;
  MergedResults& operator=(const MergedResults&) = delete;

  /// Adds the runs of a file and returns their number. Runs and scenarios that were added before
  /// must be equal. Throws Error (File) naming the first difference, also for another campaign.
  std::size_t add(const std::string& file);

  const Manifest& manifest() const;
  std::size_t runs() const;        ///< without duplicates
  std::size_t duplicates() const;  ///< runs that were added again

  /// Replaces the file at `path`. Throws Error (Job).
  void publish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace slalom
