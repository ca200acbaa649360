// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/mover.h>

#include <string>

namespace slalom {

/// Whether a text is an agents.yaml of HuNavSim.
bool is_hunav(const std::string& text);

/// The agents of such a file, in its order: from the pose at the begin over the goals at `max_vel`,
/// then back to the begin in a loop if the goals are cyclic. Behaviors and social forces are left
/// out. Throws Error (File) with line and what was expected.
Movers hunav_agents(const std::string& text, const std::string& where);

}  // namespace slalom
