// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_means.h"

#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/sim2real.h>
#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/random.h>
#include <slalom/core/text.h>
#include <slalom/statistics/power.h>
#include <slalom/statistics/rank_statistics.h>
#include <slalom/statistics/statistics.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace slalom {
namespace {

constexpr int kBootstrapResamples = 2000;

/// Values of a method in one stratum: a common scenario, or everything.
struct Stratum {
  std::vector<double> real, simulated;
};

/// [method][stratum]; a stratum without real runs has no weight.
using Samples = std::vector<std::vector<Stratum>>;

/// The common scenarios: numbers of strata by scenario. Both are empty if there are none.
struct Strata {
  std::vector<std::size_t> of_real;                   ///< of each scenario of the real runs
  std::map<std::uint32_t, std::size_t> of_simulated;  ///< of the scenarios that are common
};

struct Means {
  std::vector<double> real, simulated;  ///< one per method
};

Means means_of(const Samples& samples) {
  Means means;
  for (const auto& strata : samples) {
    double real = 0, simulated = 0, count = 0;
    for (const Stratum& stratum : strata) {
      if (stratum.real.empty() || stratum.simulated.empty()) continue;
      const auto weight = static_cast<double>(stratum.real.size());
      real += weight * mean(stratum.real);
      simulated += weight * mean(stratum.simulated);
      count += weight;
    }
    means.real.push_back(real / count);
    means.simulated.push_back(simulated / count);
  }
  return means;
}

bool has_values(const Samples& samples) {
  return std::all_of(samples.begin(), samples.end(), [](const std::vector<Stratum>& strata) {
    return std::any_of(strata.begin(), strata.end(), [](const Stratum& stratum) {
      return !stratum.real.empty() && !stratum.simulated.empty();
    });
  });
}

std::vector<double> resampled(const std::vector<double>& values, RandomEngine& engine) {
  std::vector<double> result;
  for (std::size_t i = 0; i < values.size(); ++i)
    result.push_back(values[engine() % values.size()]);
  return result;
}

/// Simulated runs of common scenarios are not resampled: they are repeatable.
Samples resampled(const Samples& samples, bool has_scenarios, RandomEngine& engine) {
  const std::size_t strata = samples.front().size();
  std::vector<std::size_t> drawn;
  for (std::size_t i = 0; i < strata; ++i) drawn.push_back(engine() % strata);
  Samples result(samples.size());
  for (std::size_t method = 0; method < samples.size(); ++method)
    for (const std::size_t i : drawn) {
      const Stratum& stratum = samples[method][i];
      result[method].push_back(
          {resampled(stratum.real, engine),
           has_scenarios ? stratum.simulated : resampled(stratum.simulated, engine)});
    }
  return result;
}

/// The scenario of `simulated` with the hash or the name of a real one.
class ScenarioMatch {
 public:
  explicit ScenarioMatch(const ResultTable& simulated) {
    for (std::uint32_t i = 0; i < simulated.scenario_hashes.size(); ++i) {
      by_name_[simulated.scenario_names[i]].push_back(i);
      by_hash_[simulated.scenario_hashes[i]] = i;
    }
  }
  std::optional<std::uint32_t> find(const std::string& hash, const std::string& name) const {
    if (const auto found = by_hash_.find(hash); found != by_hash_.end()) return found->second;
    const auto named = by_name_.find(name);
    if (named == by_name_.end() || named->second.size() > 1) return std::nullopt;
    return named->second.front();
  }

 private:
  std::map<std::string, std::vector<std::uint32_t>> by_name_;
  std::map<std::string, std::uint32_t> by_hash_;
};

/// False for a table without a column of scenarios: each of its rows has one of its own.
bool names_scenarios(const ResultTable& table) {
  for (std::size_t i = 0; i < table.scenario_names.size(); ++i)
    if (table.scenario_names[i] != "row" + std::to_string(i + 1)) return true;
  return false;
}

Strata find_strata(const ResultTable& real, const ResultTable& simulated) {
  Strata strata;
  if (!names_scenarios(real)) return strata;
  const ScenarioMatch match(simulated);
  std::string missing;
  for (std::size_t i = 0; i < real.scenario_hashes.size(); ++i) {
    const auto found = match.find(real.scenario_hashes[i], real.scenario_names[i]);
    if (!found) {
      missing = real.scenario_names[i];
      continue;
    }
    const auto [stratum, is_new] = strata.of_simulated.emplace(*found, strata.of_simulated.size());
    strata.of_real.push_back(stratum->second);
  }
  if (!missing.empty() && !strata.of_real.empty())
    throw usage_error(real.source, "scenario '" + missing + "' is not in " + simulated.source,
                      "a name or hash that occurs there once");
  return strata;
}

Samples collect(const ResultTable& real, const ResultTable& simulated, const std::string& metric,
                const Strata& strata) {
  const bool has_scenarios = !strata.of_real.empty();
  const std::size_t count = has_scenarios ? strata.of_simulated.size() : 1;
  Samples samples(real.methods.size(), std::vector<Stratum>(count));
  const ValueColumn &of_real = require_metric(real, metric),
                    &of_simulated = require_metric(simulated, metric);
  for (std::size_t run = 0; run < real.size(); ++run) {
    if (of_real.is_na(run)) continue;
    const std::size_t stratum = has_scenarios ? strata.of_real[real.scenario[run]] : 0;
    samples[real.method[run]][stratum].real.push_back(of_real.number(run));
  }
  std::vector<std::vector<Stratum>*> by_method(simulated.methods.size(), nullptr);
  for (std::size_t i = 0; i < samples.size(); ++i)
    by_method[index_of_method(simulated, real.methods[i])] = &samples[i];
  for (std::size_t run = 0; run < simulated.size(); ++run) {
    std::vector<Stratum>* const of_method = by_method[simulated.method[run]];
    const auto stratum = strata.of_simulated.find(simulated.scenario[run]);
    const bool is_common = !has_scenarios || stratum != strata.of_simulated.end();
    if (of_method == nullptr || !is_common || of_simulated.is_na(run)) continue;
    (*of_method)[has_scenarios ? stratum->second : 0].simulated.push_back(of_simulated.number(run));
  }
  return samples;
}

using Figure = std::function<std::optional<double>(const Means&)>;

std::optional<double> pearson_of(const Means& means) {
  return pearson(means.real, means.simulated);
}
std::optional<double> kendall_of(const Means& means) {
  return kendall_tau(means.real, means.simulated);
}
std::optional<double> spearman_of(const Means& means) {
  return spearman(means.real, means.simulated, 0.95).rho;
}
std::optional<double> mmrv_of(const Means& means) {
  return mean_max_rank_violation(means.real, means.simulated);
}

/// The means with the methods of each side in an order of its own.
Means reordered(const Means& means, const std::vector<std::size_t>& real,
                const std::vector<std::size_t>& simulated) {
  Means result;
  for (const std::size_t i : real) result.real.push_back(means.real[i]);
  for (const std::size_t i : simulated) result.simulated.push_back(means.simulated[i]);
  return result;
}

enum class FigureKind { Ranks, Correlation, Violation };

Agreement agreement(const Figure& figure, FigureKind kind, const Means& means,
                    const std::vector<Means>& resamples, double confidence) {
  Agreement result;
  if (kind != FigureKind::Violation && means.real.size() < 3) {
    result.reason = "fewer than 3 methods";
    return result;
  }
  result.value = figure(means);
  if (!result.value) {
    result.reason = "all means are equal on one side";
    return result;
  }
  const auto real = ascending_order(means.real), simulated = ascending_order(means.simulated);
  std::vector<double> values, same_order;
  for (const Means& resample : resamples) {
    if (const auto value = figure(resample)) values.push_back(*value);
    if (kind != FigureKind::Ranks) continue;
    if (const auto value = figure(reordered(resample, real, simulated)))
      same_order.push_back(*value);
  }
  if (!values.empty()) result.interval = percentile_interval(std::move(values), confidence);
  result.ceiling = noise_ceiling(std::move(same_order), confidence);
  return result;
}

std::vector<double> real_values(const std::vector<Stratum>& strata) {
  std::vector<double> values;
  for (const Stratum& stratum : strata)
    if (!stratum.simulated.empty())
      values.insert(values.end(), stratum.real.begin(), stratum.real.end());
  return values;
}

std::optional<std::size_t> more_runs(const std::vector<double>& a, const std::vector<double>& b,
                                     double alpha, double power) {
  const double difference = std::abs(mean(a) - mean(b));
  if (difference <= tie_tolerance({mean(a), mean(b)})) return std::nullopt;
  const double deviation =
      math::hypot(standard_deviation(a).value_or(0), standard_deviation(b).value_or(0));
  const std::size_t now = std::min(a.size(), b.size());
  const std::size_t least = min_pairs(alpha);
  const std::size_t required =
      deviation > 0 ? std::max(least, required_pairs(difference, deviation, alpha, power)) : least;
  return required > now ? required - now : 0;
}

void require_methods(const ResultTable& real, const ResultTable& simulated) {
  for (const std::string& name : real.methods)
    if (!contains(simulated.methods, name))
      throw usage_error(real.source, "method '" + name + "' is not in " + simulated.source,
                        "a column method with some of " + join(simulated.methods, ", "));
  if (real.methods.size() < 2)
    throw usage_error(real.source, "only the method '" + join(real.methods, ", ") + "'",
                      "two methods or more, to be ordered");
}

}  // namespace

double mean_max_rank_violation(const std::vector<double>& real,
                               const std::vector<double>& simulated) {
  double sum = 0;
  for (std::size_t i = 0; i < real.size(); ++i) {
    double most = 0;
    for (std::size_t j = 0; j < real.size(); ++j)
      if ((simulated[i] < simulated[j]) != (real[i] < real[j]))
        most = std::max(most, std::abs(real[i] - real[j]));
    sum += most;
  }
  return sum / static_cast<double>(real.size());
}

Sim2Real sim2real(const ResultTable& real, const ResultTable& simulated, const std::string& metric,
                  const AnalysisOptions& options, double power) {
  require_valid(options);
  require_methods(real, simulated);
  const QuantityInfo& info = require_metric(simulated, metric).info();
  if (info.is_rate() && !require_metric(real, metric).info().is_rate())
    throw usage_error(real.source, "'" + metric + "' has other values than 0 and 1",
                      "0, 1 or NA in each line");
  if (info.direction == Direction::None)
    throw usage_error("--metric", "no value of '" + metric + "' is better than another",
                      "a metric that orders methods, such as success");
  Sim2Real result;
  result.metric = metric;
  result.unit = info.unit;
  result.confidence = options.confidence;
  result.power = power;
  const Strata strata = find_strata(real, simulated);
  result.scenarios = strata.of_simulated.size();
  const Samples samples = collect(real, simulated, metric, strata);
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (!has_values({samples[i]}))
      throw usage_error(real.source,
                        "method '" + real.methods[i] + "' has no value of '" + metric + "'",
                        "a number in a real and in a simulated run of the same scenario");
  const Means means = means_of(samples);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    Sim2RealMethod method{real.methods[i], 0, 0, means.real[i], means.simulated[i]};
    for (const Stratum& stratum : samples[i]) {
      if (stratum.real.empty() || stratum.simulated.empty()) continue;
      method.real_runs += stratum.real.size();
      method.simulated_runs += stratum.simulated.size();
    }
    result.methods.push_back(method);
  }
  RandomEngine engine(derive_seed(options.seed, "sim2real " + metric));
  std::vector<Means> resamples;
  for (int i = 0; i < kBootstrapResamples; ++i)
    if (const Samples resample = resampled(samples, result.scenarios > 0, engine);
        has_values(resample))
      resamples.push_back(means_of(resample));
  const auto of = [&](const Figure& figure, FigureKind kind) {
    return agreement(figure, kind, means, resamples, options.confidence);
  };
  result.spearman = of(spearman_of, FigureKind::Ranks);
  result.kendall = of(kendall_of, FigureKind::Ranks);
  result.pearson = of(pearson_of, FigureKind::Correlation);
  result.mmrv = of(mmrv_of, FigureKind::Violation);
  std::vector<std::size_t> order(samples.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return info.direction == Direction::Up ? means.real[a] > means.real[b]
                                           : means.real[a] < means.real[b];
  });
  const std::vector<Sim2RealMethod> unordered = std::exchange(result.methods, {});
  for (const std::size_t i : order) result.methods.push_back(unordered[i]);
  for (std::size_t i = 1; i < order.size(); ++i)
    result.orders.push_back(
        {result.methods[i - 1].name, result.methods[i].name,
         more_runs(real_values(samples[order[i - 1]]), real_values(samples[order[i]]),
                   test_level(options.confidence), power)});
  return result;
}

}  // namespace slalom
