#include "warnings.h"

#include <slalom/app/program.h>
#include <slalom/campaign/shards.h>
#include <slalom/core/error.h>
#include <slalom/io/merge_results.h>

#include <filesystem>
#include <iostream>

namespace slalom {
namespace {

/// 0 if it is not known.
std::size_t planned_runs(const std::string& path, const Manifest& manifest) {
  try {
    return plan_of(manifest, path).runs();
  } catch (const Error&) {
    return 0;  // a campaign with a stopping rule
  }
}

}  // namespace

void warn_of_missing(const std::string& path, const ResultTable& runs) {
  warn_of_damage(path, runs.damaged);
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored)) return;
  const std::size_t planned = planned_runs(path, runs.manifest);
  if (runs.size() >= planned) return;
  const std::size_t files = campaign_files(path).size();
  std::cerr << path << ": " << runs.size() << " of " << planned << " runs in " << files
            << (files == 1 ? " file" : " files") << "\n";
}

}  // namespace slalom
