// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/simulation/simulate.h>

namespace slalom {

/// Determines the outcome of a recorded trajectory by the rules of simulate(), from the true
/// geometry. Position and heading are interpolated linearly between samples. The trajectory of the
/// result ends at the terminating event, with a sample at that time. A log that ends before any
/// event is a timeout, with an explanation in the detail; one that begins in contact is an
/// unsolvable scenario. People react to the recorded robot. Throws std::invalid_argument for a
/// trajectory without samples.
SimulationResult evaluate_trajectory(const World& world, const RobotModel& robot,
                                     const SimulationOptions& options, const Trajectory& log,
                                     const PeopleSettings& people = {});

/// SimulationResult::movers and SimulationResult::hindrances of a recorded run: people react to the
/// recorded robot, as they did in a simulated run with these settings, to the bit. Between samples
/// the robot moves straight.
Movers movers_along(const World& world, const RobotModel& robot, const SimulationOptions& options,
                    const Trajectory& log, const PeopleSettings& people,
                    Hindrances* hindrances = nullptr);

}  // namespace slalom
