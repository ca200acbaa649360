// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/person.h>

#include <yaml-cpp/yaml.h>

#include <string>

namespace slalom {

/// The key `people` with its list; "" without people.
std::string people_to_yaml(const People& people);

/// Parses the value of that key. Throws Error (File) with line and what was expected. What people
/// have in common is checked by the Scenario that gets them.
People people_from_yaml(const YAML::Node& list, const std::string& where);

}  // namespace slalom
