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

/// Thrown out of a job's Progress once the job was cancelled; ends the work.
class JobCancelled {};

/// How far a job is, for a window to show.
struct JobStatus {
  std::string key;    ///< jobs of one key take each other's place
  std::string title;  ///< what the user asked for
  std::string stage;  ///< as Progress says; empty before
  std::size_t done = 0, total = 0;
  bool visible = true;  ///< worth a line and a cancel button
};

/// Work on threads beside the window's, which never waits. A job works on values of its own; what
/// it returns is run by poll(), on the window's thread. Whatever it throws goes to `failed` there.
class Jobs {
 public:
  using Delivery = std::function<void()>;  ///< run by poll()
  /// Runs on a worker; may stop early through `progress` when cancelled.
  using Work = std::function<Delivery(Progress& progress)>;
  using Failed = std::function<void(const std::string& message)>;

  /// `wake` is called from workers when there is something to poll or to show.
  explicit Jobs(std::function<void()> wake = {}, int threads = 3);
  ~Jobs();  ///< cancels all and waits for the workers; nothing is delivered any more
  Jobs(const Jobs&) = delete;
  Jobs& operator=(const Jobs&) = delete;

  /// A job of the same key that waits or runs is cancelled and delivers nothing.
  void start(const std::string& key, const std::string& title, Work work, Failed failed,
             bool visible = true);
  void cancel(const std::string& key);  ///< `failed` is not called
  /// Delivers what has ended since; returns how many did.
  std::size_t poll();
  bool idle() const;  ///< nothing waits, runs or is to be delivered
  bool is_pending(const std::string& key) const;
  std::vector<JobStatus> status() const;  ///< of those that wait or run, the oldest first

 private:
  struct Job;
  class JobProgress;
  void work_on();
  std::shared_ptr<Job> next_job();
  void end(const std::shared_ptr<Job>& job, Delivery delivery);

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::function<void()> wake_;
  bool closing_ = false;
  std::deque<std::shared_ptr<Job>> waiting_;
  std::vector<std::shared_ptr<Job>> running_;
  std::deque<std::pair<std::shared_ptr<Job>, Delivery>> ended_;
  std::vector<std::thread> threads_;
};

}  // namespace slalom
