// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/parallel.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>

namespace slalom {
namespace {

/// Dispatches indexes in order and stores the failure of the smallest index. No call starts after a
/// failure; all calls with smaller indexes have started by then, so the result is deterministic.
class WorkQueue {
 public:
  WorkQueue(std::size_t count, const std::function<void(std::size_t)>& call)
      : count_(count), call_(call) {}

  void run() {
    while (!failed_) {
      const std::size_t i = next_++;
      if (i >= count_) return;
      try {
        call_(i);
      } catch (...) {
        store(i, std::current_exception());
      }
    }
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void store(std::size_t i, std::exception_ptr failure) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (i < failed_at_) {
      failed_at_ = i;
      failure_ = std::move(failure);
    }
    failed_ = true;
  }

  std::size_t count_;
  const std::function<void(std::size_t)>& call_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> failed_{false};
  std::mutex mutex_;
  std::size_t failed_at_ = std::numeric_limits<std::size_t>::max();
  std::exception_ptr failure_;
};

}  // namespace

void parallel_for(std::size_t count, int jobs, const std::function<void(std::size_t)>& work) {
  WorkQueue shared(count, work);
  const std::size_t helpers =
      std::min(count, static_cast<std::size_t>(std::max(jobs, 1))) - (count > 0 ? 1 : 0);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < helpers; ++i) threads.emplace_back([&] { shared.run(); });
  shared.run();
  for (std::thread& thread : threads) thread.join();
  shared.rethrow();
}

bool Turns::take(std::size_t number, const std::function<void()>& act) {
  {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [&] { return next_ == number; });
    if (failed_) {
      lock.unlock();
      end(true);
      return false;
    }
  }
  try {
    act();
  } catch (...) {
    end(true);
    throw;
  }
  end(false);
  return true;
}

void Turns::fail(std::size_t number) {
  {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [&] { return next_ == number; });
  }
  end(true);
}

void Turns::end(bool failed) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    failed_ = failed_ || failed;
    ++next_;
  }
  changed_.notify_all();
}

}  // namespace slalom
