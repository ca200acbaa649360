// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pose_motions.h"

#include <slalom/references/reference.h>

namespace slalom {

/// The goal in 16 headings, those that are free of contact.
std::vector<mrpt::math::TPose2D> goal_poses(const PlanningProblem& problem,
                                            const PoseMotions& motions);

/// A path of poses from the start to the goal, each motion free; empty if none was found. It is the
/// shortest on a roadmap along the exact shortest paths of discs of several radii, from the
/// inscribed one (problem.robot_radius) to one that the robot can follow: poses on them, along
/// their tangents, connected to later ones, and poses around the start.
std::vector<mrpt::math::TPose2D> path_on_roadmap(const PlanningProblem& problem,
                                                 const PoseMotions& motions);

}  // namespace slalom
