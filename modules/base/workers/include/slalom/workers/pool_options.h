// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/array_stream.h>
#include <slalom/core/shared_array.h>
#include <slalom/core/wall_clock.h>
#include <slalom/workers/shared_task_log.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Bytes that are kept of the standard output and error of a work item: the beginning and the end.
constexpr std::size_t kMaxOutput = 4096;

/// The result of one work item.
struct WorkResult {
  enum class Status {
    Done,         ///< payload holds the returned bytes
    Threw,        ///< an exception was thrown; detail holds its message
    OutOfMemory,  ///< std::bad_alloc was thrown
    Crashed,      ///< the process died or sent nonsense; detail describes how
    TimedOut,     ///< the process was killed after a time limit; detail names the limit
    Killed        ///< the system killed the process for want of memory, twice
  };
  Status status = Status::Done;
  std::string payload;
  std::string detail;
  std::string log;          ///< contents of the shared log, unless Done
  std::string output = {};  ///< printed meanwhile, at most kMaxOutput bytes and a line on the rest
};

/// Bytes that several work items use, such as the tables of a scenario. Each input is made once, in
/// a process that executes no work items, at most `workers` of them ahead of their work items. The
/// processes of these map it read-only; none can change it for another. It is released when the
/// last of its work items is finished. Work items with the same input follow each other.
struct SharedInputs {
  /// The input of a work item, if it uses one. Null: none does.
  std::function<std::optional<std::size_t>(std::size_t index)> of = nullptr;
  /// Writes an input. When it fails, or the system cannot share memory, there is none.
  std::function<void(std::size_t input, const ArrayWriter::Sink& sink)> make = nullptr;
  /// Executed in the process of a work item before it, if there is an input.
  std::function<void(std::size_t input, const SharedArray<std::byte>& memory)> use = nullptr;
};

/// Returns the count of the kernel for this machine (/proc/vmstat); 0 where there is none.
std::uint64_t count_memory_kills();

/// The limits of a worker process, and what it can change.
struct WorkerLimits {
  double item_wall_time = 0;     ///< s; a work item that takes longer is killed; 0: unlimited
  double item_cpu_time = 0;      ///< s of CPU time; 0: unlimited
  double heartbeat_timeout = 0;  ///< s, maximum time after a heartbeat; 0: unlimited
  double memory_mb = 0;          ///< MiB a worker may allocate after its start; 0: unlimited
  /// Workers can change files only in a folder of their own for temporary files, TMPDIR, and in
  /// `writable`. Requires that the kernel can do it; not for trusted work items.
  bool sandbox = false;
  std::vector<std::string> writable = {};
  bool network = true;  ///< workers can make sockets of networks; not false for trusted work items
};

/// Schedule of the work items over processes.
struct WorkSchedule {
  int workers = 1;
  bool ordered = true;            ///< results in the order of the indexes, or as they are obtained
  bool process_per_item = false;  ///< a new process for each work item
  bool trusted = false;           ///< work items start no processes: no keeper, which costs a fork
  bool in_process = false;        ///< execute work items in this process, without limits
  /// A process executes only work items of one of `groups` groups. Null: all are of one group.
  std::function<std::size_t(std::size_t index)> group = nullptr;
  std::size_t groups = 1;
};

/// Functions that the pool calls.
struct WorkHooks {
  /// In the calling process, of the payload of a work item that is done, before it is passed on.
  /// When it is false the item has crashed, and its process is replaced. Null: all are valid.
  std::function<bool(std::size_t index, const std::string& payload)> is_valid = nullptr;
  /// Executed in a worker process that is no longer needed, before it exits. It has
  /// kShutdownTimeout to complete. Not executed when the process is killed or replaced.
  std::function<void()> at_end = nullptr;
  /// For item_wall_time and heartbeat_timeout; read in the parent process.
  WallClock clock = steady_seconds;
  /// The number of processes that the system has killed for want of memory.
  std::function<std::uint64_t()> memory_kills = count_memory_kills;
};

struct PoolOptions {
  WorkerLimits limits = {};
  WorkSchedule schedule = {};
  WorkHooks hooks = {};
  SharedInputs inputs = {};
  std::size_t log_size = 0;  ///< bytes, capacity of the shared log
  /// Show on standard error what confined workers print, and keep none of it in the results.
  bool keep_stderr = false;
};

/// The detail of a work item whose payload was not valid.
constexpr char kInvalidPayload[] = "the worker's reply was corrupted";

/// Time for WorkHooks::at_end, after which the process is killed; s.
constexpr double kShutdownTimeout = 2;

/// A work item, executed in a worker process. Returns bytes for the parent process.
using WorkItem = std::function<std::string(std::size_t index, SharedTaskLog& log)>;

}  // namespace slalom
