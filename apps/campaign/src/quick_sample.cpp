// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/quick_sample.h>
#include <slalom/campaign/describe_scenario.h>
#include <slalom/core/error.h>
#include <slalom/core/parallel.h>
#include <slalom/core/program_path.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>

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
  const std::filesystem::path folder = shipped_file("configs/testbeds");
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

}  // namespace

std::size_t QuickSample::size() const {
  return std::accumulate(sampled.begin(), sampled.end(), std::size_t{0});
}

std::string QuickSample::text() const {
  return std::to_string(size()) + " of " + count_text(hashes.size(), "scenario") +
         ", stratified by " + stratified_by;
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

}  // namespace slalom
