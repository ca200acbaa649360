#pragma once

#include <slalom/campaign/task_notes.h>
#include <slalom/simulation/run_observer.h>

#include <string>
#include <vector>

namespace slalom {

/// Notes every command of a run where it survives the process. With them the run can be driven
/// again up to where it broke off, without the method.
class CommandJournal : public RunObserver {
 public:
  explicit CommandJournal(TaskNotes& notes) : notes_(notes) {}

  void on_start(const Task&) override { notes_.beat(); }
  void on_cycle(const Observation&, const Command& command,
                const mrpt::math::TPose2D& pose) override;
  void on_end(const SimulationResult&) override {}

  /// Bytes that the journal of a run needs at most.
  static std::size_t size_for(const SimulationOptions& options);

  /// The commands in a journal; stops at what can be none, since the process that wrote it may have
  /// been out of its mind.
  static std::vector<Command> read(const std::string& notes, const RobotModel& robot);

 private:
  TaskNotes& notes_;
};

}  // namespace slalom
