// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace slalom {

/// Duration of an action (s).
template <typename Action>
double wall_time_of(Action action) {
  const auto begin = std::chrono::steady_clock::now();
  action();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace slalom
