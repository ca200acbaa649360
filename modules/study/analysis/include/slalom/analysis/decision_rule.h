// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/result_table.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// Stopping rule of a campaign that compares two methods in a metric.
struct DecisionRule {
  enum class Question {
    Difference,  ///< which mean is better, or do they differ by less than `relevant`?
    NoWorse,     ///< is the method's mean worse than the reference's by `relevant` or more?
    Majority     ///< which one is better in more scenarios, of those in which they differ?
  };

  std::string metric, method, reference;
  double relevant = 0.05;  ///< smallest difference of interest, of a mean over scenarios
  Question question = Question::Difference;
  double bound = 1;      ///< of a difference: the highest minus the lowest value of the metric
  bool in_pool = false;  ///< the question is about the pool, not about what it is a sample of
};

/// Reads "compare(success, mine, nd) decided", "compare(success, mine, nd) decided within 0.1",
/// "compare(success, mine, nd) no worse than 0.02" or "compare(spl, mine, nd) decided in more
/// scenarios"; "in the pool" may follow the first three. Throws Error (Usage), also for a mean of a
/// metric that is not bounded on both sides.
DecisionRule parse_decision_rule(const std::string& text,
                                 const std::function<Range(const std::string&)>& range_of_metric);

/// Conclusion about the method, compared with the reference.
enum class Decision { Open, Better, Worse, NoRelevantDifference, NoWorse };

struct DecisionState {
  Decision decision = Decision::Open;
  std::size_t scenarios = 0;          ///< up to the decision; all of them while it is open
  double advantage = 0;               ///< mean over these; 0 without scenarios
  double p = 1;                       ///< of the decision, valid however often one looks
  std::size_t better = 0, worse = 0;  ///< scenarios of these in which the method is
};

/// Decides by `advantages` (how much better the method is than the reference, one value per
/// scenario, in the order in which these were run, which must be random). A wrong decision of each
/// kind has a probability of at most 1 - confidence: tests by betting (BettingTest), Better and
/// Worse each at half of that level; the two that make NoRelevantDifference, and both tests of
/// NoWorse, each at that level. A decision that the mean advantage contradicts is not made. Values
/// behind the decision do not change it. `pool` is the number of scenarios of a rule with in_pool;
/// it has a value in each of them.
DecisionState decide(const DecisionRule& rule, const std::vector<double>& advantages,
                     double confidence, std::size_t pool = 0);

/// The method's mean minus the reference's in each scenario, or the opposite where less is better,
/// in the order of `hashes`; scenarios in which one of them has no value are left out. Throws Error
/// (Usage) for a metric without a better direction and for unknown names.
std::vector<double> scenario_advantages(const ResultTable& runs, const DecisionRule& rule,
                                        const std::vector<std::string>& hashes);

/// A sentence: "mine is better than nd in success, by 0.217 in the mean of 46 scenarios, p =
/// 0.019".
std::string decision_sentence(const DecisionRule& rule, const DecisionState& state);

}  // namespace slalom
