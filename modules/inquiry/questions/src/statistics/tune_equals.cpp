// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/inquiry/tune_equals.h>
#include <slalom/statistics/paired_rates.h>
#include <slalom/statistics/statistics.h>

#include <algorithm>

namespace slalom {
namespace {

/// The fewest development scenarios of an elite: those of the last rung.
std::size_t last_rung(const TuneResult& result) {
  const std::vector<std::size_t>& elites = result.elites.back();
  const auto runs = [&](std::size_t i) { return result.candidates[i].development.size(); };
  return runs(*std::min_element(elites.begin(), elites.end(),
                                [&](std::size_t a, std::size_t b) { return runs(a) < runs(b); }));
}

/// The point of `a`, compared with `b` instead of the winner.
FrontPoint compare(const TuneResult& result, std::size_t a, std::size_t b) {
  const auto &finals = result.candidates[a].finals, &others = result.candidates[b].finals;
  FrontPoint point{a};
  for (std::size_t i = 0; i < finals.size(); ++i) {
    const TuneOutcome &one = finals[i], &other = others[i];
    if (!one.success || !other.success || !one.secondary || !other.secondary) continue;
    const double difference = *one.secondary - *other.secondary;
    point.minus_winner += (difference - point.minus_winner) / static_cast<double>(++point.common);
  }
  return point;
}

}  // namespace

TiedConfigurations statistically_tied(const TuneResult& result, double confidence) {
  const TuneCandidate& winner = result.candidates[result.winner];
  const std::size_t rung = last_rung(result);
  std::vector<std::size_t> others;
  std::vector<double> p;
  for (std::size_t i = 0; i < result.candidates.size(); ++i) {
    const TuneCandidate& other = result.candidates[i];
    const bool finalist = std::count(result.finalists.begin(), result.finalists.end(), i) > 0;
    const bool in_rung = std::min(other.development.size(), winner.development.size()) >= rung;
    if (i == result.winner || (!finalist && !in_rung)) continue;
    others.push_back(i);
    p.push_back(finalist ? success_p_value(other.finals, winner.finals)
                         : success_p_value(other.development, winner.development));
  }
  const std::vector<double> adjusted = holm_adjusted(p);
  TiedConfigurations equals{others.size(), {result.winner}};
  for (std::size_t i = 0; i < others.size(); ++i)
    if (adjusted[i] > test_level(confidence)) equals.candidates.push_back(others[i]);
  return equals;
}

std::vector<FrontPoint> pareto_front(const TuneResult& result) {
  std::vector<FrontPoint> front;
  for (const std::size_t b : result.finalists)
    if (std::none_of(result.finalists.begin(), result.finalists.end(), [&](std::size_t a) {
          const double more = counts_of(result.candidates[a].finals).rate() -
                              counts_of(result.candidates[b].finals).rate();
          const double difference = compare(result, a, b).minus_winner;
          return more >= 0 && difference <= 0 && (more > 0 || difference < 0);
        }))
      front.push_back(compare(result, b, result.winner));
  return front;
}

}  // namespace slalom
