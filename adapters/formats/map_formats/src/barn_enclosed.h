// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "npy.h"

namespace slalom {

/// Restores the occupied cells (1) of a grid of BARN that its world of Gazebo lacks: there no
/// cylinder is written for a cell whose eight neighbors are occupied. Enclosed free cells are
/// filled unless a cylinder that is written would then not have been.
void fill_enclosed(NpyTable& grid);

}  // namespace slalom
