// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace slalom {

inline double square(double x) {
  return x * x;
}

}  // namespace slalom
