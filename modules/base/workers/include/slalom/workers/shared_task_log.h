// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace slalom {

/// A log in memory shared between a worker and the process that asks it to execute work items. Its
/// contents remain available when the worker process dies.
class SharedTaskLog {
 public:
  /// `capacity` in bytes, in memory that is shared with processes which are forked later. Throws
  /// Error (Job) when the system is out of memory.
  explicit SharedTaskLog(std::size_t capacity);
  /// The same in the memory of a descriptor from make_file(). Clears it.
  SharedTaskLog(std::size_t capacity, int file);
  ~SharedTaskLog();
  SharedTaskLog(const SharedTaskLog&) = delete;
  SharedTaskLog& operator=(const SharedTaskLog&) = delete;

  /// Memory for a log, whose size cannot be changed. -1 with errno if there is none.
  static int make_file(std::size_t capacity);

  void clear();  ///< at the start of a work item

  void append(const void* data, std::size_t size);  ///< ignored when the capacity is exceeded
  std::string contents() const;

  void heartbeat();  ///< signals progress, see WorkerLimits::heartbeat_timeout
  std::uint64_t heartbeats() const;

  /// Requests that the worker process be replaced after this work item, since its state may be
  /// corrupted.
  void retire_worker();
  bool is_retired() const;

  /// Called by a worker that cannot send its answer.
  void report_disconnected();
  bool is_disconnected() const;

 private:
  struct Header;
  std::size_t capacity_;
  Header* header_;
};

}  // namespace slalom
