// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/rawlog/run_recorder.h>
#include <slalom/trajectory/trajectory.h>

#include <mrpt/obs/CObservation2DRangeScan.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// One recorded control cycle: the input of the method and the command in force.
struct RecordedCycle {
  Observation observation;  ///< bit-identical to the simulated one; refers to the scans
  mrpt::obs::CObservation2DRangeScan::ConstPtr scan;
  std::vector<mrpt::obs::CObservation2DRangeScan::ConstPtr> lasers;
  mrpt::Clock::time_point stamp;  ///< mrpt::Clock in that cycle
  Command command;
};

/// A recorded run.
struct RecordedRun {
  RunManifest manifest;
  std::optional<NavigationTask> task;  ///< nullopt if the robot collides at the start
  std::vector<RecordedCycle> cycles;
  Trajectory trajectory;  ///< bit-identical to the simulated one
  Outcome outcome = Outcome::InfrastructureError;
  std::string detail;
};

/// Reads a run written by make_rawlog_recorder(). Throws Error (File) with file and reason if it is
/// missing, corrupt, truncated, not a recorded run, or inconsistent.
RecordedRun read_run(const std::string& path);

}  // namespace slalom
