// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/campaign/merge_campaign.h>
#include <slalom/campaign/shards.h>
#include <slalom/core/error.h>
#include <slalom/io/merge_results.h>
#include <slalom/io/result_file.h>

#include <algorithm>
#include <map>

namespace slalom {
namespace {

/// The names of shards without all their runs. Runs are counted by file, so that it is known only
/// if all files are shards of the same number.
std::string missing_shards(const RunPlan& plan,
                           const std::map<std::size_t, std::size_t>& runs_by_shard) {
  std::vector<std::size_t> missing;
  for (std::size_t i = 1; i <= plan.shard.count; ++i) {
    const auto found = runs_by_shard.find(i);
    const std::size_t runs = found == runs_by_shard.end() ? 0 : found->second;
    if (runs < plan.runs_of({i, plan.shard.count})) missing.push_back(i);
  }
  return (missing.size() == 1 ? "shard " : "shards ") + number_ranges(missing);
}

}  // namespace

MergeReport merge_campaign(const std::vector<std::string>& files, const std::string& output,
                           bool allow_incomplete, Progress& progress) {
  MergedResults merged(output, files.at(0));
  RunPlan plan = plan_of(count_results(files.at(0)).manifest, files.at(0));
  std::map<std::size_t, std::size_t> runs_by_shard;
  bool same_division = plan.shard.count > 1;
  progress.start("Merging", files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    const Shard shard = plan_of(ResultFile::open(files[i]).read_manifest(), files[i]).shard;
    same_division = same_division && shard.count == plan.shard.count;
    std::size_t& runs = runs_by_shard[shard.index];
    runs = std::max(runs, merged.add(files[i]));
    progress.advance(i + 1);
  }
  progress.finish();
  MergeReport report{files.size(), merged.runs(), plan.runs(), merged.duplicates(), ""};
  if (report.runs < report.planned)
    report.missing = same_division ? missing_shards(plan, runs_by_shard)
                                   : std::to_string(report.planned - report.runs) + " runs";
  if (!report.missing.empty() && !allow_incomplete)
    throw job_error(output,
                    std::to_string(report.runs) + " of " + std::to_string(report.planned) +
                        " runs; missing: " + report.missing,
                    "all runs, or --allow-incomplete");
  merged.publish();
  return report;
}

}  // namespace slalom
