#pragma once

#include <mrpt/nav/holonomic/CAbstractHolonomicReactiveMethod.h>
#include <mrpt/nav/tpspace/CParameterizedTrajectoryGenerator.h>

#include <cstddef>
#include <memory>

namespace slalom {

/// What CHolonomicFullEval needs since MRPT 2.14.3 to work outside of a navigator, by default as in
/// MRPT 2.5: an eighth weight, of the heading at the target (0, as goals have none; its own
/// defaults and .ini files of before have seven and are refused in navigate()), and a trajectory
/// generator, without which it crashes. Does nothing for other methods and other versions. The
/// generator must live as long as the method uses it.
/// @param sectors of the full circle
std::unique_ptr<mrpt::nav::CParameterizedTrajectoryGenerator> complete_full_eval(
    mrpt::nav::CAbstractHolonomicReactiveMethod& method, std::size_t sectors);

}  // namespace slalom
