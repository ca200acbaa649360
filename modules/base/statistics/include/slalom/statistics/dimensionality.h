// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/statistics/rasch.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace slalom {

constexpr std::size_t kMinMethodsOfDimensionTest = 4;
constexpr std::size_t kMatricesOfDimensionTest = 499;  ///< p is at least 1 / 500

/// Whether some methods solve the same scenarios more often than Rasch's model says, whatever the
/// abilities and difficulties: the outcomes against matrices with the same number of scenarios
/// solved by each method and the same number of methods that solve each scenario, which the model
/// makes equally probable. The statistics are of z[i][j], the number of scenarios that both methods
/// solve, standardized over all matrices.
struct DimensionTest {
  /// Largest eigenvalue of z. Methods whose outcomes depend more on the difficulty than those of
  /// others, in one dimension, make it large too.
  double eigenvalue = 0;
  double eigenvalue_p = 1;  ///< small: one scale does not fit
  /// The smaller one, over two groups of methods, of the sum of z within the group divided by the
  /// root of its number of pairs. The groups are the signs of the eigenvector of the largest
  /// eigenvalue of z without the additive effects of the methods.
  double split = 0;
  double split_p = 1;              ///< small: two groups find different scenarios hard
  std::vector<bool> second_group;  ///< by method; the first method is in the first group
};

/// Tests whether one scale describes the methods. The matrices are a Markov chain of trades between
/// two methods (Verhelst 2008, Psychometrika 73:705-728; Strona et al. 2014, Nature Communications
/// 5:4114), twice as many from one to the next as there are methods. The outcomes have a random
/// position in it, so that p is exact without knowing how fast the chain mixes (serial test of
/// Besag and Clifford 1989, Biometrika 76:633-642). None for fewer than
/// kMinMethodsOfDimensionTest methods, between which the effects leave nothing.
std::optional<DimensionTest> dimension_test(const OutcomeMatrix& outcomes, std::uint64_t seed);

}  // namespace slalom
