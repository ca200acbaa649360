// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "worker_socket.h"

#include <cstddef>
#include <functional>
#include <sys/types.h>
#include <vector>

namespace slalom {

/// The message of a keeper whose worker could not be created; otherwise it sends waitpid's status.
constexpr int kNoWorker = -1;

/// The process from which the workers of a pool are forked: a copy of the calling process from
/// before its first worker. It does not grow with the caller, and to replace a worker takes one
/// fork. Everything falls back to it that a worker started and left behind, also what left its
/// process group and session. It stays clean: no code of a method runs in it.
class WorkerKeeper {
 public:
  /// `serve`: executed in each worker.
  WorkerKeeper(bool keep_stderr, std::function<void(const WorkerStart&)> serve);
  ~WorkerKeeper();  ///< kills all workers
  WorkerKeeper(const WorkerKeeper&) = delete;
  WorkerKeeper& operator=(const WorkerKeeper&) = delete;

  /// Starts a worker. When it ends, or the other end of `control` is shut down or closed (also by
  /// the death of its process), the keeper kills whatever is left of the worker and removes
  /// `scratch`; then it sends the worker's status to `control` and closes it. If the keeper was
  /// killed, there is a new one. Throws Error (Job) when there can be none.
  void start_worker(const WorkerStart& start);

  /// Whether the process that started the last worker had not been killed when this was called.
  bool is_alive();
  /// To be called about every 20 ms while nothing happens: a process that does not go on reports no
  /// end of a worker.
  void kill_if_stopped();
  /// The number of processes until now. The workers of the last one only are alive.
  std::size_t generation() const { return generation_; }

 private:
  void begin();
  void end();
  bool await_message();

  bool keep_stderr_;
  std::function<void(const WorkerStart&)> serve_;
  pid_t process_ = -1;
  std::size_t generation_ = 0;
  int stopped_ = 0;  ///< how often in turn it was found stopped
  FileDescriptor socket_;
};

/// Reduces a process that was just forked to what a worker needs: standard input is /dev/null,
/// standard output (and standard error unless `keep_stderr`) are discarded, and all other
/// descriptors except `kept` are closed.
void drop_descriptors(bool keep_stderr, std::vector<int> kept);

}  // namespace slalom
