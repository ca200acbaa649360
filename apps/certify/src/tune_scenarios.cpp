// SPDX-License-Identifier: BSD-3-Clause
#include "shuffle.h"
#include "tune_scenarios.h"

#include <slalom/campaign/describe_scenario.h>
#include <slalom/core/error.h>
#include <slalom/core/progress.h>
#include <slalom/core/text.h>
#include <slalom/map_formats/map_import.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace slalom {
namespace {

/// At least `count` scenarios of the generators and maps, from a stream of their own.
std::vector<Scenario> draw(const MethodCampaign& campaign, const std::string& label,
                           std::size_t count, int jobs) {
  IniFile ini = campaign.ini;
  const std::size_t maps = split(ini.get("scenarios", "maps").value_or(""), ',').size();
  ini.set("scenarios", "count", std::to_string(count), "");
  if (maps > 0)
    ini.set("scenarios", "pairs_per_map", std::to_string((count + maps - 1) / maps), "");
  const std::uint64_t seed = derive_seed(campaign.options.seed, "tune/" + label);
  const RobotModel& robot = campaign.options.robot;
  const ScenarioSources sources = read_scenario_sources(
      ini, source_context(robot, campaign.options.simulation.resolution, seed, jobs),
      load_occupancy_grid);
  const auto silent = make_silent_progress();
  std::vector<Scenario> scenarios = collect_scenarios(sources, load_occupancy_grid, *silent);
  RandomEngine engine(seed);
  if (maps > 0) shuffle(scenarios, engine);
  return scenarios;
}

/// Moves the first ones that are in no other set to a set of their own.
SharedScenarios take(std::vector<Scenario>& from, std::size_t count, std::set<std::string>& used) {
  auto set = std::make_shared<std::vector<Scenario>>();
  std::vector<Scenario> rest;
  for (Scenario& scenario : from) {
    if (set->size() == count)
      rest.push_back(std::move(scenario));
    else if (used.insert(scenario.hash()).second)
      set->push_back(std::move(scenario));
  }
  from = std::move(rest);
  return set;
}

/// Four quantile bins of the descriptor in turn.
SharedScenarios stratified(const SharedScenarios& scenarios, const MethodCampaign& campaign,
                           const std::string& id) {
  std::vector<double> values = descriptor_values(*scenarios, campaign, id);
  std::replace_if(
      values.begin(), values.end(), [](double value) { return std::isnan(value); },
      -std::numeric_limits<double>::infinity());
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  constexpr std::size_t kBins = 4;
  std::vector<std::vector<std::size_t>> bins(kBins);
  for (std::size_t rank = 0; rank < order.size(); ++rank)
    bins[rank * kBins / order.size()].push_back(order[rank]);
  // The order within a bin is that of the scenarios, which is random.
  for (auto& bin : bins) std::sort(bin.begin(), bin.end());
  auto sorted = std::make_shared<std::vector<Scenario>>();
  for (std::size_t i = 0; sorted->size() < order.size(); ++i)
    for (const auto& bin : bins)
      if (i < bin.size()) sorted->push_back((*scenarios)[bin[i]]);
  return sorted;
}

}  // namespace

TuneScenarios make_tune_scenarios(const MethodCampaign& campaign, const TuneSizes& sizes) {
  std::set<std::string> used;
  TuneScenarios sets;
  const std::string list = campaign.ini.get("scenarios", "list").value_or("");
  const std::size_t total = sizes.development + sizes.finals + sizes.sealed;
  if (!list.empty()) {
    std::vector<Scenario> all = draw(campaign, "list", 1, sizes.jobs);
    if (all.size() < total)
      throw usage_error(campaign.ini.where("scenarios", "list"),
                        "has " + count_text(all.size(), "scenario"),
                        "at least " + std::to_string(total) + " for --development, --finals and " +
                            "--sealed together, or smaller ones");
    RandomEngine engine(derive_seed(campaign.options.seed, "tune/list"));
    shuffle(all, engine);
    sets.development = take(all, sizes.development, used);
    sets.finals = take(all, sizes.finals, used);
    sets.sealed = take(all, sizes.sealed, used);
  } else {
    const auto set_of = [&](const std::string& label, std::size_t count) {
      // Some more, as those that are in another set are left out.
      std::vector<Scenario> drawn = draw(campaign, label, count + count / 10 + 10, sizes.jobs);
      return take(drawn, count, used);
    };
    sets.development = set_of("development", sizes.development);
    sets.finals = set_of("finals", sizes.finals);
    sets.sealed = set_of("sealed", sizes.sealed);
  }
  if (sets.development->size() + sets.finals->size() + sets.sealed->size() < total)
    throw usage_error(campaign.ini.where("scenarios"),
                      "the sources give too few different scenarios",
                      std::to_string(total) + " of them");
  sets.development = stratified(sets.development, campaign, sizes.stratify);
  return sets;
}

std::vector<double> descriptor_values(const std::vector<Scenario>& scenarios,
                                      const MethodCampaign& campaign, const std::string& id) {
  DescribeOptions options = describe_options(campaign.options);
  options.ids = {id};
  std::vector<double> values;
  for (const Scenario& scenario : scenarios) {
    MemoryDescriptorStore store;
    const Value value = describe_scenario(scenario, options, store).at(0).value;
    values.push_back(value.is_na() ? std::numeric_limits<double>::quiet_NaN() : value.number());
  }
  return values;
}

}  // namespace slalom
