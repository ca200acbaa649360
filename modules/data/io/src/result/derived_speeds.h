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

/// Sets each heading to the direction of the next displacement of more than 1 mm, after the last of
/// them to that of the last one.
void derive_headings(Trajectory& trajectory);

}  // namespace slalom
