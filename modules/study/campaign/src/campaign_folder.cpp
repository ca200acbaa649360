// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/campaign/campaign_folder.h>
#include <slalom/core/enum_names.h>
#include <slalom/core/error.h>
#include <slalom/io/campaign_identity.h>
#include <slalom/io/file_lock.h>
#include <slalom/io/merge_results.h>
#include <slalom/trajectory/trajectory.h>

#include <algorithm>
#include <ctime>
#include <fcntl.h>
#include <filesystem>
#include <map>
#include <sys/stat.h>

namespace slalom {
namespace {

/// s since 1970; 0 if there is no such file.
struct FileTimes {
  double created = 0, changed = 0;
};

FileTimes times_of(const std::string& path) {
  struct statx found = {};
  const unsigned int wanted = STATX_BTIME | STATX_MTIME;
  if (statx(AT_FDCWD, path.c_str(), 0, wanted, &found) != 0) return {};
  const auto seconds = [](const statx_timestamp& time) {
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  // Not all file systems know when a file was created.
  return {(found.stx_mask & STATX_BTIME) != 0 ? seconds(found.stx_btime) : 0,
          seconds(found.stx_mtime)};
}

ShardState state_of(const ShardStatus& shard) {
  const bool locked = std::filesystem::exists(lock_path(shard.path));
  if (!shard.holder.empty()) {
    const double silence = static_cast<double>(std::time(nullptr)) - times_of(shard.path).changed;
    return silence < kSilentSeconds ? ShardState::Running : ShardState::Stale;
  }
  if (shard.runs >= shard.planned) return ShardState::Done;
  return locked ? ShardState::Stale : ShardState::Failed;
}

/// The program holds the lock since it started: it made all runs if the file is newer.
double speed_of(const ShardStatus& shard) {
  const FileTimes results = times_of(shard.path);
  const double start = times_of(lock_path(shard.path)).changed;
  constexpr double kShortest = 1;  // s
  if (shard.state != ShardState::Running || results.created < start ||
      results.changed < start + kShortest)
    return 0;
  return static_cast<double>(shard.runs) / (results.changed - start);
}

ShardStatus status_of(const std::string& path, const ResultCounts& counts, const RunPlan& plan) {
  ShardStatus status;
  status.shard = plan.shard.index;
  status.path = path;
  status.runs = counts.runs;
  status.planned = plan.runs_of(plan.shard);
  const auto errors = counts.outcomes.find(to_string(Outcome::InfrastructureError));
  if (errors != counts.outcomes.end()) status.infrastructure_errors = errors->second;
  status.holder = lock_holder(path);
  status.state = state_of(status);
  status.runs_per_second = speed_of(status);
  return status;
}

/// Collects the files of one campaign, that of the first file.
class StatusReader {
 public:
  void read(const std::string& path) {
    const ResultCounts counts = count_results(path);
    const RunPlan plan = plan_of(counts.manifest, path);
    if (shards_.empty()) {
      manifest_ = counts.manifest;
      status_.plan = plan;
    }
    expect_same_campaign(manifest_, counts.manifest, path, "files of one campaign in a folder");
    if (plan.shard.count != status_.plan.shard.count)
      throw file_error(path, "is shard " + to_string(plan.shard),
                       "one of " + std::to_string(status_.plan.shard.count) + " shards");
    const ShardStatus status = status_of(path, counts, plan);
    const auto [found, is_new] = shards_.try_emplace(status.shard, status);
    if (is_new) return;
    status_.problems.push_back(path + ": is shard " + to_string(plan.shard) + ", as is " +
                               found->second.path);
    if (status.runs > found->second.runs) found->second = status;
  }

  void add_problem(const Error& error) { status_.problems.emplace_back(error.what()); }

  CampaignStatus finish(const std::string& folder) {
    if (shards_.empty())
      throw file_error(folder,
                       status_.problems.empty() ? "contains no result files"
                                                : "no file can be read: " + status_.problems[0],
                       "a folder with result files (.results) of a campaign");
    status_.plan.shard.index = 1;
    for (std::size_t i = 1; i <= status_.plan.shard.count; ++i) {
      ShardStatus missing;
      missing.shard = i;
      missing.planned = status_.plan.runs_of({i, status_.plan.shard.count});
      const auto found = shards_.find(i);
      status_.shards.push_back(found == shards_.end() ? missing : found->second);
    }
    return std::move(status_);
  }

 private:
  Manifest manifest_;
  CampaignStatus status_;
  std::map<std::size_t, ShardStatus> shards_;
};

}  // namespace

std::size_t CampaignStatus::runs() const {
  std::size_t runs = 0;
  for (const ShardStatus& shard : shards) runs += shard.runs;
  return runs;
}

double CampaignStatus::runs_per_second() const {
  double speed = 0;
  for (const ShardStatus& shard : shards) speed += shard.runs_per_second;
  return speed;
}

double CampaignStatus::seconds_left() const {
  double left = 0;
  for (const ShardStatus& shard : shards)
    if (shard.runs_per_second > 0)
      left =
          std::max(left, static_cast<double>(shard.planned - shard.runs) / shard.runs_per_second);
  return left;
}

std::vector<std::size_t> CampaignStatus::unfinished() const {
  std::vector<std::size_t> numbers;
  for (const ShardStatus& shard : shards)
    if (shard.state != ShardState::Done && shard.state != ShardState::Running)
      numbers.push_back(shard.shard);
  return numbers;
}

CampaignStatus read_campaign_status(const std::string& folder) {
  StatusReader reader;
  for (const std::string& path : campaign_files(folder)) {
    try {
      reader.read(path);
    } catch (const Error& error) {
      reader.add_problem(error);
    }
  }
  return reader.finish(folder);
}

}  // namespace slalom
