// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/error.h>
#include <slalom/trajectory/trajectory.h>

#include <string>

namespace slalom {

constexpr const char* kEqual = "the results of one campaign, which are equal";

inline bool ended_at_time_limit(const std::string& outcome) {
  return outcome == to_string(Outcome::MethodDeadline);
}

/// Names what differs in a file from those before it. `at_time_limit`: a run that a limit of time
/// ended in one of them, which tells nothing about the method.
inline Error unequal(const std::string& file, const std::string& what, bool at_time_limit = false) {
  const std::string problem = what + " differs from that in a file before it";
  if (!at_time_limit) return file_error(file, problem, kEqual);
  return file_error(file, problem + ": it ended at a time limit on one of the machines",
                    "[limits] that the slowest machine keeps");
}

}  // namespace slalom
