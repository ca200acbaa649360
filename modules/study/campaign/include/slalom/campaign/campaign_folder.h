// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/campaign/shards.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace slalom {

enum class ShardState {
  Done,     ///< all runs are there
  Running,  ///< a program writes the file, within the last kSilentSeconds if it is on another host
  Stale,    ///< a program wrote the file and is gone without removing its lock
  Failed,   ///< runs are missing and no program writes the file, or it cannot be read
  Missing   ///< there is no file
};
constexpr auto enum_names(ShardState) {
  return std::array{"done", "running", "stale", "failed", "missing"};
}

constexpr int kSilentSeconds = 900;

/// The state of one shard of a campaign.
struct ShardStatus {
  std::size_t shard = 1;
  ShardState state = ShardState::Missing;
  std::string path;  ///< "" if missing
  std::size_t runs = 0, planned = 0;
  std::size_t infrastructure_errors = 0;  ///< among the runs
  std::string holder;                     ///< the program that writes it
  /// Of a running shard that was not resumed; 0 if it cannot be measured.
  double runs_per_second = 0;
};

/// The state of a campaign, from its files alone.
struct CampaignStatus {
  RunPlan plan;
  std::vector<ShardStatus> shards;    ///< by number
  std::vector<std::string> problems;  ///< one line for each file that is not part of it

  std::size_t runs() const;
  double runs_per_second() const;               ///< of all shards for which it can be measured
  double seconds_left() const;                  ///< until the last of these shards is done
  std::vector<std::size_t> unfinished() const;  ///< shards that are neither done nor running
};

/// The status of the campaign whose result files are in a folder. Throws Error (File) if there is
/// none.
CampaignStatus read_campaign_status(const std::string& folder);

}  // namespace slalom
