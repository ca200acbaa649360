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

using Question = DecisionRule::Question;

constexpr const char* kExpected =
    "\"compare(METRIC, METHOD, REFERENCE) decided\", \"... decided within DIFFERENCE\", "
    "\"... no worse than DIFFERENCE\", each with \"in the pool\" or without, or "
    "\"... decided in more scenarios\"";

/// Bound of the difference of two means over runs.
double bound_of(const std::string& metric, const Range& range) {
  if (range.is_bounded()) return range.high - range.low;
  throw usage_error("--until", "'" + metric + "' is not bounded, so that no number of runs decides",
                    "a metric with a lowest and a highest value, such as success or spl");
}

/// A share of 0.65 of the scenarios in which two methods differ.
constexpr double kMajorityEffect = 0.3;

/// The tests of a rule, each with the level at which it rejects.
class DecisionTests {
 public:
  DecisionTests(const DecisionRule& rule, double level, std::size_t pool)
      : rule_(rule), level_(level) {
    const double d = rule.relevant;
    const auto add = [&](double null, double effect) {
      tests_.emplace_back(null, effect, rule.bound, rule.in_pool ? pool : 0);
    };
    if (rule.question == Question::Majority) {
      tests_ = {{0, kMajorityEffect, 1}, {0, -kMajorityEffect, 1}};
    } else if (rule.question == Question::NoWorse) {
      add(-d, d);
      add(-d, -d);
    } else {
      add(0, d);
      add(0, -d);
      add(-d, d);
      add(d, -d);
    }
  }

  void add(double advantage) {
    sum_ += advantage;
    ++state_.scenarios;
    state_.advantage = sum_ / static_cast<double>(state_.scenarios);
    state_.better += advantage > 0;
    state_.worse += advantage < 0;
    const bool majority = rule_.question == Question::Majority;
    if (majority && advantage == 0) return;
    for (BettingTest& test : tests_) test.add(!majority ? advantage : advantage > 0 ? 1 : -1);
    // A test keeps the evidence of the scenarios before, which the mean of all may contradict: the
    // decision is then still open.
    std::tie(state_.decision, state_.p) = rejection();
    if (!is_consistent(state_.decision)) state_.decision = Decision::Open;
  }

  const DecisionState& state() const { return state_; }

 private:
  bool is_consistent(Decision decision) const {
    const double d = rule_.relevant;
    // The sign of the mean, or of the majority.
    const double sign = rule_.question != Question::Majority ? state_.advantage
                        : state_.better > state_.worse       ? 1
                        : state_.better < state_.worse       ? -1
                                                             : 0;
    switch (decision) {
      case Decision::Better:
        return sign > 0;
      case Decision::Worse:
        return sign < (rule_.question == Question::NoWorse ? -d : 0);
      case Decision::NoRelevantDifference:
        return std::abs(state_.advantage) < d;
      case Decision::NoWorse:
        return state_.advantage > -d;
      case Decision::Open:
        break;
    }
    return true;
  }

  std::pair<Decision, double> rejection() const {
    const double p0 = tests_[0].p(), p1 = tests_[1].p();
    if (rule_.question == Question::NoWorse) {
      if (p0 <= level_) return {Decision::NoWorse, p0};
      return {p1 <= level_ ? Decision::Worse : Decision::Open, p1};
    }
    if (p0 <= level_ / 2) return {Decision::Better, 2 * p0};
    if (p1 <= level_ / 2) return {Decision::Worse, 2 * p1};
    if (rule_.question == Question::Majority)
      return {Decision::Open, std::min(1.0, 2 * std::min(p0, p1))};
    const double p = std::max(tests_[2].p(), tests_[3].p());
    return {p <= level_ ? Decision::NoRelevantDifference : Decision::Open, p};
  }

  const DecisionRule& rule_;
  double level_, sum_ = 0;
  DecisionState state_;
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
             (rule.question == Question::NoWorse ? " by more than " + relevant : "");
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
      "(decided[[:space:]]+in[[:space:]]+more[[:space:]]+scenarios|"
      "(decided([[:space:]]+within[[:space:]]+([^[:space:]]+))?|"
      "no[[:space:]]+worse[[:space:]]+than[[:space:]]+([^[:space:]]+))"
      "([[:space:]]+in[[:space:]]+the[[:space:]]+pool)?)[[:space:]]*");
  DecisionRule rule;
  if (found) {
    const auto &within = (*found)[7], &no_worse = (*found)[8];
    rule.question = !(*found)[5] ? Question::Majority
                    : no_worse   ? Question::NoWorse
                                 : Question::Difference;
    rule.in_pool = (*found)[9].has_value();
    const auto& relevant = no_worse ? no_worse : within;
    if (relevant && !parse_number(*relevant, rule.relevant)) rule.relevant = 0;
  }
  if (!found || !(rule.relevant > 0))
    throw usage_error("--until", "invalid stopping rule '" + text + "'", kExpected);
  rule.metric = *(*found)[1];
  rule.method = *(*found)[2];
  rule.reference = *(*found)[3];
  if (rule.question == Question::Majority) return rule;
  rule.bound = bound_of(rule.metric, range_of_metric(rule.metric));
  if (rule.relevant >= rule.bound)
    throw usage_error("--until",
                      "a difference of " + format_number(rule.relevant) + " in " + rule.metric,
                      "less than " + format_number(rule.bound));
  return rule;
}

DecisionState decide(const DecisionRule& rule, const std::vector<double>& advantages,
                     double confidence, std::size_t pool) {
  DecisionTests tests(rule, test_level(confidence), pool);
  for (const double advantage : advantages) {
    tests.add(advantage);
    if (tests.state().decision != Decision::Open) break;
  }
  return tests.state();
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
  const bool open = state.decision == Decision::Open;
  std::string text = decision_text(rule, state.decision) + " in " + rule.metric;
  if (rule.in_pool) text += " in this pool";
  if (rule.question == Question::Majority)
    text += std::string(open ? "" : " in more scenarios") + ": better in " +
            std::to_string(state.better) + " and worse in " + std::to_string(state.worse) + " of ";
  else
    text += std::string(": mean advantage ") + (state.advantage < 0 ? "-" : "+") +
            format_fixed(std::abs(state.advantage), 3) + " over ";
  text += count_text(state.scenarios, "scenario");
  return open ? text : text + ", " + p_text(state.p);
}

}  // namespace slalom
