#pragma once

#include <slalom/trajectory/trajectory.h>

namespace slalom {

/// Which speeds a log does not have.
struct MissingSpeeds {
  bool v = false, w = false, vy = false;
};

/// Fills the missing speeds by differences of the poses: at each sample those of the parabola
/// through it and its neighbours (at the ends, the nearest two). v is the velocity's
/// part along the heading, vy the part to the left. Requires two samples or more.
void derive_speeds(Trajectory& trajectory, const MissingSpeeds& missing);

}  // namespace slalom
