#pragma once

#include <slalom/references/reference.h>
#include <slalom/trajectory/trajectory.h>

#include <string>

namespace slalom {

/// References and trajectories as compressed bytes; doubles are kept exactly. Reading checks
/// everything and throws Error (File) naming `where`.
std::string serialize(const References& references);
References deserialize_references(const std::string& bytes, const std::string& where);

std::string serialize(const Trajectory& trajectory);
Trajectory deserialize_trajectory(const std::string& bytes, const std::string& where);

}  // namespace slalom
