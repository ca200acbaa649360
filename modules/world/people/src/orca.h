// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/people/neighborhood.h>

namespace slalom {

/// The velocity by reciprocal avoidance (ORCA; van den Berg, Guy, Lin and Manocha 2011): the
/// nearest to the wanted one at which no neighbor is touched within the horizon if it takes its
/// share of the avoidance. Requires neighbors that are sorted by place.
mrpt::math::TPoint2D orca_velocity(const Neighborhood& around, const PeopleSettings& settings);

}  // namespace slalom
