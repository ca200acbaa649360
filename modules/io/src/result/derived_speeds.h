// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/trajectory/trajectory.h>

namespace slalom {

/// The velocities that a log does not contain.
struct MissingSpeeds {
  bool v = false, w = false, vy = false;
};

/// Computes the missing velocities from the poses: at each sample, the derivative of the parabola
/// through it and its neighbors (at the ends, the nearest two). v is the component along the
/// heading, vy the component to the left. Requires at least two samples.
void derive_speeds(Trajectory& trajectory, const MissingSpeeds& missing);

}  // namespace slalom
