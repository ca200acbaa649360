// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/analysis/csv_columns.h>
#include <slalom/analysis/sim2real.h>
#include <slalom/core/random.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>

namespace slalom {
namespace {

ResultTable table(const std::string& text, const std::string& name = "real.csv") {
  return columns_from_csv(text, name);
}

/// Five trials per method without scenarios, successes as given.
std::string trials(int a, int b, int c, int count = 10) {
  std::string text = "method,success\n";
  const auto add = [&](const std::string& method, int successes) {
    for (int i = 0; i < count; ++i) text += method + (i < successes ? ",1\n" : ",0\n");
  };
  add("a", a);
  add("b", b);
  add("c", c);
  return text;
}

Sim2Real compared(const std::string& real, const std::string& simulated,
                  const std::string& metric = "success") {
  return sim2real(table(real), table(simulated, "sim.csv"), metric, {});
}

TEST(RankViolation, IsTheLargestRealDifferenceThatTheSimulationReverses) {
  EXPECT_EQ(mean_max_rank_violation({0.1, 0.5, 0.9}, {0.2, 0.3, 0.4}), 0);
  // 0.5 and 0.9 are swapped: 0.4 for each of these two, 0 for the third.
  EXPECT_NEAR(mean_max_rank_violation({0.1, 0.5, 0.9}, {0.2, 0.4, 0.3}), 0.8 / 3, 1e-12);
  // Reversed: 0.8, 0.4 and 0.8.
  EXPECT_NEAR(mean_max_rank_violation({0.1, 0.5, 0.9}, {3, 2, 1}), 2.0 / 3, 1e-12);
}

TEST(RankViolation, IsThatOfItsDefinition) {
  RandomEngine engine(3);
  for (int repetition = 0; repetition < 100; ++repetition) {
    std::vector<double> real, simulated;
    for (int i = 0; i < 6; ++i) {
      real.push_back(uniform_real(engine, 0, 1));
      simulated.push_back(uniform_real(engine, 0, 1));
    }
    double sum = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      double most = 0;
      for (std::size_t j = 0; j < 6; ++j)
        if ((real[i] - real[j]) * (simulated[i] - simulated[j]) < 0)
          most = std::max(most, std::abs(real[i] - real[j]));
      sum += most;
    }
    EXPECT_NEAR(mean_max_rank_violation(real, simulated), sum / 6, 1e-12);
  }
}

TEST(Sim2Real, TheNoiseCeilingDoesNotDependOnTheOrderInSimulation) {
  const std::string real = trials(2, 5, 8, 30);
  const Sim2Real same = compared(real, trials(6, 15, 24, 30)),
                 opposite = compared(real, trials(24, 15, 6, 30));
  ASSERT_TRUE(same.kendall.ceiling && opposite.kendall.ceiling && same.spearman.ceiling);
  EXPECT_NEAR(same.kendall.ceiling->mean, opposite.kendall.ceiling->mean, 0.03);
  EXPECT_LT(same.kendall.ceiling->mean, 1) << "two of three are often turned by noise";
  EXPECT_GE(*same.kendall.value, same.kendall.ceiling->interval.low);
  EXPECT_LT(*opposite.kendall.value, opposite.kendall.ceiling->interval.low);
  EXPECT_FALSE(same.pearson.ceiling) << "not of ranks";
  const auto json = sim2real_json(opposite);
  EXPECT_EQ(json["kendall"]["noise_ceiling"]["value"], opposite.kendall.ceiling->mean);
  EXPECT_FALSE(json["pearson"].contains("noise_ceiling"));
}

TEST(Sim2Real, TheSameOrderAgrees) {
  const Sim2Real result = compared(trials(2, 5, 8), trials(3, 6, 9));
  EXPECT_EQ(result.scenarios, 0U);
  ASSERT_EQ(result.methods.size(), 3U);
  EXPECT_EQ(result.methods[0].name, "c") << "best first";
  EXPECT_NEAR(result.methods[0].real, 0.8, 1e-12);
  EXPECT_NEAR(result.methods[0].simulated, 0.9, 1e-12);
  EXPECT_EQ(result.methods[0].real_runs, 10U);
  EXPECT_EQ(result.spearman.value, 1);
  EXPECT_EQ(result.kendall.value, 1);
  EXPECT_NEAR(*result.pearson.value, 1, 1e-12) << "both in steps of 0.3";
  EXPECT_EQ(result.mmrv.value, 0);
  ASSERT_TRUE(result.mmrv.interval);
  EXPECT_GE(result.mmrv.interval->low, 0);
  EXPECT_LT(result.kendall.interval->low, 1) << "ten trials are few";
}

TEST(Sim2Real, ASwappedPairLowersAgreement) {
  const Sim2Real result = compared(trials(2, 5, 8), trials(3, 9, 6));
  EXPECT_NEAR(*result.spearman.value, 0.5, 1e-12) << "1 - 6 * 2 / (3 * 8)";
  EXPECT_NEAR(*result.kendall.value, 1.0 / 3, 1e-12) << "two pairs of three in the same order";
  EXPECT_NEAR(*result.mmrv.value, (0.3 + 0.3) / 3, 1e-12);
}

TEST(Sim2Real, MoreTrialsNarrowTheIntervals) {
  const auto width = [](int factor) {
    const Sim2Real result = compared(trials(2 * factor, 5 * factor, 8 * factor, 10 * factor),
                                     trials(3 * factor, 6 * factor, 9 * factor, 10 * factor));
    return result.pearson.interval->high - result.pearson.interval->low;
  };
  EXPECT_LT(width(20), 0.5 * width(1));
}

TEST(Sim2Real, ComparesTheSameScenariosWithTheWeightsOfTheRealRuns) {
  const std::string simulated =
      "scenario,method,success,time_to_goal\nroom,a,1,10\nroom,a,1,12\nhall,a,1,20\nroom,b,1,8\n"
      "hall,b,1,14\nyard,a,1,999\n";
  // a: two trials in the room, one in the hall.
  const Sim2Real result =
      sim2real(table("scenario,method,time_to_goal\nroom,a,15\nroom,a,17\nhall,a,30\nroom,b,9\n"),
               columns_from_csv(simulated, "sim.csv", {{}, {"time_to_goal"}}), "time_to_goal", {});
  EXPECT_EQ(result.scenarios, 2U);
  EXPECT_EQ(result.methods[0].name, "b") << "less time is better";
  EXPECT_NEAR(result.methods[0].simulated, 8, 1e-12) << "b was not tried in the hall";
  EXPECT_EQ(result.methods[0].simulated_runs, 1U);
  EXPECT_NEAR(result.methods[1].real, (15 + 17 + 30) / 3.0, 1e-12);
  EXPECT_NEAR(result.methods[1].simulated, (2 * 11 + 20) / 3.0, 1e-12);
  EXPECT_FALSE(result.spearman.value);
  EXPECT_EQ(result.spearman.reason, "fewer than 3 methods");
  EXPECT_EQ(result.mmrv.value, 0);
}

TEST(Sim2Real, SaysHowManyTrialsWouldDecideAnOrder) {
  // 0.2 and 0.5 of ten: deviations of 0.42 and 0.53, for a difference of 0.3 about 41 of each by
  // the normal approximation (1.96 + 0.84)^2 (0.42^2 + 0.53^2) / 0.3^2, a few more by t.
  const Sim2Real few = compared(trials(2, 5, 5), trials(3, 6, 9));
  ASSERT_EQ(few.orders.size(), 2U);
  EXPECT_EQ(few.orders[0].better, "b");
  EXPECT_EQ(few.orders[0].worse, "c");
  EXPECT_FALSE(few.orders[0].more_runs) << "equal means";
  ASSERT_TRUE(few.orders[1].more_runs);
  EXPECT_NEAR(static_cast<double>(*few.orders[1].more_runs), 41 - 10, 4);
  const Sim2Real many = compared(trials(40, 100, 160, 200), trials(3, 6, 9));
  EXPECT_EQ(many.orders[0].more_runs, 0U);
}

TEST(Sim2Real, DoesNotResampleTheRunsOfACommonScenario) {
  // All real trials of a method are equal, so nothing varies, although the simulated ones do.
  const std::string simulated =
      "scenario,method,success\nroom,a,1\nroom,a,0\nroom,b,0\nroom,b,1\n"
      "room,b,1\nroom,c,0\nroom,c,1\nroom,c,0\nroom,c,0\n";
  const Sim2Real result = compared(
      "scenario,method,success\nroom,a,1\nroom,a,1\nroom,b,1\nroom,b,1\nroom,c,0\n", simulated);
  EXPECT_EQ(result.scenarios, 1U);
  ASSERT_TRUE(result.pearson.interval);
  EXPECT_EQ(result.pearson.interval->low, *result.pearson.value);
  EXPECT_EQ(result.pearson.interval->high, *result.pearson.value);
}

TEST(Sim2Real, RealScenariosThatAreTheSameSimulatedOneCountAsOne) {
  // One by its hash, the other one by its name.
  const std::string simulated = "scenario_hash,scenario,method,success\nh1,room,a,1\nh1,room,b,0\n";
  const Sim2Real result = compared(
      "scenario_hash,scenario,method,success\nh1,room,a,1\nx2,room,a,0\nh1,room,b,0\n", simulated);
  EXPECT_EQ(result.scenarios, 1U);
  EXPECT_EQ(result.methods[0].real_runs, 2U);
  EXPECT_EQ(result.methods[0].real, 0.5);
}

TEST(Sim2Real, IsNotAvailableWhenAllMethodsAreEqual) {
  const Sim2Real result = compared(trials(5, 5, 5), trials(3, 6, 9));
  EXPECT_FALSE(result.kendall.value);
  EXPECT_EQ(result.pearson.reason, "all means are equal on one side");
}

TEST(Sim2Real, IsRepeatable) {
  const auto text = [] { return render_text(compared(trials(2, 5, 8), trials(3, 9, 6))); };
  EXPECT_EQ(text(), text());
  EXPECT_NE(text().find("Kendall's tau-b"), std::string::npos);
}

TEST(Sim2Real, IsWrittenAsJson) {
  const auto json = sim2real_json(compared(trials(2, 5, 5), trials(3, 9, 6)));
  EXPECT_EQ(json["methods"].size(), 3U);
  EXPECT_EQ(json["scenarios"], 0);
  EXPECT_TRUE(json["orders"][0]["more_runs"].is_null());
  EXPECT_TRUE(json["mmrv"]["interval"].is_array());
}

TEST(Sim2Real, ReportsWhatDoesNotFit) {
  const auto refused = [](const std::string& real, const std::string& simulated,
                          const std::string& where, std::initializer_list<std::string> words,
                          const std::string& metric = "success") {
    return throws_error(ErrorKind::Usage, where, words, [&] { compared(real, simulated, metric); });
  };
  const std::string sim = trials(3, 6, 9);
  EXPECT_TRUE(refused("method,success\nx,1\n", sim, "real.csv",
                      {"method 'x' is not in sim.csv", "a, b, c"}));
  EXPECT_TRUE(refused("method,success\na,1\n", sim, "real.csv", {"only the method 'a'"}));
  EXPECT_TRUE(refused("method,success\na,1\nb,NA\n", sim, "real.csv",
                      {"method 'b' has no value of 'success'"}));
  EXPECT_TRUE(refused("scenario,method,success\nroom,a,1\nhall,b,1\n",
                      "scenario,method,success\nroom,a,1\nroom,b,1\n", "real.csv",
                      {"scenario 'hall' is not in sim.csv"}));
  EXPECT_TRUE(refused("method,success\na,1\nb,2\n", sim, "real.csv",
                      {"'success' has other values than 0 and 1", "0, 1 or NA"}));
  EXPECT_TRUE(refused("method,speed\na,1\nb,2\n", "method,speed\na,1\nb,2\n", "--metric",
                      {"no value of 'speed' is better"}, "speed"));
}

}  // namespace
}  // namespace slalom
