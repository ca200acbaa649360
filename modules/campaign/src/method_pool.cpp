// SPDX-License-Identifier: BSD-3-Clause
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

}  // namespace slalom
