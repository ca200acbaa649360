// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/io/scenario_list.h>

#include <string>
#include <vector>

namespace slalom {

/// A hash of the content of a list: 32 hexadecimal digits over the sorted content hashes of its
/// scenarios. Independent of order, names, tags, values and notes.
std::string content_hash(const ScenarioList& list);
/// The same of the content hashes of scenarios, in any order.
std::string content_hash(std::vector<std::string> hashes);

}  // namespace slalom
