// SPDX-License-Identifier: BSD-3-Clause
#include "acceptance.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/csv_columns.h>
#include <slalom/core/text.h>
#include <slalom/statistics/distributions.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace slalom {
namespace {

constexpr double kReliability = 0.95;  ///< that the needed runs would show

/// The number of runs with `events` events whose lower bound of runs without one is kReliability.
std::size_t runs_for_reliability(std::size_t events, double confidence) {
  const double e = static_cast<double>(events);
  std::size_t low = events + 1, high = low;
  const auto shows = [&](std::size_t n) {
    const double all = static_cast<double>(n);
    return distributions::binomial_lower_bound(all - e, all, 1 - confidence) >= kReliability;
  };
  while (!shows(high)) low = high, high *= 2;
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (shows(middle))
      high = middle;
    else
      low = middle + 1;
  }
  return high;
}

/// "20 of 20 runs without collision: at least 0.86 with 95 % confidence; 39 more without one ...".
std::string reliability_text(std::size_t events, std::size_t runs, const std::string& without,
                             double confidence) {
  const double good = static_cast<double>(runs - events);
  const double bound =
      distributions::binomial_lower_bound(good, static_cast<double>(runs), 1 - confidence);
  std::string text = std::to_string(runs - events) + " of " + count_text(runs, "run") + " " +
                     without + ": at least " + format_fixed(std::floor(100 * bound) / 100, 2) +
                     " with " + percent_text(confidence) + " % confidence, if they are independent";
  const std::size_t needed = runs_for_reliability(events, confidence);
  if (needed > runs)
    text += "; " + std::to_string(needed - runs) + " more " + without + " would show " +
            format_number(kReliability);
  return text;
}

/// The first column with one of these names whose values are known in all of the runs.
const ValueColumn* complete_column(const ResultTable& table, const std::vector<std::string>& names,
                                   const std::vector<std::size_t>& runs) {
  for (const std::string& name : names) {
    const ValueColumn* column = find_unconditional(table, name);
    if (column == nullptr) continue;
    const bool complete = std::all_of(runs.begin(), runs.end(), [&](std::size_t run) {
      return !column->is_na(run) && column->number(run) >= 0;
    });
    if (complete) return column;
  }
  return nullptr;
}

/// "2 collisions in 3.4 km: 0.59 per km [0.07, 2.13]".
std::string rate_text(std::size_t events, double exposure, const std::string& unit,
                      double confidence) {
  const double tail = (1 - confidence) / 2, e = static_cast<double>(events);
  const double low =
      events == 0 ? 0 : distributions::chi_squared_quantile(tail, 2 * e) / 2 / exposure;
  const double high = distributions::chi_squared_quantile(1 - tail, 2 * e + 2) / 2 / exposure;
  return count_text(events, "collision") + " in " + format_fixed(exposure, 3) + " " + unit + ": " +
         format_fixed(e / exposure, 2) + " per " + unit + " [" + format_fixed(low, 2) + ", " +
         format_fixed(high, 2) + "]";
}

/// The runs of a method with a known outcome; without success in the table those of which a column
/// says whether they collided.
std::vector<std::size_t> known_runs(const ResultTable& table, std::size_t method) {
  const ValueColumn* collided =
      find_metric(table, "success") == nullptr ? collision_column(table) : nullptr;
  std::vector<std::size_t> runs;
  for (std::size_t run = 0; run < table.size(); ++run) {
    const bool is_known = collided != nullptr
                              ? !collided->is_na(run)
                              : !success_of(table.outcomes[table.outcome[run]]).is_na();
    if (table.method[run] == method && is_known) runs.push_back(run);
  }
  return runs;
}

std::vector<std::string> sentences_of(const ResultTable& table, std::size_t method,
                                      double confidence) {
  const std::vector<std::size_t> runs = known_runs(table, method);
  if (runs.empty()) return {};
  std::map<std::string, std::size_t> outcomes;
  for (const std::size_t run : runs) ++outcomes[table.outcomes[table.outcome[run]]];
  std::vector<std::string> sentences;
  if (find_metric(table, "success") != nullptr)
    sentences.push_back(reliability_text(runs.size() - outcomes["success"], runs.size(),
                                         "with success", confidence));
  else if (collision_column(table) == nullptr)
    return {};
  const bool collisions_known =
      outcomes["failure"] == 0 && contains(table.outcomes, std::string("collision"));
  if (!collisions_known) return sentences;
  const std::size_t collisions = outcomes["collision"];
  sentences.push_back(reliability_text(collisions, runs.size(), "without collision", confidence));
  constexpr double kMetersPerKm = 1000, kSecondsPerHour = 3600;
  const auto add_rate = [&](const ValueColumn* column, double scale, const std::string& unit,
                            const std::string& of_column) {
    double sum = 0;
    for (const std::size_t run : runs) sum += column == nullptr ? 0 : column->number(run) / scale;
    if (sum > 0)
      sentences.push_back(rate_text(collisions, sum, unit, confidence) + ", by " +
                          column->info().id + " in " + of_column);
  };
  add_rate(complete_column(table, {"path_length", "distance", "traveled"}, runs), kMetersPerKm,
           "km", "m");
  add_rate(complete_column(table, {"duration", "time", "time_to_goal"}, runs), kSecondsPerHour, "h",
           "s");
  return sentences;
}

}  // namespace

std::vector<std::string> acceptance_sentences(const ResultTable& table, const std::string& method,
                                              double confidence) {
  std::vector<std::string> all;
  if (!is_foreign(table)) return all;
  for (std::size_t i = 0; i < table.methods.size(); ++i) {
    if (!method.empty() && table.methods[i] != method) continue;
    for (const std::string& sentence : sentences_of(table, i, confidence))
      all.push_back(table.methods[i] + ": " + sentence);
  }
  return all;
}

}  // namespace slalom
