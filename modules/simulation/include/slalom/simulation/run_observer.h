#pragma once

#include <slalom/methods/method.h>
#include <slalom/simulation/simulate.h>

namespace slalom {

/// Sees a run from the side: what the method was given, what it answered, where the robot really
/// was. Changes nothing.
class RunObserver {
 public:
  virtual ~RunObserver() = default;
  /// Before the first cycle.
  virtual void on_start(const Task& task) = 0;
  /// After each answer of the method and before the robot moves. `pose` is the true one. `command`
  /// is what is in force until the next cycle.
  virtual void on_cycle(const Observation& observation, const Command& command,
                        const mrpt::math::TPose2D& pose) = 0;
  /// After the run; the result is whole.
  virtual void on_end(const SimulationResult& result) = 0;
};

}  // namespace slalom
