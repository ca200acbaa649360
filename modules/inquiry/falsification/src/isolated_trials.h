// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/falsification/trial.h>
#include <slalom/workers/worker_pool.h>

#include <functional>
#include <map>
#include <string>

namespace slalom {

/// The limits of processes in which methods run, for work items that are many runs.
PoolOptions pool_of_trials(const FalsificationSetup& setup);

/// Creates the methods of a setup when they are needed, and again after a failure that may have
/// damaged them.
class MethodPool {
 public:
  explicit MethodPool(const FalsificationSetup& setup) : setup_(setup) {}
  /// An error of the method's construction is the outcome method_error.
  Trial run(const World& world, std::size_t method);
  Method& method(std::size_t index);

 private:
  const FalsificationSetup& setup_;
  std::map<std::size_t, std::unique_ptr<Method>> methods_;
};

/// Source of the trials of a job.
class TrialSource {
 public:
  virtual ~TrialSource() = default;
  /// `method` as in FalsificationSetup::method_at().
  virtual const Trial& trial(const World& world, std::size_t method) = 0;
};

/// A computation that depends only on trials: the same trials, the same computation.
using TrialJob = std::function<void(TrialSource& source)>;

/// Executes jobs whose trials may crash. A job runs in a worker process; each trial is logged in
/// memory that this process shares. When the worker dies, the trial that it had begun is a crash,
/// and the job is repeated in a new worker with the trials that are known. In the end it is
/// executed in this process, with all trials known, for its results.
class IsolatedTrials {
 public:
  IsolatedTrials(const FalsificationSetup& setup, std::function<bool()> interrupted)
      : setup_(setup), interrupted_(std::move(interrupted)) {}

  /// False when interrupted. Throws Error (Job) when the job throws.
  bool execute(const TrialJob& job);
  std::size_t count() const { return known_.size(); }  ///< trials so far
  /// The same during execute(), with those of the running worker.
  std::size_t begun() const { return begun_.heartbeats(); }

 private:
  bool extend(const TrialJob& job, bool& complete);
  void read_log(const std::string& log, const WorkResult& result);

  const FalsificationSetup& setup_;
  std::function<bool()> interrupted_;
  SharedTaskLog begun_{0};              ///< a heartbeat for each trial
  std::map<std::string, Trial> known_;  ///< by key
};

/// The outcome of a trial whose process died. Throws Error (Job) if that was not its doing.
Trial trial_of_dead_process(const WorkResult& result);

/// One trial in a new process.
Trial run_alone(const FalsificationSetup& setup, const Scenario& scenario, std::size_t method);

}  // namespace slalom
