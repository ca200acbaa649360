// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/random.h>
#include <slalom/statistics/rank_regression.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

TEST(RankRegression, PredictsFromTheOtherFoldsOnly) {
  // One centered column x with values y = 2 x: the slope of the other rows is 2 S / (S + penalty),
  // S their sum of squares about their mean. Fold 0 is the row x = 3, predicted from x = 0, 1, 2
  // with y = 0, 2, 4: S = 2, slope 4 / 5 with a penalty of 3, mean x = 1, mean y = 2: 2 + 0.8 x 2.
  const Predictors x = {{0, 1, 2, 3}};
  const auto predictions = cross_predict(x, {0, 2, 4, 6}, {1, 1, 1, 0});
  EXPECT_NEAR(predictions[3], 3.6, 1e-12);
  // Rows of fold 1 are predicted from a single one, whose column is constant: its value.
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(predictions[static_cast<std::size_t>(i)], 6, 1e-12);
}

TEST(RankRegression, SolvesTheNormalEquationsOfTwoColumns) {
  // Columns (1, -1, 0, 0) and (0, 0, 1, -1) are orthogonal with sums of squares of 2; products with
  // y = (3, 1, 5, 1) are 2 and 4. Without a penalty: 1 and 2 about the mean 2.5. The last row, of
  // its own fold, has columns (1, 1).
  const Predictors columns = {{1, -1, 0, 0, 1}, {0, 0, 1, -1, 1}};
  EXPECT_NEAR(cross_predict(columns, {3, 1, 5, 1, 0}, {0, 0, 0, 0, 1}, 0)[4], 5.5, 1e-12);
}

TEST(RankRegression, FoldsOfNoOrAllRowsPredictNothing) {
  EXPECT_EQ(cross_predict({{1, 2}}, {1, 2}, {0, 0}), (std::vector<double>{0, 0}));
  EXPECT_TRUE(cross_predict({{}}, {}, {}).empty());
}

TEST(RankRegression, PredictorsDependOnTheOrderOfTheValuesOnly) {
  // Ranks 1, 2.5, 2.5, 4 of 4: (rank - 0.5) / 4 - 0.5.
  const Predictors found = rank_predictors({{-100, 0.5, 0.5, 1e9}});
  EXPECT_EQ(found[0], (std::vector<double>{-0.375, 0, 0, 0.375}));
  EXPECT_EQ(found[1], (std::vector<double>{0.140625, 0, 0, 0.140625}));
  EXPECT_EQ(rank_predictors({{1, 2, 2, 3}}), found);
}

TEST(RankRegression, PredictsAMonotonicFunctionButNotNoise) {
  RandomEngine engine(1);
  std::vector<double> x, curve, noise;
  std::vector<std::size_t> folds;
  for (std::size_t i = 0; i < 300; ++i) {
    x.push_back(normal(engine, 0, 1));
    curve.push_back(std::atan(3 * x.back()));
    noise.push_back(normal(engine, 0, 1));
    folds.push_back(i % 10);
  }
  const Predictors predictors = rank_predictors({x});
  EXPECT_GT(*predicted_fraction(curve, cross_predict(predictors, curve, folds)), 0.9);
  EXPECT_LT(*predicted_fraction(noise, cross_predict(predictors, noise, folds)), 0.03);
}

TEST(RankRegression, FractionPredictedIsOneMinusTheRest) {
  // Squares about the mean 2: 2; rest: 0.5 + 0.5 of the predictions 1.5 apart from 1 and 3 by
  // sqrt(0.5).
  const double off = std::sqrt(0.5);
  EXPECT_NEAR(*predicted_fraction({1, 3}, {1 + off, 3 - off}), 0.5, 1e-12);
  EXPECT_EQ(*predicted_fraction({1, 3}, {2, 2}), 0);
  EXPECT_FALSE(predicted_fraction({2, 2}, {2, 2}));
  EXPECT_FALSE(predicted_fraction({}, {}));
}

TEST(RankRegression, OfGroupsPredictsTheirMeans) {
  // Each row is predicted by the mean of its group in the other fold, but for a penalty that keeps
  // the columns apart, whose sum is constant.
  const std::vector<std::size_t> groups = {0, 0, 1, 1};
  const auto predictions =
      cross_predict(group_predictors(groups), {1, 3, 10, 20}, {0, 1, 0, 1}, 1e-9);
  EXPECT_NEAR(predictions[0], 3, 1e-6);
  EXPECT_NEAR(predictions[1], 1, 1e-6);
  EXPECT_NEAR(predictions[2], 20, 1e-6);
  EXPECT_NEAR(predictions[3], 10, 1e-6);
}

}  // namespace
}  // namespace slalom
