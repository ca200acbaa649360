// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wait_until.h"

#include <slalom/studio/jobs.h>

namespace slalom {

/// Polls like the window until all jobs are finished and delivered.
inline void finish_jobs(Jobs& jobs) {
  wait_until([&jobs] {
    jobs.poll();
    return jobs.idle();
  });
}

}  // namespace slalom
