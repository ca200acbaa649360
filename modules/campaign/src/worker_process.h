#pragma once

#include <slalom/campaign/worker_pool.h>

#include <chrono>
#include <optional>
#include <string>
#include <sys/types.h>

namespace slalom {

/// One forked worker and the socket to it. The parent sends an index, the worker answers with its
/// payload.
class WorkerProcess {
 public:
  using Clock = std::chrono::steady_clock;

  WorkerProcess() = default;
  ~WorkerProcess() { kill_and_reap(); }
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  bool alive() const { return pid_ > 0; }
  bool busy() const { return task_.has_value(); }
  std::size_t task() const { return *task_; }
  int socket() const { return socket_; }
  Clock::time_point started() const { return started_; }

  /// Forks. Throws Error (Job) when the system has no process or socket left.
  void start(const WorkerTask& task);
  void assign(std::size_t index);

  /// Reads what has arrived; a result when the task is over (done, or the process died).
  std::optional<TaskResult> receive();

  /// Kills the worker in the midst of its task.
  TaskResult time_out(double limit);

  std::string kill_and_reap();  ///< how it ended, for people

 private:
  TaskResult died();

  pid_t pid_ = -1;
  int socket_ = -1;
  std::optional<std::size_t> task_;
  Clock::time_point started_;
  std::string buffer_;
};

}  // namespace slalom
