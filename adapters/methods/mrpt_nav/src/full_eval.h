// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/nav/holonomic/CAbstractHolonomicReactiveMethod.h>
#include <mrpt/nav/tpspace/CParameterizedTrajectoryGenerator.h>

#include <cstddef>
#include <memory>

namespace slalom {

/// Adds to CHolonomicFullEval what it needs since MRPT 2.14.3 to work outside of a navigator, by
/// default as in MRPT 2.5: an eighth weight, of the heading at the target, and a trajectory
/// generator, without which it crashes. The weight is 0, as goals have no heading; the defaults of
/// the class and .ini files for MRPT 2.5 have seven weights, which navigate() refuses. Does nothing
/// for other methods and other versions. The generator must live as long as the method uses it.
/// @param sectors of the full circle
std::unique_ptr<mrpt::nav::CParameterizedTrajectoryGenerator> complete_full_eval(
    mrpt::nav::CAbstractHolonomicReactiveMethod& method, std::size_t sectors);

}  // namespace slalom
