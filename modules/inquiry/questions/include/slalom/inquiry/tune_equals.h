// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/inquiry/tune_search.h>

#include <cstddef>
#include <vector>

namespace slalom {

/// The configurations that cannot be told from the winner of a search by their success.
struct TiedConfigurations {
  std::size_t compared = 0;             ///< configurations other than the winner
  std::vector<std::size_t> candidates;  ///< not shown to differ; the winner is the first
};

/// Compares the winner of a complete search with the other finalists in the finals, and with the
/// other configurations of the last rung in their scenarios of the search, if the winner has run
/// there: McNemar's exact tests of pairs at 1 - confidence, with Holm's adjustment over all.
TiedConfigurations statistically_tied(const TuneResult& result, double confidence);

struct FrontPoint {
  std::size_t candidate = 0;
  std::size_t common = 0;   ///< finals in which it and the winner succeed with secondary values
  double minus_winner = 0;  ///< mean difference of these; 0 without
};

/// The finalists of a complete search that no other one dominates, in their order: none has as many
/// successes and secondary values as small, where both succeed, and one of them better.
std::vector<FrontPoint> pareto_front(const TuneResult& result);

}  // namespace slalom
