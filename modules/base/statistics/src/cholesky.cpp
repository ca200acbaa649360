// SPDX-License-Identifier: BSD-3-Clause
#include "cholesky.h"

#include <algorithm>
#include <cmath>

namespace slalom {

SquareMatrix cholesky(SquareMatrix matrix) {
  const std::size_t n = matrix.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = matrix[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= matrix[i][k] * matrix[j][k];
      matrix[i][j] = i == j ? std::sqrt(std::max(sum, 1e-300)) : sum / matrix[j][j];
    }
  }
  return matrix;
}

std::vector<double> solve(const SquareMatrix& cholesky, std::vector<double> right) {
  const std::size_t n = right.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) right[i] -= cholesky[i][k] * right[k];
    right[i] /= cholesky[i][i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) right[i] -= cholesky[k][i] * right[k];
    right[i] /= cholesky[i][i];
  }
  return right;
}

}  // namespace slalom
