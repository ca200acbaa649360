// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/rawlog/open_loop.h>

#include <string>
#include <vector>

namespace slalom {

/// Counts and means over the answers to all scans of a log.
struct OpenLoopSummary {
  std::string log, method;
  double goal_ahead = 0;  ///< m
  std::size_t scans = 0, with_odometry = 0;
  std::size_t commands = 0, problems = 0;  ///< scans with and without a valid command
  std::size_t in_contact = 0, stopping = 0, one_second = 0;  ///< see ContactPrediction
  double mean_v = 0;                                         ///< m/s, of the commands
  double mean_uncovered = 0;                                 ///< rays
  /// Mean distance of the commands from the velocities that the log has at the next scan.
  std::size_t compared = 0;                   ///< commands before a scan with a velocity
  double difference_v = 0, difference_w = 0;  ///< m/s, rad/s
};

/// Leaves log, method and goal_ahead empty.
OpenLoopSummary summarize(const std::vector<LoggedScan>& scans,
                          const std::vector<OpenLoopAnswer>& answers);

std::string render_text(const OpenLoopSummary& summary);
/// A table with one line per answer, followed by an empty line.
std::string render_text(const std::vector<OpenLoopAnswer>& answers);
/// One line, with the answers if they are given.
std::string render_json(const OpenLoopSummary& summary, const std::vector<OpenLoopAnswer>& answers);

}  // namespace slalom
