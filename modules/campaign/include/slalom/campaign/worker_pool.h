#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace slalom {

/// What became of one task.
struct TaskResult {
  enum class Status {
    Done,     ///< payload is what the task returned
    Crashed,  ///< its process died; detail says how
    TimedOut  ///< its process was killed after the time limit
  };
  Status status = Status::Done;
  std::string payload;
  std::string detail;
};

struct PoolOptions {
  int workers = 1;
  double task_wall_time = 0;   ///< s; a task that takes longer is killed; 0 for no limit
  bool fresh_process = false;  ///< a new process for each task instead of one per worker
};

/// One task, run in a worker process; it returns bytes for the parent. An exception it throws
/// counts as a crash with the exception's text.
using WorkerTask = std::function<std::string(std::size_t index)>;

/// Runs tasks 0 .. count-1 in forked worker processes and hands each result to `on_result` in the
/// order of the indexes, whatever the number of workers. A worker that dies or hangs costs only the
/// task it was at: it is replaced. Standard output of workers is discarded. `interrupted` is
/// polled; when it turns true the workers are killed and the function returns false with the
/// results so far handed over. Throws Error (Job) when no process can be made.
bool run_in_workers(std::size_t count, const PoolOptions& options, const WorkerTask& task,
                    const std::function<void(std::size_t, TaskResult&&)>& on_result,
                    const std::function<bool()>& interrupted);

}  // namespace slalom
