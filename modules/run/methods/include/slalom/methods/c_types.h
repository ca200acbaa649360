// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/methods/method.h>
#include <slalom/methods/slalom_method.h>

#include <vector>

namespace slalom {

/// The types of slalom_method.h; what a method is given in C. `corners`, `ranges` and `cells` of
/// the map hold what the results point to.
slalom_robot to_c(const RobotModel& robot, const SensorModel& sensor, std::vector<double>& corners);
slalom_task to_c(const NavigationTask& task);
slalom_observation to_c(const Observation& observation, std::vector<float>& ranges);
slalom_map to_c(const KnownMap& map);
std::vector<slalom_track> to_c(const std::vector<Track>& tracks);

}  // namespace slalom
