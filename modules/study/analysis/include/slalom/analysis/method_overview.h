// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/standings.h>

#include <string>
#include <vector>

namespace slalom {

/// A failure worth looking at.
struct NotableFailure {
  std::size_t run = 0;  ///< index into the runs
  std::string why;      ///< "collision; others that succeed here: 3 of 3"
  std::size_t others = 0,
              solved = 0;  ///< other methods with runs in the scenario, and with success
};

/// Statements of the first screen of a report about a method.
struct MethodOverview {
  Standing standing;
  std::string sentence;                  ///< only with clauses that hold
  std::vector<NotableFailure> failures;  ///< at most kMaxNotableFailures
  std::size_t failed = 0,
              solved_by_others = 0;  ///< failed runs; those where another method succeeds
};

constexpr std::size_t kMaxNotableFailures = 3;

/// One entry per method of the results, by decreasing success, e.g. "nd succeeds in 80 % [69, 88]
/// of 70 runs; it falls from 100 % to 42 % with density (in [0, 0.1) and [0.3, 0.4], p = 0.0046);
/// it gets stuck in 20 %, collides in none (at most 4.2 %); against gap it is 0.10 worse in success
/// on the same scenarios, p = 0.0300, Holm over 3 pairs". Trends are taken from `tables`,
/// differences from `family`; both as far as they are about success. The bound of "none" is the
/// exact one-sided one of that confidence for the number of scenarios.
///
/// Failures: in scenarios that another method solves, or that no other has run; those that most
/// others solve first, then collisions, then in the order of the runs; at most one per scenario.
std::vector<MethodOverview> build_overview(const ResultTable& table,
                                           const std::vector<CrossTable>& tables,
                                           const std::vector<PairedComparison>& family,
                                           const AnalysisOptions& options);

/// Names the two methods that succeed most often, and states whether the first is better: "gap
/// succeeds most often (79 % of 70 runs), nd second (71 %): not confirmed against nd: 0.08 [0.01,
/// 0.16] better over 70 scenarios, p = 0.0430, Holm over 6 pairs". Differences are taken from
/// `family`. Empty for fewer than two methods with a success.
std::string leader_sentence(const ResultTable& table, const std::vector<PairedComparison>& family,
                            const AnalysisOptions& options);

}  // namespace slalom
