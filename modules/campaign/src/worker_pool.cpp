#include "worker_process.h"

#include <slalom/campaign/worker_pool.h>
#include <slalom/core/error.h>

#include <algorithm>
#include <map>
#include <memory>
#include <poll.h>
#include <vector>

namespace slalom {
namespace {

/// Forwards results in the order of their indexes.
class OrderedResults {
 public:
  using Receiver = std::function<void(std::size_t, WorkResult&&)>;
  explicit OrderedResults(const Receiver& receiver) : receiver_(receiver) {}

  void put(std::size_t index, WorkResult&& result) {
    pending_.emplace(index, std::move(result));
    while (!pending_.empty() && pending_.begin()->first == next_) {
      receiver_(next_, std::move(pending_.begin()->second));
      pending_.erase(pending_.begin());
      ++next_;
    }
  }

  /// Forwards the results that wait for a work item that will not complete.
  void flush() {
    for (auto& [index, result] : pending_) receiver_(index, std::move(result));
    pending_.clear();
  }

 private:
  const Receiver& receiver_;
  std::map<std::size_t, WorkResult> pending_;
  std::size_t next_ = 0;
};

class Pool {
 public:
  Pool(std::size_t count, const PoolOptions& options, const WorkItem& item, OrderedResults& results)
      : count_(count), options_(options), item_(item), results_(results) {
    const std::size_t workers = std::min<std::size_t>(std::max(1, options.workers), count);
    for (std::size_t i = 0; i < workers; ++i)
      workers_.push_back(std::make_unique<WorkerProcess>(options));
  }

  bool run(const std::function<bool()>& interrupted) {
    while (finished_ < count_) {
      if (interrupted && interrupted()) return false;
      assign_items();
      wait_for_answers();
      collect();
    }
    return true;
  }

 private:
  void assign_items() {
    for (auto& worker : workers_) {
      if (worker->busy() || next_ == count_) continue;
      if (worker->alive() && options_.fresh_process) worker->kill_and_reap();
      if (!worker->alive()) worker->start(item_);
      worker->assign(next_++);
    }
  }

  void wait_for_answers() const {
    std::vector<pollfd> sockets;
    for (const auto& worker : workers_)
      if (worker->busy()) sockets.push_back({worker->socket(), POLLIN, 0});
    constexpr int kPollMs = 20;  // maximum latency of time limits and interrupts
    poll(sockets.data(), sockets.size(), kPollMs);
  }

  void collect() {
    for (auto& worker : workers_) {
      if (!worker->busy()) continue;
      const std::size_t index = worker->item();
      if (auto result = worker->receive()) finish(index, std::move(*result));
    }
  }

  void finish(std::size_t index, WorkResult&& result) {
    ++finished_;
    results_.put(index, std::move(result));
  }

  std::size_t count_;
  PoolOptions options_;
  const WorkItem& item_;
  OrderedResults& results_;
  std::vector<std::unique_ptr<WorkerProcess>> workers_;
  std::size_t next_ = 0, finished_ = 0;
};

bool run_here(std::size_t count, const PoolOptions& options, const WorkItem& item,
              const std::function<void(std::size_t, WorkResult&&)>& on_result,
              const std::function<bool()>& interrupted) {
  SharedTaskLog log(options.log_size);
  for (std::size_t i = 0; i < count; ++i) {
    if (interrupted && interrupted()) return false;
    log.clear();
    WorkResult result;
    try {
      result.payload = item(i, log);
    } catch (const std::exception& error) {
      result.status = WorkResult::Status::Threw;
      result.detail = reason_of(error);
    }
    on_result(i, std::move(result));
  }
  return true;
}

}  // namespace

bool run_in_workers(std::size_t count, const PoolOptions& options, const WorkItem& item,
                    const std::function<void(std::size_t, WorkResult&&)>& on_result,
                    const std::function<bool()>& interrupted) {
  if (options.in_process) return run_here(count, options, item, on_result, interrupted);
  OrderedResults results(on_result);
  const bool complete = Pool(count, options, item, results).run(interrupted);
  results.flush();
  return complete;
}

}  // namespace slalom
