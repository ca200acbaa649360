#pragma once

#include <slalom/rawlog/run_recorder.h>
#include <slalom/trajectory/trajectory.h>

#include <mrpt/obs/CObservation2DRangeScan.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// One control cycle as it was recorded: what the method was given and what was in force then.
struct RecordedCycle {
  Observation observation;  ///< bit-equal to the simulated one; its scan is the one below
  mrpt::obs::CObservation2DRangeScan::ConstPtr scan;
  mrpt::Clock::time_point stamp;  ///< mrpt::Clock in that cycle
  Command command;
};

/// A run as it was recorded.
struct RecordedRun {
  RunManifest manifest;
  std::optional<Task> task;  ///< none when the robot touched an obstacle where it starts
  std::vector<RecordedCycle> cycles;
  Trajectory trajectory;  ///< bit-equal to the simulated one
  Outcome outcome = Outcome::InfrastructureError;
  std::string detail;
};

/// Reads a run that make_rawlog_recorder() wrote. Throws Error (File) with file and reason when it
/// is missing, damaged, cut off, no recorded run, or contradicts itself.
RecordedRun read_run(const std::string& path);

}  // namespace slalom
