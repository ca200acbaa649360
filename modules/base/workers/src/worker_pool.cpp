// SPDX-License-Identifier: BSD-3-Clause
#include "shared_inputs.h"
#include "worker_process.h"

#include <slalom/core/error.h>
#include <slalom/workers/process_state.h>
#include <slalom/workers/worker_pool.h>

#include <algorithm>
#include <map>
#include <memory>
#include <poll.h>
#include <set>
#include <vector>

namespace slalom {
namespace {

/// Forwards results as they come, or in the order of their indexes: those after a work item that
/// does not complete are never forwarded, so that the receiver sees no hole.
class ResultForwarder {
 public:
  using Receiver = std::function<void(std::size_t, WorkResult&&)>;
  ResultForwarder(const Receiver& receiver, bool ordered)
      : receiver_(receiver), ordered_(ordered) {}

  void put(std::size_t index, WorkResult&& result) {
    if (!ordered_) return receiver_(index, std::move(result));
    pending_.emplace(index, std::move(result));
    while (!pending_.empty() && pending_.begin()->first == next_) {
      receiver_(next_, std::move(pending_.begin()->second));
      pending_.erase(pending_.begin());
      ++next_;
    }
  }

 private:
  const Receiver& receiver_;
  bool ordered_;
  std::map<std::size_t, WorkResult> pending_;
  std::size_t next_ = 0;
};

class Pool {
 public:
  Pool(std::size_t count, const PoolOptions& options, const WorkItem& item,
       ResultForwarder& results)
      : count_(count),
        max_busy_(static_cast<std::size_t>(std::max(1, options.schedule.workers))),
        options_(options),
        item_(item),
        results_(results),
        inputs_(count, options),
        keeper_(options.keep_stderr,
                [this, receive_file = inputs_.receiver()](const WorkerStart& start) {
                  serve_confined(start, item_, options_, receive_file);
                }) {}

  bool run(const std::function<bool()>& interrupted) {
    while (finished_ < count_) {
      if (interrupted && interrupted()) return false;
      assign_items();
      collect(wait_for_answers());
    }
    end_workers();
    return true;
  }

 private:
  using Worker = std::unique_ptr<WorkerProcess>;

  void assign_items() {
    if (is_repeating()) return;
    if (!retry_queue_.empty()) {
      // Alone, so that whatever another work item does to it or takes from it is not there.
      if (busy() > 0) return;
      const std::size_t index = retry_queue_.back();
      retry_queue_.pop_back();
      memory_kills_ = options_.hooks.memory_kills();
      return assign(index, true);
    }
    while (busy() < max_busy_ && !restarted_.empty()) {
      const std::size_t index = restarted_.back();
      restarted_.pop_back();
      assign(index, true);
    }
    while (busy() < max_busy_ && next_ < count_) {
      if (!inputs_.is_awaited(next_))
        assign(next_++, options_.schedule.process_per_item);
      else if (!inputs_.make_next())
        return;
    }
    assign_ahead();
  }

  /// Assigns work items to workers that are not done yet: they do not wait for this process, which
  /// may wait for a core itself. Not the last ones, for which any worker may be idle first.
  void assign_ahead() {
    if (options_.schedule.process_per_item) return;
    while (count_ - next_ > 2 * max_busy_ && !inputs_.is_awaited(next_)) {
      const std::size_t group = group_of(next_);
      const auto found = std::find_if(workers_.begin(), workers_.end(), [&](const Worker& worker) {
        return worker->wants_next() && worker->group() == group;
      });
      if (found == workers_.end()) return;
      (*found)->assign_next(next_, inputs_.descriptor_for(next_));
      ++next_;
    }
    if (inputs_.busy() == 0) inputs_.make_next();
  }

  std::size_t group_of(std::size_t index) const {
    return options_.schedule.group ? options_.schedule.group(index) : 0;
  }

  std::size_t busy() const { return count(&WorkerProcess::busy) + inputs_.busy(); }

  /// Whether a work item is executed once more.
  bool is_repeating() const {
    return std::any_of(workers_.begin(), workers_.end(), [this](const Worker& worker) {
      return worker->busy() && killed_once_.count(worker->last_item()) > 0;
    });
  }

  void assign(std::size_t index, bool fresh) {
    worker_for(group_of(index), fresh).assign(index, inputs_.descriptor_for(index));
  }

  std::size_t count(bool (WorkerProcess::*has)() const) const {
    return static_cast<std::size_t>(
        std::count_if(workers_.begin(), workers_.end(),
                      [&](const Worker& worker) { return ((*worker).*has)(); }));
  }

  /// An idle process of the group, or a new one.
  WorkerProcess& worker_for(std::size_t group, bool fresh) {
    for (Worker& worker : workers_) {
      if (!worker->idle() || worker->group() != group) continue;
      if (!fresh && worker->is_sound()) return *worker;
      worker->begin_end();
      if (fresh) break;
    }
    if (count(&WorkerProcess::idle) >= options_.schedule.groups + max_busy_)
      end_least_recently_used();
    const auto dead = std::find_if(workers_.begin(), workers_.end(), [](const Worker& worker) {
      return !worker->alive() && !worker->busy();
    });
    WorkerProcess& worker = dead == workers_.end() ? *workers_.emplace_back(make_worker()) : **dead;
    worker.start(group);
    return worker;
  }

  Worker make_worker() {
    if (options_.schedule.trusted)
      return std::make_unique<WorkerProcess>(options_, item_, inputs_.receiver());
    return std::make_unique<WorkerProcess>(options_, keeper_);
  }

  void end_least_recently_used() {
    const auto rank = [](const Worker& worker) {
      return std::make_pair(!worker->idle(), worker->last_item());
    };
    WorkerProcess& worker =
        **std::min_element(workers_.begin(), workers_.end(),
                           [&](const Worker& a, const Worker& b) { return rank(a) < rank(b); });
    worker.request_end();
    worker.await_end();
  }

  void end_workers() {
    for (Worker& worker : workers_) worker->request_end();
    for (Worker& worker : workers_) worker->await_end();
  }

  /// Returns the busy workers that have sent something or ended; all of them every kPollMs, for
  /// their time limits and what they print.
  std::vector<WorkerProcess*> wait_for_answers() {
    constexpr int kPollMs = 20;  // maximum latency of time limits and interrupts
    std::vector<pollfd> events;
    std::vector<std::size_t> ends;  // of the events of each worker
    for (const Worker& worker : workers_) {
      worker->add_events(events);
      ends.push_back(events.size());
    }
    inputs_.add_events(events);
    if (poll(events.data(), events.size(), kPollMs) == 0) keeper_.kill_if_stopped();
    const double now = steady_seconds();
    const bool all = now - looked_at_all_ >= kPollMs * 1e-3;
    if (all) looked_at_all_ = now;
    std::vector<WorkerProcess*> ready;
    for (std::size_t i = 0, event = 0; i < ends.size(); ++i) {
      bool is_ready = all && workers_[i]->busy();
      if (is_ready) workers_[i]->read_output();
      for (; event < ends[i]; ++event) is_ready = is_ready || events[event].revents != 0;
      if (is_ready) ready.push_back(workers_[i].get());
    }
    return ready;
  }

  void collect(const std::vector<WorkerProcess*>& ready) {
    const std::string lowered = limits_.restore_lowered();
    if (!lowered.empty())
      throw job_error("workers", "a method has lowered " + lowered +
                                     " of this program, which cannot raise it again; "
                                     "[limits] sandbox = true prevents that");
    inputs_.collect();
    for (WorkerProcess* worker : ready) worker->read();
    // Asked once, after all answers that were read.
    const bool keeper_is_alive =
        !ready.empty() && (options_.schedule.trusted || keeper_.is_alive());
    for (WorkerProcess* worker : ready) {
      receive(*worker, keeper_is_alive);
      while (worker->has_answer()) receive(*worker, keeper_is_alive);
    }
  }

  void receive(WorkerProcess& worker, bool keeper_is_alive) {
    const std::size_t index = worker.last_item();
    auto result = worker.receive(keeper_is_alive);
    if (!result) return;
    if (const auto unstarted = worker.take_unstarted()) restarted_.push_back(*unstarted);
    if (result->status == WorkResult::Status::Crashed && worker.died_between_items())
      restarted_.push_back(index);  // in a new process, whose death is the item's own
    else
      finish(index, std::move(*result));
  }

  void finish(std::size_t index, WorkResult&& result) {
    if (result.status == WorkResult::Status::Killed) {
      if (killed_once_.insert(index).second) return retry_queue_.push_back(index);
      result.detail += " twice, the second time alone";
      if (options_.hooks.memory_kills() == memory_kills_)
        result.status = WorkResult::Status::Crashed;
      else
        result.detail += "; the system was out of memory";
    }
    ++finished_;
    inputs_.release(index);
    assign_items();  // the worker does not wait until the result is stored
    results_.put(index, std::move(result));
  }

  std::size_t count_, max_busy_;
  PoolOptions options_;
  const WorkItem& item_;
  ResultForwarder& results_;
  SharedInputPool inputs_;
  ResourceLimits limits_;
  WorkerKeeper keeper_;
  std::vector<Worker> workers_;
  double looked_at_all_ = 0;  ///< s, when all busy workers were looked at
  std::size_t next_ = 0, finished_ = 0;
  std::set<std::size_t> killed_once_;     ///< work items whose process was killed
  std::vector<std::size_t> retry_queue_;  ///< those that are to be executed once more, alone
  std::uint64_t memory_kills_ = 0;        ///< when the last of these was started
  std::vector<std::size_t> restarted_;    ///< those that are to be executed in a new process
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
      if (options.hooks.is_valid && !options.hooks.is_valid(i, result.payload))
        result = {WorkResult::Status::Crashed, "", kInvalidPayload, log.contents()};
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
  if (options.schedule.in_process) return run_here(count, options, item, on_result, interrupted);
  ResultForwarder results(on_result, options.schedule.ordered);
  return Pool(count, options, item, results).run(interrupted);
}

}  // namespace slalom
