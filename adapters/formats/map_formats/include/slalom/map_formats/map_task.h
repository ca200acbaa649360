// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/scenario.h>

#include <optional>
#include <string>

namespace slalom {

/// Properties of a scenario that map files cannot store.
struct MapTask {
  std::string name;
  mrpt::math::TPose2D start;
  mrpt::math::TPoint2D goal;
  std::optional<double> goal_heading = {};  ///< rad
};

/// The task file of a map: "office.task.yaml" next to "office.yaml" or "office.gridmap.gz".
std::string task_path(const std::string& map_path);

void write_map_task(const Scenario& scenario, const std::string& map_path);

/// Reads the task file of a map, if it exists. Throws Error (File): file, line, what was expected.
std::optional<MapTask> read_map_task(const std::string& map_path);

/// Parses the text of a task file.
MapTask parse_map_task(const std::string& text, const std::string& where);

}  // namespace slalom
