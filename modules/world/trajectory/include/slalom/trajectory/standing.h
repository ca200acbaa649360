// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/trajectory/trajectory.h>

namespace slalom {

/// Time (s) after which a robot counts as standing: a mover that then touches it ran into it
/// (passive safety).
constexpr double kStandingTime = 0.5;

/// Whether the footprint of a robot that is at `pose` at time `now`, not before the last sample,
/// has not moved for kStandingTime; a disc does not move when it rotates in place. False if the
/// trajectory is shorter than that.
bool has_stood(const Trajectory& trajectory, double now, const mrpt::math::TPose2D& pose,
               bool is_disc);

}  // namespace slalom
