// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/rawlog/run_reader.h>

#include <optional>
#include <string>

namespace slalom {

/// Passes the observations of a recorded run to a method, in order and on simulated time. Returns
/// the first bitwise difference from the recorded commands ("cycle 3 (0.2 s): ..."), or nullopt.
/// An exception of the method counts as a difference.
std::optional<std::string> first_difference(const RecordedRun& run, Method& method);

}  // namespace slalom
