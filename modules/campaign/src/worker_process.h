#pragma once

#include <slalom/campaign/worker_pool.h>

#include <optional>
#include <string>
#include <sys/types.h>

namespace slalom {

/// A forked worker process and the socket to it. The parent sends an index, the worker replies with
/// the payload.
class WorkerProcess {
 public:
  explicit WorkerProcess(const PoolOptions& options) : options_(options), log_(options.log_size) {}
  ~WorkerProcess() { kill_and_reap(); }
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  bool alive() const { return pid_ > 0; }
  bool busy() const { return busy_; }
  bool idle() const { return alive() && !busy_; }
  std::size_t group() const { return group_; }
  std::size_t last_item() const { return item_; }  ///< the current one if busy
  int socket() const { return socket_; }

  /// Forks. Throws Error (Job) when no process or socket can be created.
  void start(const WorkItem& item, std::size_t group);
  void assign(std::size_t index);

  /// The result when the work item is done, its process has died, or it was killed at a time limit.
  std::optional<WorkResult> receive();

  void kill_and_reap();

  /// Makes an idle process execute PoolOptions::at_end and exit; then await_end().
  void request_end();
  /// Waits until the process has exited, and kills it after kOrderlyEnd.
  void await_end();

 private:
  using Status = WorkResult::Status;

  std::optional<WorkResult> read_answer();
  /// A description of the limit that was exceeded; empty if none.
  std::string exceeded_limit();
  /// The result after the process has died or was killed. Empty `reason`: from its exit status.
  WorkResult end(Status status, std::string reason);
  int reap();  ///< waitpid's status

  PoolOptions options_;
  SharedTaskLog log_;
  pid_t pid_ = -1;
  int socket_ = -1;
  std::size_t group_ = 0, item_ = 0;
  bool busy_ = false;
  double started_ = 0, last_heartbeat_ = 0;  ///< s, by the clock of the options
  std::uint64_t heartbeats_ = 0;
  std::string buffer_;
};

}  // namespace slalom
