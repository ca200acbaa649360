#pragma once

#include <slalom/io/scenario_list.h>

#include <string>

namespace slalom {

/// What identifies the content of a list: 32 hexadecimal digits over the sorted content hashes of
/// its scenarios. Order, names, tags, values and notes do not count.
std::string content_hash(const ScenarioList& list);

}  // namespace slalom
