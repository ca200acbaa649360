#pragma once

#include <slalom/references/any_angle.h>
#include <slalom/scenario/occupancy.h>

namespace slalom {

/// The robot's free configuration space on cells, each cell of the occupancy split into
/// subdivision^2: `outer` has every cell that may contain a free point (paths through it bound L*
/// from below), `inner` only cells all of whose points are free (paths through it are free).
struct ConfigurationCells {
  CellGrid outer, inner;
  double cell_size = 0;  ///< m
};

ConfigurationCells make_configuration_cells(const Occupancy& occupancy, double robot_radius,
                                            int subdivision);

}  // namespace slalom
