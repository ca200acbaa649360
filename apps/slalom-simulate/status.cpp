// SPDX-License-Identifier: BSD-3-Clause
#include "verbs.h"

#include <slalom/campaign/campaign_folder.h>
#include <slalom/core/enum_names.h>
#include <slalom/core/text.h>

#include <nlohmann/json.hpp>

#include <iostream>

namespace slalom {
namespace {

struct StatusArguments {
  std::string folder;
  bool missing = false, json = false;
};

std::string status_json(const CampaignStatus& status) {
  nlohmann::json json = {{"runs", status.runs()},
                         {"planned", status.plan.runs()},
                         {"missing", number_ranges(status.unfinished())},
                         {"problems", status.problems},
                         {"runs_per_second", nullptr},
                         {"seconds_left", nullptr},
                         {"shards", nlohmann::json::array()}};
  if (status.runs_per_second() > 0) {
    json["runs_per_second"] = status.runs_per_second();
    json["seconds_left"] = status.seconds_left();
  }
  for (const ShardStatus& shard : status.shards)
    json["shards"].push_back({{"shard", shard.shard},
                              {"state", to_string(shard.state)},
                              {"file", shard.path},
                              {"runs", shard.runs},
                              {"planned", shard.planned},
                              {"infrastructure_errors", shard.infrastructure_errors},
                              {"holder", shard.holder}});
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string status_text(const CampaignStatus& status) {
  std::string text = std::to_string(status.runs()) + " of " + std::to_string(status.plan.runs()) +
                     " runs in " + count_text(status.shards.size(), "shard") + "\n";
  std::size_t errors = 0;
  for (const ShardState state : enum_values<ShardState>()) {
    std::vector<std::size_t> numbers;
    for (const ShardStatus& shard : status.shards)
      if (shard.state == state) numbers.push_back(shard.shard);
    if (!numbers.empty()) text += "  " + to_string(state) + ": " + number_ranges(numbers) + "\n";
  }
  for (const ShardStatus& shard : status.shards) {
    errors += shard.infrastructure_errors;
    if (shard.state == ShardState::Failed || shard.state == ShardState::Stale)
      text += "shard " + std::to_string(shard.shard) + ": " + std::to_string(shard.runs) + " of " +
              std::to_string(shard.planned) + " runs in " + shard.path + "\n";
  }
  if (errors > 0) text += std::to_string(errors) + " runs ended as infrastructure_error\n";
  if (status.runs_per_second() > 0)
    text += format_fixed(status.runs_per_second(), 1) + " runs/s, " +
            format_fixed(status.seconds_left() / 60, 1) + " min left for the running shards\n";
  for (const std::string& problem : status.problems) text += problem + "\n";
  return text;
}

void show_status(const StatusArguments& arguments) {
  const CampaignStatus status = read_campaign_status(arguments.folder);
  if (arguments.missing)
    std::cout << number_ranges(status.unfinished()) << "\n";
  else if (arguments.json)
    std::cout << status_json(status) << "\n";
  else
    std::cout << status_text(status);
}

}  // namespace

void define_status(CLI::App& app) {
  static StatusArguments arguments;
  CLI::App* verb = app.add_subcommand("status", "Show the state of a campaign's shards");
  verb->add_option("folder", arguments.folder, "The folder with their result files")->required();
  CLI::Option* missing = verb->add_flag(
      "--missing", arguments.missing,
      "Only the numbers of the shards that are neither done nor running, such as 3,7,12-15");
  verb->add_flag("--json", arguments.json, "JSON")->excludes(missing);
  verb->callback([] { show_status(arguments); });
}

}  // namespace slalom
