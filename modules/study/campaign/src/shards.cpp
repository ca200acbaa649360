// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/campaign/campaign_options.h>
#include <slalom/campaign/shards.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/imported_table.h>
#include <slalom/io/merge_results.h>

#include <algorithm>
#include <numeric>

namespace slalom {
namespace {

bool parse_count(const std::string& text, std::size_t& count) {
  long long number = 0;
  if (!parse_integer(text, number) || number < 0) return false;
  count = static_cast<std::size_t>(number);
  return true;
}

}  // namespace

std::string to_string(const Shard& shard) {
  return std::to_string(shard.index) + "/" + std::to_string(shard.count);
}

Shard parse_shard(const std::string& text, const std::string& where) {
  const std::vector<std::string> parts = split(text, '/');
  Shard shard;
  const bool numbers =
      parts.size() == 2 && parse_count(parts[0], shard.index) && parse_count(parts[1], shard.count);
  if (!numbers || shard.index < 1 || shard.index > shard.count || shard.count > kMaxShards)
    throw usage_error(
        where, "invalid shard '" + text + "'",
        "I/N with I from 1 to N, N at most " + std::to_string(kMaxShards) + ", such as 3/16");
  return shard;
}

std::vector<Scenario> scenarios_of_shard(std::vector<Scenario> scenarios, const Shard& shard) {
  std::vector<std::string> hashes;
  for (const Scenario& scenario : scenarios) hashes.push_back(scenario.hash());
  std::vector<std::size_t> ranked(scenarios.size());
  std::iota(ranked.begin(), ranked.end(), std::size_t{0});
  std::sort(ranked.begin(), ranked.end(),
            [&](std::size_t a, std::size_t b) { return hashes[a] < hashes[b]; });
  std::vector<std::size_t> chosen;
  for (std::size_t rank = shard.index - 1; rank < ranked.size(); rank += shard.count)
    chosen.push_back(ranked[rank]);
  std::sort(chosen.begin(), chosen.end());
  std::vector<Scenario> part;
  for (const std::size_t i : chosen) part.push_back(std::move(scenarios[i]));
  return part;
}

std::size_t RunPlan::runs_of(const Shard& part) const {
  // The ranks index - 1, index - 1 + count, ... below the number of scenarios.
  return (scenarios + part.count - part.index) / part.count * runs_of_each;
}

RunPlan plan_of(const Manifest& manifest, const std::string& path) {
  const auto text = [&](const char* key) {
    const auto found = manifest.find(key);
    return found == manifest.end() ? std::string() : found->second;
  };
  expect_scenarios(manifest, path);
  RunPlan plan;
  if (manifest.count("until") > 0 || !parse_count(text("scenarios.count"), plan.scenarios))
    throw file_error(path, "the number of its runs is not known",
                     "a campaign without a stopping rule");
  if (!text(kShardKey).empty()) {
    try {
      plan.shard = parse_shard(text(kShardKey), path + ": manifest");
    } catch (const Error& e) {
      throw Error(ErrorKind::File, e.what());
    }
  }
  const IniFile ini = IniFile::from_text(text("campaign.ini"), path + ": campaign.ini");
  const auto campaign = read_options<CampaignSection>(ini, "campaign");
  plan.runs_of_each =
      split(campaign.methods, ',').size() * static_cast<std::size_t>(campaign.repetitions);
  return plan;
}

std::string number_ranges(const std::vector<std::size_t>& numbers) {
  std::vector<std::string> parts;
  for (std::size_t first = 0; first < numbers.size();) {
    std::size_t last = first;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    parts.push_back(std::to_string(numbers[first]) +
                    (last > first ? "-" + std::to_string(numbers[last]) : ""));
    first = last + 1;
  }
  return join(parts, ",");
}

}  // namespace slalom
