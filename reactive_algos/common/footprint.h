// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/arcs.h"
#include "common/clearance_map.h"
#include "common/robot.h"

#include <cstddef>

namespace reactive {

/// The robot with discs that cover its footprint: several discs for a polygon, whose radius is then
/// that of the largest disc inside and what the discs exceed the polygon by, 0.16 of it if no
/// corner is sharper than a right angle.
Robot with_cover_discs(Robot robot);

/// Clearance of the footprint on the scale of a disc's center: the distance from the footprint to
/// the closest obstacle point, plus the robot's radius; m.
double footprint_clearance(const ClearanceMap& map, const Pose& pose, const Robot& robot);
/// The same at the first `count` poses. Arrays have padded(count) elements.
void footprint_clearances(const ClearanceMap& map, const PoseBatch& poses, std::size_t count,
                          const Robot& robot, double* clearances);

/// The angle (rad) that the robot can rotate in place to the left (side 1) or right (-1) before its
/// footprint comes closer to an obstacle than `radius` allows, at most `limit`. A robot that is
/// closer than 0.02 m already does not come closer.
double free_rotation(const ClearanceMap& map, const Pose& pose, const Robot& robot, double radius,
                     int side, double limit);

/// Whether it can rotate with `w` (rad/s) for `period` s and then brake.
bool can_rotate(const ClearanceMap& map, const Pose& pose, const Robot& robot, double radius,
                double w, double period);

}  // namespace reactive
