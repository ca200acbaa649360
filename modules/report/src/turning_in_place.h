// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/run_record.h>
#include <slalom/trajectory/trajectory.h>

#include <cstddef>
#include <string>
#include <vector>

namespace slalom {

/// Counts the failures of each method at whose end the robot turns without moving. A method that
/// does so often may turn to what its sensor does not see.
class TurningInPlace {
 public:
  explicit TurningInPlace(std::size_t methods) : failures_(methods), turning_(methods) {}

  /// Runs that succeeded, and failures without a trajectory, count nothing.
  void add(std::size_t method, const RunRecord& run, const Trajectory& trajectory);

  /// "turns in place at the end of 15 of 15 failures: ..."; empty below three such failures, and
  /// below half of all.
  std::string line_of(std::size_t method) const;

 private:
  std::vector<std::size_t> failures_, turning_;
};

/// Whether the robot moves at less than 0.05 m/s and turns at more than 0.1 rad/s for more than
/// half of the samples of the last 8 s.
bool ends_turning_in_place(const Trajectory& trajectory);

}  // namespace slalom
