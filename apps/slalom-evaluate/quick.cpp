// SPDX-License-Identifier: BSD-3-Clause
#include "quick.h"

#include <slalom/campaign/describe_scenario.h>
#include <slalom/core/error.h>
#include <slalom/core/parallel.h>
#include <slalom/core/program_path.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/io/read_results.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <numeric>
#include <optional>

namespace slalom {
namespace {

constexpr int kSmallestSample = 20;
constexpr std::size_t kHashDigits = 16;  // of a hash in a table

/// How many shipped methods solve each scenario of a test bed.
struct DifficultyTable {
  std::string test_bed;
  std::map<std::string, double> solved_by;  ///< by the first digits of the scenario's hash
  std::map<std::string, double> success;    ///< by method
};

/// Reads a table as scripts/difficulty.py writes it: "# METHOD RATE, ...", names of the columns,
/// "HASH,NUMBER".
DifficultyTable read_difficulty(const std::filesystem::path& path) {
  DifficultyTable table;
  const std::string name = path.filename().string();
  table.test_bed = name.substr(0, name.find('.'));
  const std::vector<std::string> lines =
      split_nonempty(read_text(path.string(), "a table of difficulty"), '\n');
  const auto add = [&](const std::string& text, char separator, std::map<std::string, double>& to) {
    const std::vector<std::string> parts = split(text, separator);
    double number = 0;
    if (parts.size() != 2 || !parse_number(parts[1], number))
      throw file_error(path.string(), "'" + text + "'", "a name and a number");
    to[parts[0]] = number;
  };
  if (lines.empty() || !starts_with(lines[0], "# "))
    throw file_error(path.string(), "no methods in its first line", "# METHOD RATE, ...");
  for (const std::string& method : split(lines[0].substr(2), ',')) add(method, ' ', table.success);
  for (std::size_t i = 2; i < lines.size(); ++i) add(lines[i], ',', table.solved_by);
  return table;
}

/// The table that has all these scenarios.
std::optional<DifficultyTable> find_difficulty(const std::vector<std::string>& hashes) {
  const std::filesystem::path folder =
      std::filesystem::path(program_folder()) / "../share/slalom/configs/testbeds";
  if (!std::filesystem::is_directory(folder)) return std::nullopt;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (!ends_with(entry.path().string(), ".difficulty.csv")) continue;
    DifficultyTable table = read_difficulty(entry.path());
    if (std::all_of(hashes.begin(), hashes.end(), [&](const std::string& hash) {
          return table.solved_by.count(hash.substr(0, kHashDigits)) > 0;
        }))
      return table;
  }
  return std::nullopt;
}

/// The turn density of each scenario; infinite without a path.
std::vector<double> turn_densities(const std::vector<Scenario>& scenarios,
                                   const CampaignConfig& config, int jobs, Progress& progress) {
  DescribeOptions options = describe_options(config.options);
  options.ids = {"turn_density"};
  std::vector<double> densities;
  progress.start("Computing turn_density", scenarios.size());
  parallel_in_order(
      scenarios.size(), jobs,
      [&](std::size_t i) {
        MemoryDescriptorStore store;
        return describe_scenario(scenarios[i], options, store).front().value;
      },
      [&](const Value& value) {
        densities.push_back(value.is_na() ? std::numeric_limits<double>::infinity()
                                          : value.number());
        progress.advance(densities.size());
      });
  progress.finish();
  return densities;
}

/// The mean success of each scenario in which the method has a value, by hash.
std::map<std::string, double> success_by_scenario(const ResultTable& runs, std::size_t method) {
  const ValueColumn& success = *find_metric(runs, "success");
  std::map<std::string, std::pair<double, double>> sums;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    if (runs.method[run] != method || success.is_na(run)) continue;
    auto& [sum, count] = sums[runs.scenario_hashes[runs.scenario[run]]];
    sum += success.number(run);
    ++count;
  }
  std::map<std::string, double> means;
  for (const auto& [hash, sum] : sums) means[hash] = sum.first / sum.second;
  return means;
}

/// None if the method has no value in a stratum.
std::optional<StratifiedRate> estimate(const QuickSample& sample,
                                       const std::map<std::string, double>& success,
                                       double confidence) {
  Allocation known;
  std::vector<double> successes;
  for (std::size_t i = 0; i < sample.strata.size(); ++i) {
    known.push_back(0);
    successes.push_back(0);
    for (std::size_t k = 0; k < sample.sampled[i]; ++k) {
      const auto found = success.find(sample.hashes[sample.strata[i][k]]);
      if (found == success.end()) continue;
      ++known.back();
      successes.back() += found->second;
    }
    if (known.back() == 0) return std::nullopt;
  }
  return stratified_rate(sample.strata, known, successes, confidence);
}

/// ", rank 3 to 5": 1 more than the shipped methods that are better than the interval, to 1 more
/// than those that are better than its lower end. A method is not compared with itself.
std::string rank_text(const QuickSample& sample, const std::string& method,
                      const Interval& interval) {
  if (sample.shipped.empty()) return "";
  std::size_t best = 1, worst = 1;
  for (const auto& [name, rate] : sample.shipped) {
    if (name == method) continue;
    best += rate > interval.high ? 1 : 0;
    worst += rate > interval.low ? 1 : 0;
  }
  return ", rank " + std::to_string(best) + (worst > best ? " to " + std::to_string(worst) : "");
}

}  // namespace

std::size_t QuickSample::size() const {
  return std::accumulate(sampled.begin(), sampled.end(), std::size_t{0});
}

std::string QuickSample::text() const {
  return std::to_string(size()) + " of " + std::to_string(hashes.size()) +
         " scenarios, stratified by " + stratified_by;
}

void check_quick_size(int size) {
  if (size < kSmallestSample)
    throw usage_error("--quick " + std::to_string(size), "too few for an interval",
                      "at least " + std::to_string(kSmallestSample) + " scenarios");
}

QuickSample choose_quick_sample(const std::vector<Scenario>& scenarios, int size,
                                const CampaignConfig& config, int jobs, Progress& progress) {
  check_quick_size(size);
  const auto wanted = static_cast<std::size_t>(size);
  if (wanted > scenarios.size())
    throw usage_error("--quick " + std::to_string(size),
                      "the campaign has " + count_text(scenarios.size(), "scenario"),
                      "at most as many");
  QuickSample sample;
  for (const Scenario& scenario : scenarios) sample.hashes.push_back(scenario.hash());
  std::vector<double> values;
  if (const auto table = find_difficulty(sample.hashes)) {
    sample.stratified_by = "difficulty (how many of " + std::to_string(table->success.size()) +
                           " shipped methods solve a scenario of " + table->test_bed + ")";
    for (const std::string& hash : sample.hashes)
      values.push_back(table->solved_by.at(hash.substr(0, kHashDigits)));
    // The rates of the shipped methods are those of the whole test bed.
    if (table->solved_by.size() == scenarios.size()) sample.shipped = table->success;
  } else {
    sample.stratified_by = "turn_density (the difficulty is not known)";
    values = turn_densities(scenarios, config, jobs, progress);
  }
  RandomEngine engine(derive_seed(config.options.seed, "quick"));
  sample.strata = make_strata(values, kStrata, engine);
  sample.sampled = proportional_allocation(sample.strata, wanted);
  return sample;
}

std::vector<Scenario> sampled_scenarios(const QuickSample& sample,
                                        std::vector<Scenario> scenarios) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < sample.strata.size(); ++i)
    for (std::size_t k = 0; k < sample.sampled[i]; ++k) chosen.push_back(sample.strata[i][k]);
  std::sort(chosen.begin(), chosen.end());
  std::vector<Scenario> result;
  for (const std::size_t index : chosen) result.push_back(std::move(scenarios[index]));
  return result;
}

std::string quick_answer(const QuickSample& sample, const std::string& results_path,
                         double confidence) {
  ResultTable runs = read_results(results_path, {{"success"}});
  const std::vector<std::string> names = runs.methods;
  mark_privileged(runs);
  std::string text = "Success over all " + std::to_string(sample.hashes.size()) +
                     " scenarios, estimated from " + std::to_string(sample.size()) +
                     " of them, stratified by " + sample.stratified_by + "; " +
                     format_number(100 * confidence) + " % intervals\n";
  std::size_t width = 0;
  for (const std::string& name : runs.methods) width = std::max(width, name.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += runs.methods[i] + std::string(width + 2 - runs.methods[i].size(), ' ');
    const auto found = estimate(sample, success_by_scenario(runs, i), confidence);
    text += found ? format_fixed(found->rate, 2) + " [" + format_fixed(found->interval.low, 2) +
                        ", " + format_fixed(found->interval.high, 2) + "]" +
                        rank_text(sample, names[i], found->interval)
                  : "no estimate: no run with an outcome in a stratum";
    text += "\n";
  }
  if (!sample.shipped.empty())
    text += "The ranks are those among the " + std::to_string(sample.shipped.size()) +
            " shipped methods, for the robot and the times of configs/baselines.ini.\n";
  return text;
}

}  // namespace slalom
