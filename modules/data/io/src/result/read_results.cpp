// SPDX-License-Identifier: BSD-3-Clause
#include "combined_results.h"

#include <slalom/core/error.h>
#include <slalom/core/file_format.h>
#include <slalom/io/bundle.h>
#include <slalom/io/merge_results.h>
#include <slalom/io/read_results.h>

#include <filesystem>

namespace slalom {
namespace {

ResultTable read_all(const std::string& path, const RowsToRead& wanted) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored))
    return finish_table(read_file_rows(path, wanted).table);
  CombinedResults combined(path);
  for (const std::string& file : shards_in(path)) combined.add(read_file_rows(file, wanted));
  return combined.finish();
}

}  // namespace

ResultTable read_results(const std::string& path,
                         const std::optional<std::vector<std::string>>& ids) {
  return read_all(path, {ids});
}

ResultTable read_detailed_results(const std::string& path) {
  RowsToRead wanted;
  wanted.details = true;
  return read_all(path, wanted);
}

std::vector<std::string> shards_in(const std::string& folder) {
  std::vector<std::string> files = campaign_files(folder);
  if (files.empty())
    throw file_error(folder, "contains no result files",
                     "a folder with result files (.results) of a campaign");
  return files;
}

bool is_result_input(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored) ||
         (is_database(path) && !recognize_file(path)) || is_bundle(path);
}

}  // namespace slalom
