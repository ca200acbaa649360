// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "worker_keeper.h"
#include "worker_main.h"

#include <memory>
#include <optional>
#include <poll.h>
#include <random>
#include <string>
#include <sys/types.h>
#include <utility>
#include <vector>

namespace slalom {

/// The parent's end of a WorkerChannel.
class ReadChannel {
 public:
  std::unique_ptr<SharedTaskLog> log;
  FileDescriptor output;  ///< none: the output is not kept

  void clear();  ///< for a work item: what is left was written between work items

  /// Reads what the process has printed, so that it does not wait for room.
  void read_output();
  /// Returns what was printed since clear(), at most kMaxOutput bytes and a line on the rest.
  std::string take_output();

 private:
  std::string printed_, printed_last_;  ///< the beginning and the end, of kMaxOutput / 2 each
  std::size_t left_out_ = 0;            ///< bytes between them
};

/// A worker process and the sockets to it and to its keeper. The parent sends an index with a
/// random number, the worker replies with both and the payload. Nothing that the worker sends is
/// trusted.
class WorkerProcess {
 public:
  /// From a keeper, which has the work item.
  WorkerProcess(const PoolOptions& options, WorkerKeeper& keeper)
      : options_(options), keeper_(&keeper) {}
  /// Starts a process without a keeper, for trusted work items.
  WorkerProcess(const PoolOptions& options, const WorkItem& item, FileReceiver receive_file)
      : options_(options), trusted_item_(&item), receive_file_(std::move(receive_file)) {}
  ~WorkerProcess() { begin_end(); }
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  bool alive() const { return static_cast<bool>(socket_); }
  bool busy() const { return busy_ || ending_; }
  bool idle() const { return alive() && !busy_; }
  std::size_t group() const { return group_; }
  std::size_t last_item() const { return current_.index; }  ///< the current one if busy

  /// Whether an idle process is alive and has sent no unsolicited reply.
  bool is_sound() const;
  /// It has died before the first heartbeat of a work item that was not its first: an earlier one
  /// may be the cause.
  bool died_between_items() const { return died_between_items_; }

  /// Throws Error (Job) when no process or socket can be created.
  void start(std::size_t group);
  /// With a descriptor for the FileReceiver, or -1. It stays open here.
  void assign(std::size_t index, int file = -1);

  /// Whether it is busy with work items so short that it is worth to have the next one there.
  bool wants_next() const;
  /// Assigns a work item that begins when the current one ends.
  void assign_next(std::size_t index, int file);
  /// The next work item, if the process ended before it could begin.
  std::optional<std::size_t> take_unstarted();

  /// Adds the descriptors that become readable when read() is to be called.
  void add_events(std::vector<pollfd>& events) const;

  /// Reads what the process has sent.
  void read();
  void read_output() { channel().read_output(); }
  bool has_answer() const;  ///< all of it, or nonsense
  /// The result when, by what was read, the work item is done or its process has died, or when it
  /// was killed at a time limit. An answer counts only if the keeper was alive after read(). Waits,
  /// if the process is killed, until it and whatever it started have ended.
  std::optional<WorkResult> receive(bool keeper_is_alive);

  /// Kills the process. It is busy until the keeper has killed whatever it started; a trusted one
  /// has ended on return.
  void begin_end();

  /// Makes an idle process execute WorkHooks::at_end and exit; then await_end().
  void request_end();
  /// Waits until the process has exited, or kShutdownTimeout; then begin_end().
  void await_end();

 private:
  using Status = WorkResult::Status;

  void start_kept(WorkerStart& start);
  void fork_trusted(const WorkerStart& start);
  void read_socket();
  Request send(std::size_t index, int file);
  void begin_item(const Request& request);
  ReadChannel& channel() { return channels_[assigned_ % 2]; }  ///< of the current work item
  bool is_begin_of_next_answer(const std::string& bytes) const;
  std::optional<WorkResult> take_answer(bool keeper_is_alive);
  /// A description of the limit that was exceeded; empty if none.
  std::string exceeded_limit();
  std::optional<WorkResult> kill_with(Status status, std::string reason);
  std::optional<WorkResult> take_ended();    ///< once the process has ended
  std::optional<WorkResult> describe_end();  ///< of a process that has died
  std::optional<int>
  end_status();  ///< waitpid's status of the worker; none if the keeper was killed

  PoolOptions options_;
  WorkerKeeper* keeper_ = nullptr;
  const WorkItem* trusted_item_ = nullptr;
  FileReceiver receive_file_;
  ReadChannel channels_[2];  ///< work items use them by turns
  std::random_device random_;
  pid_t child_ = -1;            ///< a trusted worker
  FileDescriptor socket_;       ///< to the worker
  FileDescriptor control_;      ///< to the keeper or trusted worker: closed when the worker ends
  bool disconnected_ = false;   ///< the worker's end of the socket is closed
  bool has_died_ = false;       ///< by the last read()
  std::size_t generation_ = 0;  ///< of the keeper's process that has started this one
  std::size_t group_ = 0;
  Request current_ = {};         ///< the work item, also if it is done
  std::optional<Request> next_;  ///< is there already
  std::size_t assigned_ = 0;     ///< work items since start(), without the next one
  bool busy_ = false, ending_ = false, died_between_items_ = false;
  std::optional<WorkResult> result_;         ///< of the work item of a process that is ending
  double started_ = 0, last_heartbeat_ = 0;  ///< s, by the clock of the options
  double duration_ = 0;                      ///< s, of the last work item
  std::uint64_t heartbeats_ = 0;
  std::string buffer_;
};

}  // namespace slalom
