// SPDX-License-Identifier: BSD-3-Clause
#include "acceptance.h"

#include <slalom/analysis/csv_columns.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

/// `runs` trials of "a" of 50 m and 60 s, of which the first `collisions` collide and the next
/// `timeouts` time out.
ResultTable real_trials(int runs, int collisions, int timeouts = 0) {
  std::string text = "method,outcome,path_length,time\n";
  for (int i = 0; i < runs; ++i)
    text += std::string("a,") +
            (i < collisions              ? "collision"
             : i < collisions + timeouts ? "timeout"
                                         : "success") +
            ",50,60\n";
  // A method that collides: the table tells collisions from other ends.
  return columns_from_csv(text + "b,collision,50,60\n", "trials.csv");
}

std::vector<std::string> said(const ResultTable& table) {
  return acceptance_sentences(table, "a", 0.95);
}

TEST(Acceptance, OfTrialsWithoutAFailureHasTheExactBoundAndTheTrialsThatAreMissing) {
  // 0.05^(1/20) = 0.8609; 0.95^59 = 0.0485 is the first power of 0.95 below 0.05.
  const auto sentences = said(real_trials(20, 0));
  ASSERT_EQ(sentences.size(), 4u);
  EXPECT_EQ(sentences[0],
            "a: 20 of 20 runs with success: at least 0.86 with 95 % confidence, if they are "
            "independent; 39 more with "
            "success would show 0.95");
  EXPECT_EQ(sentences[1],
            "a: 20 of 20 runs without collision: at least 0.86 with 95 % confidence, if they are "
            "independent; 39 more "
            "without collision would show 0.95");
  EXPECT_EQ(said(real_trials(59, 0))[1],
            "a: 59 of 59 runs without collision: at least 0.95 with 95 % confidence, if they are "
            "independent");
}

TEST(Acceptance, CountsFailures) {
  // The least n with P(at most one failure) <= 0.05 at a reliability of 0.95.
  const auto shows = [](int n) {
    return std::pow(0.95, n) + n * 0.05 * std::pow(0.95, n - 1) <= 0.05;
  };
  int needed = 2;
  while (!shows(needed)) ++needed;
  EXPECT_NE(said(real_trials(20, 0, 1))[0].find(std::to_string(needed - 20) + " more with success"),
            std::string::npos)
      << said(real_trials(20, 0, 1))[0];
  EXPECT_EQ(said(real_trials(20, 0, 1))[1].substr(0, 42),
            "a: 20 of 20 runs without collision: at lea");
  EXPECT_EQ(said(real_trials(20, 1))[1].substr(0, 37), "a: 19 of 20 runs without collision: a");
}

TEST(Acceptance, StatesCollisionsPerKmAndHour) {
  // 20 runs: 1 km, 1/3 h. Without an event the upper end of Garwood's interval is -ln(0.025).
  const auto none = said(real_trials(20, 0));
  EXPECT_EQ(none[2], "a: 0 collisions in 1.000 km: 0.00 per km [0.00, 3.69], by path_length in m");
  EXPECT_EQ(none[3], "a: 0 collisions in 0.333 h: 0.00 per h [0.00, 11.07], by time in s");
  // Three events: 0.6187 to 8.7673 (Garwood 1936, table).
  EXPECT_EQ(said(real_trials(20, 3))[2],
            "a: 3 collisions in 1.000 km: 3.00 per km [0.62, 8.77], by path_length in m");
}

TEST(Acceptance, SaysNothingThatTheTableDoesNotTell) {
  const auto of = [](const std::string& text) {
    return acceptance_sentences(columns_from_csv(text, "t.csv"), "", 0.95);
  };
  EXPECT_TRUE(of("method,time\na,1\n").empty()) << "no outcome";
  // The kind of the failure is unknown: it may be a collision.
  EXPECT_EQ(of("method,success,path_length\na,1,5\na,0,5\n").size(), 1u);
  EXPECT_TRUE(of("method,failed,time\na,1,5\na,0,6\n").empty()) << "no success, no collision";
  // Runs without a collision may have failed otherwise, so that no sentence is about success.
  const auto collisions = of("method,collided,time\na,1,30\na,0,60\na,0,90\na,,5\n");
  ASSERT_EQ(collisions.size(), 2u);
  EXPECT_EQ(collisions[0].substr(0, 35), "a: 2 of 3 runs without collision: a");
  EXPECT_EQ(collisions[1].substr(0, 42), "a: 1 collision in 0.050 h: 20.00 per h [0.");
  // No length of a run that failed.
  const auto partly = of("method,outcome,path_length\na,success,5\na,collision,NA\n");
  ASSERT_EQ(partly.size(), 2u);
  EXPECT_EQ(partly[1].find("km"), std::string::npos);
  ResultTable campaign = real_trials(20, 0);
  campaign.manifest["campaign"] = "small";
  EXPECT_TRUE(said(campaign).empty()) << "scenarios are no independent trials of one task";
}

}  // namespace
}  // namespace slalom
