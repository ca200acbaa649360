// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace slalom {

/// Monotonic time in seconds since an arbitrary time point. Code that enforces deadlines has it as
/// a parameter, so that tests can replace it.
using WallClock = std::function<double()>;

/// std::chrono::steady_clock in seconds.
double steady_seconds();

}  // namespace slalom
