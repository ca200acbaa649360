// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace slalom {

/// Interpolates linearly between order statistics (type 7 of Hyndman and Fan 1996); requires at
/// least one value, ascending.
double quantile(const std::vector<double>& sorted, double fraction);

}  // namespace slalom
