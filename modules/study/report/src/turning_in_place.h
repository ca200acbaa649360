// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/run_record.h>
#include <slalom/robot/robot_model.h>
#include <slalom/trajectory/trajectory.h>

#include <cstddef>
#include <string>
#include <vector>

namespace slalom {

/// Counts the failures of each method at whose end the robot turns in place (end_motion()). A
/// method that does so often may turn to what its sensor does not see.
class TurningInPlace {
 public:
  TurningInPlace(std::size_t methods, const RobotModel& robot)
      : radius_(robot.shape().enclosing_radius()),
        max_v_(robot.max_v),
        failures_(methods),
        turning_(methods) {}

  void add(std::size_t method, const RunRecord& run, const Trajectory& trajectory);

  /// "turns in place at the end of 15 of 15 failures: ..."; empty below three such failures, and
  /// below half of all.
  std::string line_of(std::size_t method) const;

 private:
  double radius_, max_v_;
  std::vector<std::size_t> failures_, turning_;
};

}  // namespace slalom
