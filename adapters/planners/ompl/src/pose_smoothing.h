// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pose_motions.h"

namespace slalom {

/// Shortens a path of poses whose motions are free, with the same start and the same position of
/// the goal: poses are left out and inserted, of curves also moved and turned, as long as the path
/// becomes shorter and remains free. Deterministic.
std::vector<mrpt::math::TPose2D> smooth(const PoseMotions& motions,
                                        std::vector<mrpt::math::TPose2D> poses);

}  // namespace slalom
