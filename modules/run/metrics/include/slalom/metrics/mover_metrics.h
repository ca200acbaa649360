// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace slalom {

/// The ids of the metrics that are about moving obstacles, in the order of all_metrics(). Without a
/// mover in the scenario they are NA.
const std::vector<std::string>& mover_metric_ids();

/// The same of the metrics about people who may notice the robot, NA where there are none.
const std::vector<std::string>& people_metric_ids();

/// The same of the metrics about the heading of the goal, NA where it has none.
const std::vector<std::string>& goal_heading_metric_ids();

}  // namespace slalom
