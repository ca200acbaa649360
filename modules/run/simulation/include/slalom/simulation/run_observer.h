// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/methods/method.h>
#include <slalom/simulation/simulate.h>

namespace slalom {

/// Observes a run: the inputs and commands of the method and the true poses of the robot. Must not
/// influence the run.
class RunObserver {
 public:
  virtual ~RunObserver() = default;
  /// When the method is ready, before the first cycle.
  virtual void on_start(const NavigationTask& task) = 0;
  /// After each step of the method and before the robot moves. `pose` is the true one; `command` is
  /// in effect until the next cycle.
  virtual void on_cycle(const Observation& observation, const Command& command,
                        const mrpt::math::TPose2D& pose) = 0;
  /// After the run, with the complete result.
  virtual void on_end(const SimulationResult& result) = 0;
};

}  // namespace slalom
