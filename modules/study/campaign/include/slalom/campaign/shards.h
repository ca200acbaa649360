// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/run_record.h>
#include <slalom/scenario/scenario.h>

#include <cstddef>
#include <string>
#include <vector>

namespace slalom {

/// Part `index` (1 to `count`) of a campaign that is divided into `count` parts by scenario. The
/// scenario of rank r (from 0) in the order of content hashes belongs to shard r mod count + 1, so
/// that shards are balanced and do not depend on the order of the list, the methods or the
/// repetitions. There may be more shards than scenarios; those without scenarios are empty.
struct Shard {
  std::size_t index = 1, count = 1;
};

/// "3/16".
std::string to_string(const Shard& shard);

/// Reads "I/N". Throws Error (Usage) at `where` unless 1 <= I <= N <= kMaxShards.
Shard parse_shard(const std::string& text, const std::string& where);

constexpr std::size_t kMaxShards = 1000000;

/// The scenarios of a shard, in the order of the list.
std::vector<Scenario> scenarios_of_shard(std::vector<Scenario> scenarios, const Shard& shard);

/// The contents of a complete result file.
struct RunPlan {
  Shard shard;                   ///< 1/1: the complete campaign
  std::size_t scenarios = 0;     ///< of the complete campaign
  std::size_t runs_of_each = 0;  ///< runs in each scenario: methods x repetitions

  std::size_t runs() const { return scenarios * runs_of_each; }  ///< of the complete campaign
  std::size_t runs_of(const Shard& part) const;                  ///< of one of its shards
};

/// The plan of the result file at `path` with this manifest. Throws Error (File) if it has none: a
/// campaign with a stopping rule.
RunPlan plan_of(const Manifest& manifest, const std::string& path);

/// Numbers in increasing order as "3,7,12-15".
std::string number_ranges(const std::vector<std::size_t>& numbers);

}  // namespace slalom
