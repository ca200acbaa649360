// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/inquiry/tune_equals.h>

#include <gtest/gtest.h>

#include <vector>

namespace slalom {
namespace {

/// Runs of which the first `failures` fail.
std::vector<TuneOutcome> outcomes(std::size_t runs, std::size_t failures) {
  std::vector<TuneOutcome> result(runs);
  for (std::size_t i = failures; i < runs; ++i) result[i].success = true;
  return result;
}

/// The winner, candidate 1, never fails.
TuneResult made_search(std::vector<TuneCandidate> others) {
  TuneResult result;
  result.candidates = {{{0}, outcomes(8, 8), outcomes(100, 50)},
                       {{1}, outcomes(64, 0), outcomes(100, 0)}};
  result.candidates.insert(result.candidates.end(), others.begin(), others.end());
  result.elites = {{1}};
  result.finalists = {1, 0};
  result.winner = 1;
  result.complete = true;
  return result;
}

TEST(TiedConfigurations, AreFinalistsAndConfigurationsOfTheLastRungWithoutAShownDifference) {
  // McNemar with all of d discordant pairs on one side: p = 2^(1 - d), 0.03 for d = 6, 0.06 for 5.
  TuneResult result = made_search({{{2}, outcomes(64, 64), outcomes(100, 5)},  // a finalist
                                   {{3}, outcomes(64, 5), {}},
                                   {{4}, outcomes(64, 40), {}},
                                   {{5}, outcomes(32, 0), {}}});  // not in the last rung
  result.finalists.push_back(2);
  const TiedConfigurations equals = statistically_tied(result, 0.95);
  EXPECT_EQ(equals.compared, 4U);
  EXPECT_EQ(equals.candidates, (std::vector<std::size_t>{1, 2, 3}));
}

TEST(TiedConfigurations, AreOneFamily) {
  // p = 2^-6 = 0.016 of each, after the default's 2^-49. Holm multiplies it by the number of those
  // that are left: 1, or 4, which gives 0.06.
  const TuneCandidate close{{2}, outcomes(64, 7), {}};
  EXPECT_EQ(statistically_tied(made_search({close}), 0.95).candidates,
            (std::vector<std::size_t>{1}));
  EXPECT_EQ(statistically_tied(made_search({close, close, close, close}), 0.95).candidates,
            (std::vector<std::size_t>{1, 2, 3, 4, 5}));
}

TEST(TiedConfigurations, AreFinalistsOnlyIfTheWinnerIsNotOfTheLastRung) {
  TuneResult result = made_search({{{2}, outcomes(64, 0), {}}});
  result.winner = 0;
  const TiedConfigurations equals = statistically_tied(result, 0.95);
  EXPECT_EQ(equals.compared, 1U);
  EXPECT_EQ(equals.candidates, (std::vector<std::size_t>{0}));
}

TEST(TiedConfigurations, FrontHasWhatNoOtherFinalistBeatsInSuccessAndTheMetricOfCommonScenarios) {
  // Succeeds in ten scenarios but the first ones, each in the time of its number and `more`.
  const auto finalist = [](std::size_t failures, double more) {
    TuneCandidate candidate{{}, {}, outcomes(10, failures)};
    for (std::size_t i = failures; i < 10; ++i)
      candidate.finals[i].secondary = static_cast<double>(i) + more;
    return candidate;
  };
  // The means of all their runs, 4.5, 5 and 7, would have the first one beat the third, which is
  // faster where both succeed.
  TuneResult result;
  result.candidates = {finalist(0, 0), finalist(1, 0), finalist(6, -1), finalist(10, 0)};
  result.finalists = {0, 1, 2, 3};
  const std::vector<FrontPoint> front = pareto_front(result);
  ASSERT_EQ(front.size(), 2U);
  EXPECT_EQ(front[1].candidate, 2U);
  EXPECT_EQ(front[1].minus_winner, -1);
  EXPECT_EQ(front[1].common, 4U);
}

}  // namespace
}  // namespace slalom
