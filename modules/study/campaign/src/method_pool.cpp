// SPDX-License-Identifier: BSD-3-Clause
#include "command_journal.h"

#include <slalom/campaign/method_pool.h>
#include <slalom/core/error.h>
#include <slalom/workers/worker_sandbox.h>

namespace slalom {

PoolOptions method_pool(const LimitsSection& limits, const WallClock& clock) {
  if (limits.sandbox && !can_sandbox())
    throw usage_error("limits.sandbox", "the kernel cannot confine processes",
                      "false, or Linux 5.13 or later with Landlock");
  PoolOptions pool;
  pool.limits.memory_mb = limits.memory_mb;
  pool.limits.sandbox = limits.sandbox;
  pool.limits.network = limits.network;
  pool.hooks.clock = clock;
  pool.keep_stderr = limits.method_errors;
  return pool;
}

PoolOptions pool_of_runs(const CampaignOptions& options, int workers) {
  PoolOptions pool = method_pool(options.limits, options.clock);
  pool.schedule.workers = workers;
  pool.limits.item_wall_time = options.limits.run_wall_time;
  pool.limits.item_cpu_time = options.limits.run_cpu_time;
  pool.log_size = CommandJournal::size_for(options.simulation);
  if (options.deadline.deadline_policy == DeadlinePolicy::Fail)
    pool.limits.heartbeat_timeout = options.deadline.cycle_deadline;
  return pool;
}

Outcome outcome_of(const WorkResult& result) {
  using Status = WorkResult::Status;
  if (result.status == Status::TimedOut) return Outcome::MethodDeadline;
  // The simulator catches exceptions of methods: any other is an infrastructure error.
  if (result.status == Status::Threw || result.status == Status::Killed)
    return Outcome::InfrastructureError;
  return Outcome::MethodCrash;
}

}  // namespace slalom
