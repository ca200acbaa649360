// SPDX-License-Identifier: BSD-3-Clause
#include "warnings.h"

#include <slalom/app/program.h>
#include <slalom/campaign/shards.h>
#include <slalom/core/error.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>
#include <slalom/io/merge_results.h>

#include <filesystem>
#include <iostream>

namespace slalom {

std::size_t planned_runs(const ResultTable& runs) {
  try {
    return plan_of(runs.manifest, runs.source).runs();
  } catch (const Error&) {
    return 0;
  }
}

void warn_of_missing_runs(const std::string& folder, std::size_t files, std::size_t runs,
                          std::size_t planned) {
  if (runs >= planned) return;
  std::cerr << folder << ": " << runs << " of " << planned << " runs "
            << (files > 0 ? "in " + count_text(files, "file") : "of its campaign") << "\n";
}

void warn_of_missing(const std::string& path, const ResultTable& runs) {
  warn_of_damage(path, runs.damaged);
  for (const std::string& note : runs.notes)
    std::cerr << path << ": " << printable_line(note) << "\n";
  if (is_foreign(runs)) return;
  std::error_code ignored;
  const bool is_folder = std::filesystem::is_directory(path, ignored);
  warn_of_missing_runs(path, is_folder ? campaign_files(path).size() : 0, runs.size(),
                       planned_runs(runs));
}

}  // namespace slalom
