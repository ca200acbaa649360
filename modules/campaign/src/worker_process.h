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
  explicit WorkerProcess(const PoolOptions& options)
      : options_(options), notes_(options.notes_size) {}
  ~WorkerProcess() { kill_and_reap(); }
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  bool alive() const { return pid_ > 0; }
  bool busy() const { return task_.has_value(); }
  std::size_t task() const { return *task_; }
  int socket() const { return socket_; }

  /// Forks. Throws Error (Job) when the system has no process or socket left.
  void start(const WorkerTask& task);
  void assign(std::size_t index);

  /// A result when the task is over: done, its process dead, or out of time and killed.
  std::optional<TaskResult> receive();

  void kill_and_reap();

 private:
  using Clock = std::chrono::steady_clock;
  using Status = TaskResult::Status;

  std::optional<TaskResult> read_answer();
  /// Which limit the task has passed, for people; empty for none.
  std::string passed_limit();
  /// The result of a task whose process is dead or must die; `why` empty: tell how it ended.
  TaskResult end(Status status, std::string why);
  int reap();  ///< waitpid's status

  PoolOptions options_;
  TaskNotes notes_;
  pid_t pid_ = -1;
  int socket_ = -1;
  std::optional<std::size_t> task_;
  Clock::time_point started_, last_beat_;
  std::uint64_t beats_ = 0;
  std::string buffer_;
};

}  // namespace slalom
