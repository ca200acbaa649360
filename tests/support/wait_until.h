// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <thread>

namespace slalom {

/// Waits until a condition holds, without a limit: if it never does, the time limit of the test
/// program ends the test.
template <typename Condition>
void wait_until(Condition holds) {
  while (!holds()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace slalom
