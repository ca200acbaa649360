// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace slalom {

/// Tolerance (m) of collision checking, for rounding errors: exact contact is free. Clearances may
/// be below the robot's radius by this much.
constexpr double kContactTolerance = 1e-9;

}  // namespace slalom
