// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/workers/pool_options.h>

#include <cstddef>
#include <functional>

namespace slalom {

/// Executes work items 0 .. count-1 in forked worker processes and passes each result to
/// `on_result`, unless `ordered` is false in the order of the indexes. A worker that dies or hangs
/// is replaced, and only its current work item is lost; whatever it started is killed with it. A
/// work item whose process was killed by SIGKILL, or with its keeper, is executed once more, alone
/// in a new process; if that is killed too, it has crashed, unless the system was out of memory. So
/// is one whose process dies before its first heartbeat, in a new process, if that has executed
/// others before, which may be the cause. Work items are started in the order of their indexes; at
/// most `workers` processes are busy. One that has executed short items gets the next one while it
/// is busy, and begins it without waiting for this process. Idle ones are kept for the next items
/// of their groups, in total `workers + groups` processes; beyond that the least recently used one
/// is ended. What workers print is in the results, unless they are trusted. `interrupted` is
/// polled; when it returns true, the workers are killed, and the function returns false. If the
/// results are ordered, those after a work item that was killed are dropped: what was passed on are
/// the first results, without a hole. Throws Error (Job) when no process can be created.
bool run_in_workers(std::size_t count, const PoolOptions& options, const WorkItem& item,
                    const std::function<void(std::size_t, WorkResult&&)>& on_result,
                    const std::function<bool()>& interrupted);

}  // namespace slalom
