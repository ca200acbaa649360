// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/random.h>
#include <slalom/statistics/dimensionality.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace slalom {
namespace {

/// A distribution of campaigns: methods with abilities N(0, 1); the difficulties of the even and of
/// the odd ones are normal and have this deviation and correlation.
struct Campaigns {
  std::size_t methods = 5;
  int scenarios = 100;
  double deviation = 2;
  double correlation = 1;
  double slope_deviation = 0;  ///< of the logarithm of the slopes of Birnbaum's model (2PL)
};

OutcomeMatrix draw(const Campaigns& campaigns, RandomEngine& engine) {
  std::vector<double> abilities, slopes;
  for (std::size_t i = 0; i < campaigns.methods; ++i) {
    abilities.push_back(normal(engine, 0, 1));
    slopes.push_back(std::exp(normal(engine, 0, campaigns.slope_deviation)));
  }
  OutcomeMatrix outcomes;
  const double r = campaigns.correlation;
  for (int scenario = 0; scenario < campaigns.scenarios; ++scenario) {
    const double even = normal(engine, 0, campaigns.deviation);
    const double odd = r * even + std::sqrt(1 - r * r) * normal(engine, 0, campaigns.deviation);
    outcomes.emplace_back();
    for (std::size_t i = 0; i < campaigns.methods; ++i) {
      const double z = slopes[i] * (abilities[i] - (i % 2 == 0 ? even : odd));
      outcomes.back().push_back(uniform_real(engine, 0, 1) < 1 / (1 + std::exp(-z)));
    }
  }
  return outcomes;
}

/// Fractions of campaigns that are refuted at the level 0.05.
struct Refuted {
  double by_eigenvalue = 0, by_split = 0;
};

Refuted refuted(const Campaigns& campaigns, int repetitions) {
  RandomEngine engine(17);
  Refuted fraction;
  for (int i = 0; i < repetitions; ++i) {
    const auto test = dimension_test(draw(campaigns, engine), static_cast<std::uint64_t>(i));
    fraction.by_eigenvalue += (test->eigenvalue_p <= 0.05 ? 1.0 : 0.0) / repetitions;
    fraction.by_split += (test->split_p <= 0.05 ? 1.0 : 0.0) / repetitions;
  }
  return fraction;
}

TEST(DimensionTest, RefutesOneOfTwentyCampaignsOfRaschsModel) {
  // 1,000 campaigns: the standard error of 0.05 is 0.007.
  const Refuted found = refuted({}, 1000);
  EXPECT_NEAR(found.by_eigenvalue, 0.05, 0.02);
  EXPECT_NEAR(found.by_split, 0.05, 0.02);
}

TEST(DimensionTest, FindsGroupsWithIndependentDifficulties) {
  // The abilities and the difficulties have the same deviation. Andersen's test refutes 0.1 to
  // 0.25.
  EXPECT_GE(refuted({5, 400, 1, 0}, 200).by_split, 0.69) << "0.75 and 2 standard errors";
  const Refuted found = refuted({8, 400, 1, 0}, 40);
  EXPECT_GE(found.by_split, 0.95);
  EXPECT_GE(found.by_eigenvalue, 0.95);
}

TEST(DimensionTest, FindsNoGroupsWhereMethodsDependUnequallyOnOneDifficulty) {
  const Refuted found = refuted({8, 400, 2, 1, 0.5}, 60);
  EXPECT_LE(found.by_split, 0.05);
  EXPECT_GE(found.by_eigenvalue, 0.9) << "one scale does not fit either";
}

TEST(DimensionTest, NamesTheGroups) {
  RandomEngine engine(3);
  const auto test = dimension_test(draw({6, 400, 2, 0}, engine), 1);
  EXPECT_EQ(test->second_group, (std::vector<bool>{false, true, false, true, false, true}));
  EXPECT_EQ(test->split_p, 1 / 500.0);
}

TEST(DimensionTest, IsRepeatableAndNeedsFourMethods) {
  RandomEngine engine(4);
  const OutcomeMatrix outcomes = draw({}, engine);
  const auto once = dimension_test(outcomes, 5), again = dimension_test(outcomes, 5);
  EXPECT_EQ(once->split, again->split);
  EXPECT_EQ(once->split_p, again->split_p);
  EXPECT_EQ(once->eigenvalue, again->eigenvalue);
  EXPECT_EQ(once->eigenvalue_p, again->eigenvalue_p);
  EXPECT_FALSE(dimension_test(draw({3}, engine), 5));
  EXPECT_FALSE(dimension_test({}, 5));
}

TEST(DimensionTest, RefutesNothingWhereTheMarginsDetermineAllOutcomes) {
  const OutcomeMatrix ordered = {{true, false, false, false}, {true, true, false, false}};
  const auto test = dimension_test(ordered, 1);
  EXPECT_EQ(test->eigenvalue_p, 1);
  EXPECT_EQ(test->split_p, 1);
}

constexpr std::size_t kRows = 8;
using Pairs = std::array<double, 6>;  // 01, 02, 03, 12, 13, 23

/// All matrices of kRows scenarios and four methods, 4 bits a row, with the margins of `outcomes`.
class SameMargins {
 public:
  explicit SameMargins(const std::array<unsigned, kRows>& outcomes) : outcomes_(outcomes) {
    add_rows(0);
    for (std::size_t pair = 0; pair < 6; ++pair) standardize(pair);
    observed_ = static_cast<std::size_t>(std::find(matrices_.begin(), matrices_.end(), outcomes) -
                                         matrices_.begin());
  }

  std::size_t size() const { return matrices_.size(); }

  /// The fraction of all matrices whose statistic is that of the outcomes and `margin`, or more.
  template <typename Statistic>
  double p(const Statistic& statistic, double margin) const {
    const double least = statistic(joint_[observed_]) + margin;
    return static_cast<double>(
               std::count_if(joint_.begin(), joint_.end(),
                             [&](const Pairs& z) { return statistic(z) >= least; })) /
           static_cast<double>(size());
  }

 private:
  std::array<unsigned, kRows> outcomes_, rows_{};
  std::vector<std::array<unsigned, kRows>> matrices_;
  std::vector<Pairs> joint_;
  std::size_t observed_ = 0;

  static int bits(unsigned row) {
    return static_cast<int>((row & 1U) + (row >> 1U & 1U) + (row >> 2U & 1U) + (row >> 3U & 1U));
  }

  static Pairs joint_of(const std::array<unsigned, kRows>& rows) {
    Pairs joint{};
    for (const unsigned row : rows) {
      std::size_t pair = 0;
      for (unsigned i = 0; i < 4; ++i)
        for (unsigned j = i + 1; j < 4; ++j) joint[pair++] += (row >> i & row >> j & 1U);
    }
    return joint;
  }

  bool has_same_columns() const {
    for (unsigned i = 0; i < 4; ++i) {
      int difference = 0;
      for (std::size_t row = 0; row < kRows; ++row)
        difference +=
            static_cast<int>(rows_[row] >> i & 1U) - static_cast<int>(outcomes_[row] >> i & 1U);
      if (difference != 0) return false;
    }
    return true;
  }

  void add_rows(std::size_t row) {
    if (row == kRows) {
      if (!has_same_columns()) return;
      matrices_.push_back(rows_);
      joint_.push_back(joint_of(rows_));
      return;
    }
    for (unsigned pattern = 0; pattern < 16; ++pattern) {
      if (bits(pattern) != bits(outcomes_[row])) continue;
      rows_[row] = pattern;
      add_rows(row + 1);
    }
  }

  void standardize(std::size_t pair) {
    double sum = 0, squares = 0;
    for (const Pairs& joint : joint_) sum += joint[pair];
    const double mean = sum / static_cast<double>(size());
    for (const Pairs& joint : joint_) squares += (joint[pair] - mean) * (joint[pair] - mean);
    const double deviation = std::sqrt(squares / static_cast<double>(size()));
    for (Pairs& joint : joint_) joint[pair] = deviation > 0 ? (joint[pair] - mean) / deviation : 0;
  }
};

/// The statistic of the groups. Without the effects of four methods, z has three values, one for
/// each division into two pairs; the largest one belongs to the groups.
double split_of_four(const Pairs& z) {
  const std::array<std::array<std::size_t, 2>, 3> divisions = {{{0, 5}, {1, 4}, {2, 3}}};
  const auto groups = *std::max_element(
      divisions.begin(), divisions.end(),
      [&](const auto& a, const auto& b) { return z[a[0]] + z[a[1]] < z[b[0]] + z[b[1]] - 1e-9; });
  return std::min(z[groups[0]], z[groups[1]]);
}

/// The largest eigenvalue by the power method, with a shift that makes all eigenvalues positive.
double eigenvalue_of_four(const Pairs& z) {
  double shift = 1;
  for (const double entry : z) shift += std::abs(entry);
  const std::array<std::array<double, 4>, 4> matrix = {{{shift, z[0], z[1], z[2]},
                                                        {z[0], shift, z[3], z[4]},
                                                        {z[1], z[3], shift, z[5]},
                                                        {z[2], z[4], z[5], shift}}};
  std::array<double, 4> vector = {1, 0.7, -0.4, 0.2};
  double length = 1;
  for (int i = 0; i < 300; ++i) {
    std::array<double, 4> next{};
    double squares = 0;
    for (std::size_t row = 0; row < 4; ++row) {
      for (std::size_t column = 0; column < 4; ++column)
        next[row] += matrix[row][column] * vector[column] / length;
      squares += next[row] * next[row];
    }
    vector = next;
    length = std::sqrt(squares);
  }
  return length - shift;
}

OutcomeMatrix matrix_of(const std::array<unsigned, kRows>& rows) {
  OutcomeMatrix outcomes;
  for (const unsigned row : rows) {
    outcomes.emplace_back();
    for (unsigned i = 0; i < 4; ++i) outcomes.back().push_back((row >> i & 1U) != 0);
  }
  return outcomes;
}

TEST(DimensionTest, HasThePOfAllMatricesWithTheSameMargins) {
  // 20 chains of 499 matrices: the standard error of their mean p is below 0.005 but for the
  // dependence within a chain. The deviations of z over a chain have errors of some percent, and
  // so have the statistics.
  for (const std::array<unsigned, kRows>& rows :
       {std::array<unsigned, kRows>{1, 7, 7, 1, 3, 12, 1, 12},
        std::array<unsigned, kRows>{14, 7, 6, 8, 9, 6, 6, 11},
        std::array<unsigned, kRows>{4, 6, 6, 7, 3, 6, 9, 13},
        std::array<unsigned, kRows>{10, 1, 3, 1, 13, 3, 13, 8},
        std::array<unsigned, kRows>{3, 4, 7, 7, 12, 11, 10, 7}}) {
    const SameMargins all(rows);
    double eigenvalue_p = 0, split_p = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const auto test = dimension_test(matrix_of(rows), seed);
      eigenvalue_p += test->eigenvalue_p / 20;
      split_p += test->split_p / 20;
    }
    constexpr double kMargin = 0.05, kTolerance = 0.02;
    EXPECT_GT(all.size(), 1000U);
    EXPECT_GE(eigenvalue_p, all.p(eigenvalue_of_four, kMargin) - kTolerance);
    EXPECT_LE(eigenvalue_p, all.p(eigenvalue_of_four, -kMargin) + kTolerance);
    EXPECT_GE(split_p, all.p(split_of_four, kMargin) - kTolerance);
    EXPECT_LE(split_p, all.p(split_of_four, -kMargin) + kTolerance);
  }
}

}  // namespace
}  // namespace slalom
