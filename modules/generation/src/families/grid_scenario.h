// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/occupancy.h>
#include <slalom/scenario/scenario.h>

#include <string>

namespace slalom {

/// A grid scenario with these cells.
Scenario grid_scenario(const std::string& name, const Occupancy& cells,
                       const mrpt::math::TPose2D& start, const mrpt::math::TPoint2D& goal);

}  // namespace slalom
