// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/result_table.h>

#include <string>

namespace slalom {

/// The line about runs whose commands were not all given in their cycle, as methods in other
/// processes count them ("commands_missing", ...): "nav2: commands were missing (35) or stale (2)
/// in 12 of 40 runs, which depend on the speed of the machine". Empty if there are none.
std::string untimely_commands(const ResultTable& table, const std::string& method);

/// The last line of what the method of a run printed that has ERROR or FATAL in it, as logs of ROS,
/// and is not between kEndingOutput and kEndedOutput; "" if there is none.
std::string last_error_printed(const std::string& output);
/// "; the last error that it printed: ..." for the end of a message; "" if there is none.
std::string error_printed_clause(const std::string& output);

/// The line about commands that the limits of the robot changed ("commands_limited"): "nav2: 35
/// commands in 12 of 40 runs beyond the robot's limits, which changed them". Empty if there are
/// none.
std::string limited_commands(const ResultTable& table, const std::string& method);

}  // namespace slalom
