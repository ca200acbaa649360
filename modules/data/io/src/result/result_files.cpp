// SPDX-License-Identifier: BSD-3-Clause
#include "database.h"

#include <slalom/io/merge_results.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_files.h>

#include <filesystem>
#include <optional>

namespace slalom {

ResultFiles::ResultFiles(const std::string& path) {
  std::error_code ignored;
  paths_ = std::filesystem::is_directory(path, ignored) ? campaign_files(path)
                                                        : std::vector<std::string>{path};
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    ResultFile::open(paths_[i]);  // throws unless it is a result file
    reading(paths_[i], [&] {
      const auto database = open_reader(paths_[i]);
      SQLite::Statement rows(*database, "SELECT hash FROM scenarios");
      while (rows.executeStep()) files_of_[rows.getColumn(0).getString()].push_back(i);
    });
  }
}

std::vector<const ResultFile*> ResultFiles::with_scenario(const std::string& hash) {
  constexpr std::size_t kMaxOpen = 100;  // a process can open about a thousand
  if (open_.size() > kMaxOpen) open_.clear();
  std::vector<const ResultFile*> files;
  const auto found = files_of_.find(hash);
  if (found == files_of_.end()) return files;
  for (const std::size_t i : found->second) {
    std::unique_ptr<const ResultFile>& file = open_[i];
    if (!file) file = std::make_unique<const ResultFile>(ResultFile::open(paths_[i]));
    files.push_back(file.get());
  }
  return files;
}

void add_method_failures(const ResultTable& table, const std::string& path,
                         MethodFailures& failures) {
  std::optional<ResultFiles> files;  // opened only if there is a failure
  failures.add(table, [&](const std::string& hash, const std::string& method, int repetition) {
    if (!is_result_input(path)) return std::string();
    if (!files) files.emplace(path);
    for (const ResultFile* file : files->with_scenario(hash))
      if (const auto run = file->read_run(hash, method, repetition)) return run->outcome_detail;
    return std::string();
  });
}

}  // namespace slalom
