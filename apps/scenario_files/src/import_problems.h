// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/app/import_scenarios.h>

#include <string>
#include <vector>

namespace slalom {

/// The scenarios of one file, with additional information from it.
struct ImportedFile {
  std::vector<Scenario> scenarios;
  std::string published_lengths = {};
  std::vector<std::string> messages = {};
};

bool is_solvable(const Scenario& scenario, double robot_radius, std::string& reason);

/// The start and goal pairs of a MovingAI file on its map. Pairs that are unsolvable for the robot
/// are left out, with a message.
ImportedFile import_problems(const Scenario& map, const ImportRequest& request);

}  // namespace slalom
