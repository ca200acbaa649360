// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/io/scenario_list.h>
#include <slalom/scenario/convert.h>

#include <string>
#include <vector>

namespace slalom {

/// Settings of the conversion of a list.
struct ListConversion {
  Representation to = Representation::Continuous;
  ConversionOptions options;
  bool skip_blocked = false;  ///< leave out scenarios whose start or goal becomes occupied
};

/// Appends the scenarios of `list` to `output` in another representation, with their tags, and
/// stores the conversion as note "origin". Returns a message for each scenario that was left out.
/// Throws Error (Job) for one that may not be left out.
std::vector<std::string> convert_list(const ScenarioList& list, const ListConversion& conversion,
                                      ScenarioList& output);

}  // namespace slalom
