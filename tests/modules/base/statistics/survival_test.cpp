// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/random.h>
#include <slalom/statistics/survival.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

/// Weeks of remission under 6-MP of 21 patients: Freireich et al. 1963, as in Kleinbaum and Klein,
/// "Survival Analysis".
std::vector<TimedEnd> remissions() {
  std::vector<TimedEnd> ends;
  for (const double t : {6, 6, 6, 7, 10, 13, 16, 22, 23}) ends.push_back({t, 1});
  for (const double t : {6, 9, 10, 11, 17, 19, 20, 25, 32, 32, 34, 35}) ends.push_back({t, 0});
  return ends;
}

TEST(Survival, KaplanMeierAgreesWithTheRemissionData) {
  const struct {
    double time;
    std::size_t at_risk;
    double fraction, error;
  } published[] = {{6, 21, 0.8571, 0.0764},  {7, 17, 0.8067, 0.0869},  {10, 15, 0.7529, 0.0963},
                   {13, 12, 0.6902, 0.1068}, {16, 11, 0.6275, 0.1141}, {22, 7, 0.5378, 0.1282},
                   {23, 6, 0.4482, 0.1346}};
  const std::vector<CurvePoint> curve = kaplan_meier(remissions());
  ASSERT_EQ(curve.size(), std::size(published));
  for (std::size_t i = 0; i < curve.size(); ++i) {
    EXPECT_EQ(curve[i].time, published[i].time);
    EXPECT_EQ(curve[i].at_risk, published[i].at_risk);
    EXPECT_NEAR(curve[i].value, published[i].fraction, 5e-5);
    EXPECT_NEAR(curve[i].standard_error, published[i].error, 5e-5);
  }
}

TEST(Survival, SingleCauseIsTheComplementOfKaplanMeier) {
  const auto survival = kaplan_meier(remissions());
  const auto incidence = cumulative_incidence(remissions(), 1);
  ASSERT_EQ(incidence.size(), survival.size());
  for (std::size_t i = 0; i < survival.size(); ++i) {
    EXPECT_NEAR(incidence[i].value, 1 - survival[i].value, 1e-12);
    EXPECT_NEAR(incidence[i].standard_error, survival[i].standard_error, 1e-9);
  }
}

TEST(Survival, WithoutCensoringIncidenceIsTheEmpiricalFraction) {
  RandomEngine engine(7);
  std::vector<TimedEnd> ends;
  for (int i = 0; i < 60; ++i)
    ends.push_back({static_cast<double>(uniform_int(engine, 1, 20)), uniform_int(engine, 1, 3)});
  for (const CurvePoint& point : cumulative_incidence(ends, 2)) {
    const auto ended = std::count_if(ends.begin(), ends.end(), [&](const TimedEnd& end) {
      return end.cause == 2 && end.time <= point.time;
    });
    const double fraction = static_cast<double>(ended) / 60;
    EXPECT_NEAR(point.value, fraction, 1e-12);
    EXPECT_NEAR(point.standard_error, std::sqrt(fraction * (1 - fraction) / 60), 1e-9);  // binomial
  }
}

TEST(Survival, IncidenceOfCompetingCausesAgreesWithManualCalculation) {
  // Ends 1 (cause 1), 2 (cause 2), 3 (censored), 4 (cause 1), 5 (cause 2). Before 4 the fraction
  // without end is 3/5, of two at risk one ends: 1/5 + 3/5 x 1/2.
  const auto curve = cumulative_incidence({{4, 1}, {1, 1}, {3, 0}, {5, 2}, {2, 2}}, 1);
  ASSERT_EQ(curve.size(), 2u);
  EXPECT_DOUBLE_EQ(curve[0].value, 0.2);
  EXPECT_DOUBLE_EQ(curve[1].value, 0.5);
  EXPECT_EQ(curve[1].at_risk, 2u);
}

TEST(Survival, LogLogIntervalsStayWithinTheirRange) {
  const Interval interval = *log_log_interval(0.95, 0.1, 0.95);
  EXPECT_GT(interval.low, 0);
  EXPECT_LT(interval.low, 0.95);
  EXPECT_LT(interval.high, 1);
  EXPECT_GT(interval.high, 0.95);
  EXPECT_FALSE(log_log_interval(1, 0, 0.95));
}

}  // namespace
}  // namespace slalom
