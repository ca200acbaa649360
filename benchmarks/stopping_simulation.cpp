// SPDX-License-Identifier: BSD-3-Clause
// How often the interval of a campaign that stopped by its width holds the true mean, and how many
// scenarios that took: the table of docs/guide/campaigns.md. One method in one bin; rates are
// computed exactly by the test of look_confidence().
//
//   build/release/bin/stopping_simulation [CAMPAIGNS]

#include <slalom/analysis/precision_rule.h>
#include <slalom/core/random.h>
#include <slalom/statistics/mean_interval.h>

#include <fmt/core.h>

#include <algorithm>
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
  bool is_score;
  double mean;
  std::function<std::vector<double>(RandomEngine&)> draw;
  double deviation;  ///< of scenarios' means
};

/// A gamma variable of integer shape is a sum of exponential ones.
double gamma_value(RandomEngine& engine, int shape) {
  double sum = 0;
  for (int i = 0; i < shape; ++i) sum -= std::log1p(-uniform_real(engine, 0, 1));
  return sum;
}

double beta_value(RandomEngine& engine, int a, int b) {
  const double x = gamma_value(engine, a);
  return x / (x + gamma_value(engine, b));
}

/// 0 for a failure, else Beta(20, 3).
Source score(double success, int repetitions) {
  const double given = 20.0 / 23, square = 20.0 * 21 / (23 * 24), mean = success * given;
  const auto draw = [success, repetitions](RandomEngine& engine) {
    std::vector<double> values;
    for (int i = 0; i < repetitions; ++i)
      values.push_back(uniform_real(engine, 0, 1) < success ? beta_value(engine, 20, 3) : 0);
    return values;
  };
  return {fmt::format("score, success {}{}", success,
                      repetitions > 1 ? fmt::format(", {} repetitions", repetitions) : ""),
          true, mean, draw, std::sqrt((success * square - mean * mean) / repetitions)};
}

/// Bounded values that are no score.
Source beta(int a, int b) {
  const double mean = static_cast<double>(a) / (a + b);
  return {fmt::format("Beta({}, {})", a, b), false, mean,
          [a, b](RandomEngine& engine) { return std::vector{beta_value(engine, a, b)}; },
          std::sqrt(mean * (1 - mean) / (a + b + 1))};
}

std::vector<Source> sources() {
  return {score(0.95, 1), score(0.8, 1), score(0.8, 5), beta(8, 2), beta(1, 4)};
}

Interval interval_of(const Source& source, const ScenarioGroups& groups, double confidence) {
  const GroupSums sums = sums_of(groups);
  if (!source.is_score)
    return *gaffke_interval(moments_of(sums), sums, Range::between(0, 1), confidence);
  std::vector<double> positives;
  for (const auto& group : groups)
    positives.push_back(static_cast<double>(group.size()) -
                        static_cast<double>(std::count(group.begin(), group.end(), 0.0)));
  return hurdle_interval(score_moments(sums, positives), 1, confidence);
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
      for (; scenarios < next; ++scenarios) groups.push_back(source.draw(engine));
      const Interval interval = interval_of(source, groups, confidence);
      if (interval.high - interval.low >= width) continue;
      result.coverage += interval.low <= source.mean && source.mean <= interval.high;
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
