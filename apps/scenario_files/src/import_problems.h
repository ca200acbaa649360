#pragma once

#include <slalom/app/import_scenarios.h>

#include <string>
#include <vector>

namespace slalom {

/// What one file gives: scenarios, and what else its source says about them.
struct ImportedFile {
  std::vector<Scenario> scenarios;
  std::string published_lengths = {};
  std::vector<std::string> messages = {};
};

bool is_solvable(const Scenario& scenario, double robot_radius, std::string& reason);

/// The pairs of a MovingAI file on its map. Those that the robot cannot solve are left out, with a
/// message.
ImportedFile import_problems(const Scenario& map, const ImportRequest& request);

}  // namespace slalom
