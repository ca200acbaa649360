// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/progress.h>

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace slalom {

/// Thrown by the Progress of a canceled job; ends its work.
class JobCanceled {};

/// State of a job, for display.
struct JobStatus {
  std::string key;    ///< a new job replaces an older one with the same key
  std::string title;  ///< for the user
  std::string stage;  ///< as reported by Progress; empty before the first report
  std::size_t done = 0, total = 0;
  bool visible = true;  ///< shown in the status bar with a cancel button
};

/// Runs jobs in background threads, so that the window never blocks. A job works on its own data;
/// the function that it returns is called by poll() in the thread of the window, and so is `failed`
/// with the message of an exception.
class Jobs {
 public:
  using Delivery = std::function<void()>;  ///< called by poll()
  /// Runs in a worker thread; `progress` throws JobCanceled when the job was canceled.
  using Work = std::function<Delivery(Progress& progress)>;
  using Failed = std::function<void(const std::string& message)>;

  /// `wake` is called from worker threads when there is something to poll or to show.
  explicit Jobs(std::function<void()> wake = {}, int threads = 3);
  ~Jobs();  ///< cancels all jobs and joins the threads; delivers nothing
  Jobs(const Jobs&) = delete;
  Jobs& operator=(const Jobs&) = delete;

  /// Cancels a waiting or running job of the same key, which then delivers nothing.
  void start(const std::string& key, const std::string& title, Work work, Failed failed,
             bool visible = true);
  void cancel(const std::string& key);  ///< `failed` is not called
  /// Delivers the finished jobs and returns their number.
  std::size_t poll();
  bool idle() const;                              ///< no job is waiting, running or undelivered
  bool is_pending(const std::string& key) const;  ///< waiting, running or undelivered
  std::vector<JobStatus> status() const;          ///< of running and waiting jobs, oldest first

 private:
  struct Job;
  class JobProgress;
  void run_worker();
  std::shared_ptr<Job> next_job();
  void end(const std::shared_ptr<Job>& job, Delivery delivery);

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::function<void()> wake_;
  bool closing_ = false;
  std::deque<std::shared_ptr<Job>> waiting_;
  std::vector<std::shared_ptr<Job>> running_;
  std::deque<std::pair<std::shared_ptr<Job>, Delivery>> finished_;
  std::vector<std::thread> threads_;
};

}  // namespace slalom
