// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "file_descriptor.h"
#include "worker_process.h"

#include <slalom/workers/pool_options.h>

#include <cstddef>
#include <map>
#include <memory>
#include <poll.h>
#include <vector>

namespace slalom {

/// The SharedInputs of a pool: makes them in processes of their own, ahead of the work items that
/// use them, and holds the descriptors of their memory until all of these are finished; then the
/// process that wrote it uses it again.
class SharedInputPool {
 public:
  /// `count`: number of work items.
  SharedInputPool(std::size_t count, const PoolOptions& options);

  /// Whether a work item has to wait for its input.
  bool is_awaited(std::size_t item) const;
  /// Starts a process that makes the next input. False when enough are there or being made.
  bool make_next();
  /// Descriptor of the input of a work item that starts; -1 if there is none.
  int descriptor_for(std::size_t item);
  /// After the last execution of a work item.
  void release(std::size_t item);

  std::size_t busy() const;  ///< processes that make an input
  void add_events(std::vector<pollfd>& events) const;
  void collect();  ///< the inputs that have been made

  /// For the processes of work items.
  FileReceiver receiver() const;

 private:
  struct Maker {
    std::unique_ptr<WorkerProcess> process;
    std::vector<FileDescriptor> free_memory;  ///< that it has written, in no use
  };
  struct Input {
    std::size_t items = 0;  ///< that are not finished
    bool is_made = false, is_used = false;
    FileDescriptor memory;         ///< none: the input cannot be made
    std::weak_ptr<Maker> maker{};  ///< the process that can write the memory again
  };

  std::optional<std::size_t> input_of(std::size_t item) const;
  std::shared_ptr<Maker> idle_maker();

  std::size_t count_;
  PoolOptions options_;
  WorkItem nothing_;                     ///< of the makers: all is done by their FileReceiver
  std::size_t ahead_ = 0;                ///< inputs of work items before this one have been started
  std::map<std::size_t, Input> inputs_;  ///< of work items that are not finished
  std::vector<std::shared_ptr<Maker>> makers_;
};

}  // namespace slalom
