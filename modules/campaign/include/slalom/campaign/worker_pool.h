#pragma once

#include <slalom/campaign/task_notes.h>

#include <cstddef>
#include <functional>
#include <string>

namespace slalom {

/// What became of one task.
struct TaskResult {
  enum class Status {
    Done,         ///< payload is what the task returned
    Threw,        ///< the task threw; detail is the exception's reason
    OutOfMemory,  ///< the task threw std::bad_alloc
    Crashed,      ///< its process died; detail says how
    TimedOut      ///< its process was killed after a time limit; detail says which
  };
  Status status = Status::Done;
  std::string payload;
  std::string detail;
  std::string notes;  ///< what the task had noted, unless it is done
};

struct PoolOptions {
  int workers = 1;
  double task_wall_time = 0;  ///< s; a task that takes longer is killed; 0 for no limit
  double task_cpu_time = 0;   ///< s of processor time; 0 for no limit
  double silence = 0;         ///< s; a task that has begun to beat and stops is killed; 0: may stop
  double memory_mb = 0;       ///< MiB that a worker may take beyond what it starts with; 0: any
  std::size_t notes_size = 0;  ///< bytes that a task may note
  bool keep_errors = false;    ///< standard error of the workers stays; otherwise it is discarded
  bool fresh_process = false;  ///< a new process for each task instead of one per worker
};

/// One task, run in a worker process; it returns bytes for the parent.
using WorkerTask = std::function<std::string(std::size_t index, TaskNotes& notes)>;

/// Runs tasks 0 .. count-1 in forked worker processes and hands each result to `on_result` in the
/// order of the indexes, whatever the number of workers. A worker that dies or hangs costs only the
/// task it was at: it is replaced. Standard output of workers is discarded. `interrupted` is
/// polled; when it turns true the workers are killed and the function returns false with the
/// results so far handed over. Throws Error (Job) when no process can be made.
bool run_in_workers(std::size_t count, const PoolOptions& options, const WorkerTask& task,
                    const std::function<void(std::size_t, TaskResult&&)>& on_result,
                    const std::function<bool()>& interrupted);

}  // namespace slalom
