#include "worker_process.h"

#include <slalom/campaign/worker_pool.h>

#include <algorithm>
#include <map>
#include <memory>
#include <poll.h>
#include <vector>

namespace slalom {
namespace {

/// Gives results on in the order of their indexes.
class InOrder {
 public:
  using Receiver = std::function<void(std::size_t, TaskResult&&)>;
  explicit InOrder(const Receiver& receiver) : receiver_(receiver) {}

  void put(std::size_t index, TaskResult&& result) {
    waiting_.emplace(index, std::move(result));
    while (!waiting_.empty() && waiting_.begin()->first == next_) {
      receiver_(next_, std::move(waiting_.begin()->second));
      waiting_.erase(waiting_.begin());
      ++next_;
    }
  }

  /// Hands over what waits for a task that will never end.
  void flush() {
    for (auto& [index, result] : waiting_) receiver_(index, std::move(result));
    waiting_.clear();
  }

 private:
  const Receiver& receiver_;
  std::map<std::size_t, TaskResult> waiting_;
  std::size_t next_ = 0;
};

class Pool {
 public:
  Pool(std::size_t count, const PoolOptions& options, const WorkerTask& task, InOrder& results)
      : count_(count), options_(options), task_(task), results_(results) {
    const std::size_t workers = std::min<std::size_t>(std::max(1, options.workers), count);
    for (std::size_t i = 0; i < workers; ++i)
      workers_.push_back(std::make_unique<WorkerProcess>(options));
  }

  bool run(const std::function<bool()>& interrupted) {
    while (finished_ < count_) {
      if (interrupted && interrupted()) return false;
      assign_tasks();
      wait_for_answers();
      collect();
    }
    return true;
  }

 private:
  void assign_tasks() {
    for (auto& worker : workers_) {
      if (worker->busy() || next_ == count_) continue;
      if (worker->alive() && options_.fresh_process) worker->kill_and_reap();
      if (!worker->alive()) worker->start(task_);
      worker->assign(next_++);
    }
  }

  void wait_for_answers() const {
    std::vector<pollfd> sockets;
    for (const auto& worker : workers_)
      if (worker->busy()) sockets.push_back({worker->socket(), POLLIN, 0});
    constexpr int kPollMs = 20;  // bounds how late a time limit or an interrupt is seen
    poll(sockets.data(), sockets.size(), kPollMs);
  }

  void collect() {
    for (auto& worker : workers_) {
      if (!worker->busy()) continue;
      const std::size_t index = worker->task();
      if (auto result = worker->receive()) finish(index, std::move(*result));
    }
  }

  void finish(std::size_t index, TaskResult&& result) {
    ++finished_;
    results_.put(index, std::move(result));
  }

  std::size_t count_;
  PoolOptions options_;
  const WorkerTask& task_;
  InOrder& results_;
  std::vector<std::unique_ptr<WorkerProcess>> workers_;
  std::size_t next_ = 0, finished_ = 0;
};

}  // namespace

bool run_in_workers(std::size_t count, const PoolOptions& options, const WorkerTask& task,
                    const std::function<void(std::size_t, TaskResult&&)>& on_result,
                    const std::function<bool()>& interrupted) {
  InOrder results(on_result);
  const bool complete = Pool(count, options, task, results).run(interrupted);
  results.flush();
  return complete;
}

}  // namespace slalom
