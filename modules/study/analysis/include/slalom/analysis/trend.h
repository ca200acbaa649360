// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cell_sums.h>
#include <slalom/core/enum_names.h>

#include <optional>
#include <vector>

namespace slalom {

/// A test for a trend over ordered groups, whose scores are 0, 1, 2, ...
struct TrendTest {
  enum class Kind { NoVariation, CochranArmitage, JonckheereTerpstra, LinearContrast };
  Kind kind = Kind::NoVariation;
  double z = 0;  ///< standard normal without a trend; positive: values rise over the groups
  double p = 1;  ///< two-sided
};
constexpr auto enum_names(TrendTest::Kind) {
  return std::array{"equal values", "Cochran-Armitage", "Jonckheere-Terpstra", "linear contrast"};
}

/// Trend of rates (Cochran 1954; Armitage 1955), with the binomial variance:
/// `successes` of `sizes` per group. Sizes need not be integers: clustered runs enter with their
/// effective number and the successes that go with it (Rao and Scott 1992). Requires equal numbers
/// of groups.
TrendTest cochran_armitage(const std::vector<double>& successes, const std::vector<double>& sizes);

/// Trend of independent values by their ranks (Jonckheere 1954; Terpstra 1952), with the normal
/// approximation and the variance for ties of Hollander and Wolfe (1999, 6.2).
TrendTest jonckheere_terpstra(const std::vector<std::vector<double>>& groups);

/// Trend of means: the contrast of the groups' means with centered scores, divided by its standard
/// error (Welch 1947: variances may differ), which follows from the variation between scenarios.
/// For large groups. Those with fewer than two scenarios are left out.
TrendTest linear_contrast(const std::vector<GroupMoments>& groups);

/// The trend of a column of a cross table over its bins.
struct Trend {
  TrendTest test;
  std::size_t bins = 0;       ///< with values
  std::size_t scenarios = 0;  ///< with values
  double adjusted_p = 1;      ///< by Holm, over all columns and tables of one analysis
};

constexpr std::size_t kMinScenariosOfTrend = 20, kMinScenariosOfBin = 5;

/// Tests rates with Cochran-Armitage and effective sample sizes. Otherwise uses Jonckheere-Terpstra
/// over the means of the scenarios, and the linear contrast if a bin has more than
/// kMaxKeptScenarios. None with fewer than kMinScenariosOfTrend scenarios, or fewer than two bins
/// of kMinScenariosOfBin.
std::optional<Trend> find_trend(const std::vector<CellSums>& bins, bool rate);

}  // namespace slalom
