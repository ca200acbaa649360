#pragma once

#include <slalom/rawlog/run_reader.h>

#include <optional>
#include <string>

namespace slalom {

/// Gives a method the observations of a recorded run in their order, on simulated time, and says
/// where its answer first differs from the recorded command, bit by bit ("cycle 3 (0.2 s): ..."),
/// or nothing when no answer does. What the method throws counts as a difference.
std::optional<std::string> first_difference(const RecordedRun& run, Method& method);

}  // namespace slalom
