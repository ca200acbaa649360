#pragma once

namespace slalom {

/// By how much (m) the judge of collisions lets a robot be nearer than its radius.
constexpr double kContactTolerance = 1e-9;

}  // namespace slalom
