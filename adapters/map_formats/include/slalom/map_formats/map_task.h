#pragma once

#include <slalom/scenario/scenario.h>

#include <optional>
#include <string>

namespace slalom {

/// What a map file has no place for.
struct MapTask {
  std::string name;
  mrpt::math::TPose2D start;
  mrpt::math::TPoint2D goal;
};

/// The task file of a map: "office.task.yaml" beside "office.yaml" or "office.gridmap.gz".
std::string task_path(const std::string& map_path);

void write_map_task(const Scenario& scenario, const std::string& map_path);

/// The task beside a map, if there is one. Throws Error (File): file, line, what was expected.
std::optional<MapTask> read_map_task(const std::string& map_path);

/// The same from the text of a task file.
MapTask parse_map_task(const std::string& text, const std::string& where);

}  // namespace slalom
