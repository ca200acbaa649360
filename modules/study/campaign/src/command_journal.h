// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/simulation/run_observer.h>
#include <slalom/workers/shared_task_log.h>

#include <string>
#include <vector>

namespace slalom {

/// Logs every command of a run in memory that outlives the process. With the log, the run can be
/// replayed without the method, up to the point where it was aborted.
class CommandJournal : public RunObserver {
 public:
  explicit CommandJournal(SharedTaskLog& log) : log_(log) {}

  void on_start(const NavigationTask&) override { log_.heartbeat(); }
  void on_cycle(const Observation&, const Command& command,
                const mrpt::math::TPose2D& pose) override;
  void on_end(const SimulationResult&) override {}

  /// The maximum size of a run's journal in bytes.
  static std::size_t size_for(const SimulationOptions& options);

  /// The commands in a journal, up to the first invalid one: the process that wrote it may have
  /// been corrupted.
  static std::vector<Command> read(const std::string& log, const RobotModel& robot);

 private:
  SharedTaskLog& log_;
};

}  // namespace slalom
