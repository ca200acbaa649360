// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/descriptors/descriptor.h>

namespace slalom {

/// Mean over the lattice points of the mean free length of 8 rays / the robot's width; 0 at points
/// in or on an obstacle. `movers` are obstacles in addition.
double mean_free_ray(const DescriptorContext& context, const Primitives& movers = {});

}  // namespace slalom
