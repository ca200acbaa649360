// SPDX-License-Identifier: BSD-3-Clause
#include "rule_text.h"
#include "scenario_means.h"

#include <slalom/analysis/cell.h>
#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/decision_rule.h>
#include <slalom/core/error.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>
#include <slalom/statistics/betting.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace slalom {
namespace {

constexpr const char* kExpected =
    "\"compare(METRIC, METHOD, REFERENCE) decided\", \"... decided within DIFFERENCE\" or "
    "\"... no worse than DIFFERENCE\"";

/// Bound of the difference of two means over runs.
double bound_of(const std::string& metric, const Range& range) {
  if (range.is_bounded()) return range.high - range.low;
  throw usage_error("--until", "'" + metric + "' is not bounded, so that no number of runs decides",
                    "a metric with a lowest and a highest value, such as success or spl");
}

/// The tests of a rule, each with the level at which it rejects.
class DecisionTests {
 public:
  DecisionTests(const DecisionRule& rule, double level) : rule_(rule), level_(level) {
    const double bound = rule.bound, d = rule.relevant;
    if (rule.no_worse)
      tests_ = {{-d, d, bound}, {-d, -d, bound}};
    else
      tests_ = {{0, d, bound}, {0, -d, bound}, {-d, d, bound}, {d, -d, bound}};
  }

  void add(double advantage) {
    for (BettingTest& test : tests_) test.add(advantage);
    sum_ += advantage;
    ++count_;
  }

  double mean() const { return count_ == 0 ? 0 : sum_ / static_cast<double>(count_); }

  /// With its p value. A test keeps the evidence of the scenarios before, which the mean of all may
  /// contradict: the decision is then still open.
  std::pair<Decision, double> decision() const {
    const auto [decision, p] = rejection();
    return {is_consistent(decision) ? decision : Decision::Open, p};
  }

 private:
  bool is_consistent(Decision decision) const {
    const double d = rule_.relevant;
    switch (decision) {
      case Decision::Better:
        return mean() > 0;
      case Decision::Worse:
        return mean() < (rule_.no_worse ? -d : 0);
      case Decision::NoRelevantDifference:
        return std::abs(mean()) < d;
      case Decision::NoWorse:
        return mean() > -d;
      case Decision::Open:
        break;
    }
    return true;
  }

  std::pair<Decision, double> rejection() const {
    const double p0 = tests_[0].p(), p1 = tests_[1].p();
    if (rule_.no_worse) {
      if (p0 <= level_) return {Decision::NoWorse, p0};
      return {p1 <= level_ ? Decision::Worse : Decision::Open, p1};
    }
    if (p0 <= level_ / 2) return {Decision::Better, 2 * p0};
    if (p1 <= level_ / 2) return {Decision::Worse, 2 * p1};
    const double p = std::max(tests_[2].p(), tests_[3].p());
    return {p <= level_ ? Decision::NoRelevantDifference : Decision::Open, p};
  }

  const DecisionRule& rule_;
  double level_, sum_ = 0;
  std::size_t count_ = 0;
  std::vector<BettingTest> tests_;
};

std::string decision_text(const DecisionRule& rule, Decision decision) {
  const std::string method = printable_line(rule.method), other = printable_line(rule.reference),
                    relevant = format_number(rule.relevant);
  switch (decision) {
    case Decision::Better:
      return method + " is better than " + other;
    case Decision::Worse:
      return method + " is worse than " + other +
             (rule.no_worse ? " by more than " + relevant : "");
    case Decision::NoRelevantDifference:
      return method + " and " + other + " differ by less than " + relevant;
    case Decision::NoWorse:
      return method + " is not worse than " + other + " by " + relevant;
    case Decision::Open:
      break;
  }
  return "not decided between " + method + " and " + other;
}

}  // namespace

DecisionRule parse_decision_rule(const std::string& text,
                                 const std::function<Range(const std::string&)>& range_of_metric) {
  const auto found = match_rule(
      text,
      "[[:space:]]*compare\\([[:space:]]*([^,[:space:]]+)[[:space:]]*,[[:space:]]*([^,[:space:]]+)"
      "[[:space:]]*,[[:space:]]*([^,[:space:])]+)[[:space:]]*\\)[[:space:]]*"
      "(decided([[:space:]]+within[[:space:]]+([^[:space:]]+))?|"
      "no[[:space:]]+worse[[:space:]]+than[[:space:]]+([^[:space:]]+))[[:space:]]*");
  DecisionRule rule;
  if (found) {
    rule.no_worse = (*found)[7].has_value();
    const auto& relevant = rule.no_worse ? (*found)[7] : (*found)[6];
    if (relevant && !parse_number(*relevant, rule.relevant)) rule.relevant = 0;
  }
  if (!found || !(rule.relevant > 0))
    throw usage_error("--until", "invalid stopping rule '" + text + "'", kExpected);
  rule.metric = *(*found)[1];
  rule.method = *(*found)[2];
  rule.reference = *(*found)[3];
  rule.bound = bound_of(rule.metric, range_of_metric(rule.metric));
  if (rule.relevant >= rule.bound)
    throw usage_error("--until",
                      "a difference of " + format_number(rule.relevant) + " in " + rule.metric,
                      "less than " + format_number(rule.bound));
  return rule;
}

DecisionState decide(const DecisionRule& rule, const std::vector<double>& advantages,
                     double confidence) {
  DecisionTests tests(rule, test_level(confidence));
  DecisionState state;
  for (const double advantage : advantages) {
    tests.add(advantage);
    ++state.scenarios;
    std::tie(state.decision, state.p) = tests.decision();
    if (state.decision != Decision::Open) break;
  }
  state.advantage = tests.mean();
  return state;
}

std::vector<double> scenario_advantages(const ResultTable& runs, const DecisionRule& rule,
                                        const std::vector<std::string>& hashes) {
  const ValueColumn& values = require_metric(runs, rule.metric);
  const Direction direction = values.info().direction;
  if (direction == Direction::None)
    throw usage_error("--until", "neither more nor less of '" + rule.metric + "' is better",
                      "a metric with a better direction");
  const auto of_method = scenario_means(runs, index_of_method(runs, rule.method), values),
             of_reference = scenario_means(runs, index_of_method(runs, rule.reference), values);
  std::map<std::string, std::size_t> index;
  for (std::size_t i = 0; i < runs.scenario_hashes.size(); ++i) index[runs.scenario_hashes[i]] = i;
  std::vector<double> advantages;
  for (const std::string& hash : hashes) {
    const auto found = index.find(hash);
    if (found == index.end()) continue;
    const auto &mine = of_method[found->second], &other = of_reference[found->second];
    if (mine && other)
      advantages.push_back(direction == Direction::Up ? *mine - *other : *other - *mine);
  }
  return advantages;
}

std::string decision_sentence(const DecisionRule& rule, const DecisionState& state) {
  std::string text = decision_text(rule, state.decision) + " in " + rule.metric +
                     ": mean advantage " + (state.advantage < 0 ? "-" : "+") +
                     format_fixed(std::abs(state.advantage), 3) + " over " +
                     std::to_string(state.scenarios) + " scenarios";
  if (state.decision != Decision::Open) text += ", " + p_text(state.p);
  return text;
}

}  // namespace slalom
