#pragma once

#include <slalom/simulation/simulate.h>

namespace slalom {

/// Judges a trajectory that was not simulated, as far as a log allows: by the rules of simulate(),
/// from the true geometry. Between samples the position moves straight and the heading turns
/// evenly. The result's trajectory is cut at what ends the run, with a sample at that instant. A
/// log that ends before anything happened counts as a timeout, and the detail says so; one that
/// begins at a contact as an unsolvable scenario. Throws std::invalid_argument for a trajectory
/// without samples.
SimulationResult judge_trajectory(const World& world, const RobotModel& robot,
                                  const SimulationOptions& options, const Trajectory& log);

}  // namespace slalom
