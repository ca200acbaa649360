// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/trajectory/trajectory.h>

#include <string>

namespace slalom {

/// A trajectory as bytes, for files and between processes; doubles are exact. Reading validates all
/// data and throws Error (File) at `where`.
std::string to_bytes(const Trajectory& trajectory);
Trajectory trajectory_from_bytes(const std::string& bytes, const std::string& where);

}  // namespace slalom
