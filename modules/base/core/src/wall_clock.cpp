// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/wall_clock.h>

#include <chrono>

namespace slalom {

double steady_seconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

}  // namespace slalom
