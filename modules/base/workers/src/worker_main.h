// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "worker_socket.h"

#include <slalom/workers/pool_options.h>

#include <cstddef>
#include <functional>
#include <memory>

namespace slalom {

/// Executed in a worker before a work item that was assigned with a descriptor. It is closed after.
using FileReceiver = std::function<void(std::size_t index, int file)>;

/// The log of a work item, and where it prints.
struct WorkerChannel {
  std::unique_ptr<SharedTaskLog> log;
  int output = -1;  ///< -1: where it prints anyway
};

/// The main loop of a worker process, until the other end of `socket` is shut down. Work items use
/// the two channels by turns, the second one first: one can begin before the parent has read the
/// answer, log and output of the one before.
void serve_work_items(int socket, const WorkItem& item, const PoolOptions& options,
                      const FileReceiver& receive_file, const WorkerChannel (&channels)[2]);

/// The same for a process that a keeper has just forked: with the logs and in the sandbox that it
/// is to have, and without any descriptor but its socket and outputs.
void serve_confined(const WorkerStart& start, const WorkItem& item, const PoolOptions& options,
                    const FileReceiver& receive_file);

}  // namespace slalom
