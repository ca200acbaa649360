// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace slalom {

/// `from` changed towards `to` by at most `step`.
inline double approach(double from, double to, double step) {
  return from + std::clamp(to - from, -step, step);
}

}  // namespace slalom
