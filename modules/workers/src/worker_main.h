// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "worker_socket.h"

#include <slalom/workers/pool_options.h>

#include <cstddef>
#include <functional>

namespace slalom {

/// Executed in a worker before a work item that was assigned with a descriptor. It is closed after.
using FileReceiver = std::function<void(std::size_t index, int file)>;

/// The main loop of a worker process, until the other end of `socket` is shut down.
void serve_work_items(int socket, const WorkItem& item, const PoolOptions& options,
                      const FileReceiver& receive_file, SharedTaskLog& log);

/// The same for a process that a keeper has just forked: with the log and in the sandbox that it is
/// to have, and without any descriptor but its socket.
void serve_confined(const WorkerStart& start, const WorkItem& item, const PoolOptions& options,
                    const FileReceiver& receive_file);

}  // namespace slalom
