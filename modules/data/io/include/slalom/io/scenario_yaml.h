// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/scenario.h>

#include <string>

namespace slalom {

/// A scenario as human-readable YAML. Grids are rows of '.' (free) and '#' (occupied), top row
/// first.
std::string scenario_to_yaml(const Scenario& scenario);

/// Parses it. Throws Error (File) with file, line and what was expected.
Scenario scenario_from_yaml(const std::string& text, const std::string& where);
Scenario load_scenario_yaml(const std::string& path);

}  // namespace slalom
