// SPDX-License-Identifier: BSD-3-Clause
// How often the interval of a campaign that stopped by its width holds the true mean, and how many
// scenarios that took: the table of docs/campaigns.md. One method in one bin; rates are computed
// exactly by the test of look_confidence().
//
//   build/release/bin/stopping_simulation [CAMPAIGNS]

#include <slalom/analysis/precision_rule.h>
#include <slalom/core/random.h>

#include <fmt/core.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <string>
#include <vector>

namespace slalom {
namespace {

/// The values of the runs of one scenario, and their true mean over all scenarios.
struct Source {
  std::string name;
  double mean;
  std::function<std::vector<double>(RandomEngine&)> draw;
  double deviation;  ///< of scenarios' means
};

double exponential(RandomEngine& engine) {
  return -std::log1p(-uniform_real(engine, 0, 1));
}

std::vector<Source> sources() {
  const auto normal_value = [](RandomEngine& e) { return std::vector{normal(e, 0, 1)}; };
  const auto skewed = [](RandomEngine& e) { return std::vector{std::exp(normal(e, 0, 0.5))}; };
  const auto very_skewed = [](RandomEngine& e) { return std::vector{exponential(e)}; };
  const auto with_na = [](RandomEngine& e) {
    std::vector<double> values;
    if (uniform_real(e, 0, 1) < 0.7) values.push_back(exponential(e));
    return values;
  };
  const auto repeated = [](RandomEngine& e) {
    const double scenario = normal(e, 0, 1);
    std::vector<double> values;
    for (int i = 0; i < 5; ++i) values.push_back(scenario + normal(e, 0, 0.5));
    return values;
  };
  const double lognormal = std::exp(0.125);
  return {{"normal", 0, normal_value, 1},
          {"lognormal, sigma 0.5", lognormal, skewed, lognormal * std::sqrt(std::expm1(0.25))},
          {"exponential", 1, very_skewed, 1},
          {"exponential, 30 % NA", 1, with_na, 1 / std::sqrt(0.7)},
          {"five repetitions", 0, repeated, std::sqrt(1 + 0.05)}};
}

struct Result {
  double coverage = 0, scenarios = 0;
};

Result simulate(const Source& source, double width, double confidence, std::size_t first,
                int campaigns) {
  Result result;
  for (int i = 0; i < campaigns; ++i) {
    RandomEngine engine(derive_seed(1, source.name, static_cast<std::uint64_t>(i)));
    ScenarioGroups groups;
    std::size_t scenarios = 0;
    for (;;) {
      const std::size_t next = scenarios == 0 ? first : scenarios + (scenarios + 1) / 2;
      for (; scenarios < next; ++scenarios) {
        const auto values = source.draw(engine);
        if (!values.empty()) groups.push_back(values);
      }
      RandomEngine bootstrap(derive_seed(2, source.name, static_cast<std::uint64_t>(i)));
      const auto interval = mean_interval(sums_of(groups), confidence, bootstrap);
      if (!interval || interval->high - interval->low >= width) continue;
      result.coverage += interval->low <= source.mean && source.mean <= interval->high;
      break;
    }
    result.scenarios += static_cast<double>(scenarios);
  }
  result.coverage /= campaigns;
  result.scenarios /= campaigns;
  return result;
}

void print_table(int campaigns) {
  fmt::print(
      "| values | scenarios needed | stopped by the width | fixed number |\n|---|---|---|---|\n");
  for (const Source& source : sources())
    for (const double needed : {30.0, 100.0}) {
      const double width = 2 * 1.96 * source.deviation / std::sqrt(needed);
      const Result stopped = simulate(source, width, look_confidence(0.95), 10, campaigns);
      const Result fixed = simulate(source, 1e9, 0.95, static_cast<std::size_t>(needed), campaigns);
      fmt::print("| {} | {} | {:.3f} after {:.0f} | {:.3f} |\n", source.name, needed,
                 stopped.coverage, stopped.scenarios, fixed.coverage);
    }
}

}  // namespace
}  // namespace slalom

int main(int argc, char** argv) try {
  slalom::print_table(argc > 1 ? std::atoi(argv[1]) : 2000);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
