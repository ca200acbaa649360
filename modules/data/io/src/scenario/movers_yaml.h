// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/mover.h>

#include <yaml-cpp/yaml.h>

#include <string>

namespace slalom {

/// The key `movers` with its list; "" without movers.
std::string movers_to_yaml(const Movers& movers);

/// Parses the value of that key. Throws Error (File) with line and what was expected. Ids used
/// twice are refused by the Scenario that gets them.
Movers movers_from_yaml(const YAML::Node& list, const std::string& where);

}  // namespace slalom
