// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/io/result_file.h>
#include <slalom/results/method_failures.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace slalom {

/// A result file, or all of a folder with the shards of a campaign (see campaign_files()), by
/// scenario.
class ResultFiles {
 public:
  /// Throws Error (File) if the file, or one of the folder, cannot be read.
  explicit ResultFiles(const std::string& path);

  /// The files that contain the scenario: one, unless a campaign was divided in another way than by
  /// scenario. They are open until the next call. Throws Error (File).
  std::vector<const ResultFile*> with_scenario(const std::string& hash);

 private:
  std::vector<std::string> paths_;
  std::map<std::string, std::vector<std::size_t>> files_of_;       ///< by hash
  std::map<std::size_t, std::unique_ptr<const ResultFile>> open_;  ///< by index into paths_
};

/// Adds the runs of a table that was read from the file or folder `path`, with the texts of the
/// failures there. A table that was not read from result files has none. Throws Error (File).
void add_method_failures(const ResultTable& table, const std::string& path,
                         MethodFailures& failures);

}  // namespace slalom
