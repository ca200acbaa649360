// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace slalom {

/// Columns of predictors, each with a value per row.
using Predictors = std::vector<std::vector<double>>;

/// Two columns for each: the midranks, scaled to be within (-0.5, 0.5), and their squares, which
/// let the middle values differ from both ends. Ranks make predictors of any unit and tail
/// comparable.
Predictors rank_predictors(const Predictors& values);

/// An indicator column for each group. Their sum is constant; the penalty keeps them identified.
Predictors group_predictors(const std::vector<std::size_t>& groups);

/// The prediction of `target` in each row from the rows of the other folds, by ridge regression
/// (Hoerl and Kennard 1970) on centered columns with the `penalty` on squared coefficients;
/// `folds`: the fold of each row. Rows of a single fold are predicted by 0 others, that is, by 0.
std::vector<double> cross_predict(const Predictors& predictors, const std::vector<double>& target,
                                  const std::vector<std::size_t>& folds, double penalty = 3);

/// The fraction of the variance of `target` that is predicted; negative if the mean predicts it
/// better; none if the target is constant.
std::optional<double> predicted_fraction(const std::vector<double>& target,
                                         const std::vector<double>& predictions);

}  // namespace slalom
