#pragma once

namespace slalom {

/// Tolerance (m) of collision checking: clearances may be below the robot's radius by this much.
constexpr double kContactTolerance = 1e-9;

}  // namespace slalom
