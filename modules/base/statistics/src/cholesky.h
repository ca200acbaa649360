// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace slalom {

/// A square matrix of rows.
using SquareMatrix = std::vector<std::vector<double>>;

/// The lower triangle L of A = L L' (Cholesky) of a symmetric, positive definite matrix; a pivot
/// that rounding makes smaller than 1e-300 counts as 1e-300.
SquareMatrix cholesky(SquareMatrix matrix);

/// The solution x of L L' x = `right`.
std::vector<double> solve(const SquareMatrix& cholesky, std::vector<double> right);

}  // namespace slalom
