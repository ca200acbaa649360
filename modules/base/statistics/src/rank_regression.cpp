// SPDX-License-Identifier: BSD-3-Clause
#include "cholesky.h"

#include <slalom/statistics/rank_regression.h>
#include <slalom/statistics/rank_statistics.h>
#include <slalom/statistics/statistics.h>

#include <algorithm>

namespace slalom {
namespace {

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// The values of the rows inside, or outside, a fold.
std::vector<double> rows_of(const std::vector<double>& values,
                            const std::vector<std::size_t>& folds, std::size_t fold, bool inside) {
  std::vector<double> rows;
  for (std::size_t i = 0; i < values.size(); ++i)
    if ((folds[i] == fold) == inside) rows.push_back(values[i]);
  return rows;
}

/// Predicts the rows of a fold, in their order.
std::vector<double> predict_fold(const Predictors& predictors, const std::vector<double>& target,
                                 const std::vector<std::size_t>& folds, std::size_t fold,
                                 double penalty) {
  std::vector<double> known = rows_of(target, folds, fold, false);
  const double center = mean(known);
  for (double& value : known) value -= center;
  Predictors train;
  std::vector<double> centers, right;
  for (const auto& column : predictors) {
    train.push_back(rows_of(column, folds, fold, false));
    centers.push_back(mean(train.back()));
    for (double& value : train.back()) value -= centers.back();
    right.push_back(dot(train.back(), known));
  }
  SquareMatrix products(train.size(), std::vector<double>(train.size(), 0.0));
  for (std::size_t i = 0; i < train.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) products[i][j] = dot(train[i], train[j]);
    products[i][i] += penalty;
  }
  const std::vector<double> coefficients = solve(cholesky(std::move(products)), right);
  std::vector<double> predictions;
  for (std::size_t row = 0; row < target.size(); ++row) {
    if (folds[row] != fold) continue;
    double prediction = center;
    for (std::size_t i = 0; i < train.size(); ++i)
      prediction += coefficients[i] * (predictors[i][row] - centers[i]);
    predictions.push_back(prediction);
  }
  return predictions;
}

}  // namespace

Predictors rank_predictors(const Predictors& values) {
  Predictors predictors;
  for (const auto& column : values) {
    std::vector<double> ranks = midranks(column, tie_tolerance(column)), squares;
    for (double& rank : ranks) {
      rank = (rank - 0.5) / static_cast<double>(column.size()) - 0.5;
      squares.push_back(rank * rank);
    }
    predictors.push_back(std::move(ranks));
    predictors.push_back(std::move(squares));
  }
  return predictors;
}

Predictors group_predictors(const std::vector<std::size_t>& groups) {
  const std::size_t number =
      groups.empty() ? 0 : *std::max_element(groups.begin(), groups.end()) + 1;
  Predictors predictors(number, std::vector<double>(groups.size(), 0.0));
  for (std::size_t row = 0; row < groups.size(); ++row) predictors[groups[row]][row] = 1;
  return predictors;
}

std::vector<double> cross_predict(const Predictors& predictors, const std::vector<double>& target,
                                  const std::vector<std::size_t>& folds, double penalty) {
  std::vector<double> predictions(target.size(), 0.0);
  const std::size_t number = folds.empty() ? 0 : *std::max_element(folds.begin(), folds.end()) + 1;
  for (std::size_t fold = 0; fold < number; ++fold) {
    const auto size = std::count(folds.begin(), folds.end(), fold);
    if (size == 0 || static_cast<std::size_t>(size) == folds.size()) continue;
    const auto found = predict_fold(predictors, target, folds, fold, penalty);
    std::size_t next = 0;
    for (std::size_t row = 0; row < target.size(); ++row)
      if (folds[row] == fold) predictions[row] = found[next++];
  }
  return predictions;
}

std::optional<double> predicted_fraction(const std::vector<double>& target,
                                         const std::vector<double>& predictions) {
  if (target.empty()) return std::nullopt;
  const double center = mean(target);
  double total = 0, rest = 0;
  for (std::size_t i = 0; i < target.size(); ++i) {
    total += (target[i] - center) * (target[i] - center);
    rest += (target[i] - predictions[i]) * (target[i] - predictions[i]);
  }
  if (total <= 0) return std::nullopt;
  return 1 - rest / total;
}

}  // namespace slalom
