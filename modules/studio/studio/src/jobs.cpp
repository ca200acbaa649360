// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/studio/jobs.h>

#include <algorithm>
#include <atomic>

namespace slalom {

struct Jobs::Job {
  JobStatus status;  ///< changed under the mutex
  Work work;
  Failed failed;
  std::atomic<bool> canceled = false;
};

/// Updates the status of a job; throws when the job was canceled.
class Jobs::JobProgress : public Progress {
 public:
  JobProgress(Jobs& jobs, Job& job) : jobs_(jobs), job_(job) {}
  void start(const std::string& what, std::size_t total) override {
    update_status([&](JobStatus& status) {
      status.stage = what;
      status.done = 0;
      status.total = total;
    });
  }
  void advance(std::size_t done) override {
    update_status([&](JobStatus& status) { status.done = done; });
  }
  void finish() override {
    update_status([](JobStatus& status) { status.done = status.total; });
  }

 private:
  template <typename Change>
  void update_status(Change change) {
    if (job_.canceled) throw JobCanceled();
    {
      const std::lock_guard<std::mutex> lock(jobs_.mutex_);
      change(job_.status);
    }
    if (jobs_.wake_) jobs_.wake_();
  }

  Jobs& jobs_;
  Job& job_;
};

Jobs::Jobs(std::function<void()> wake, int threads) : wake_(std::move(wake)) {
  for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { run_worker(); });
}

Jobs::~Jobs() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    closing_ = true;
    waiting_.clear();
    for (const auto& job : running_) job->canceled = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Jobs::start(const std::string& key, const std::string& title, Work work, Failed failed,
                 bool visible) {
  auto job = std::make_shared<Job>();
  job->status.key = key;
  job->status.title = title;
  job->status.visible = visible;
  job->work = std::move(work);
  job->failed = std::move(failed);
  cancel(key);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_.push_back(std::move(job));
  }
  changed_.notify_one();
}

void Jobs::cancel(const std::string& key) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto has_key = [&](const std::shared_ptr<Job>& job) { return job->status.key == key; };
  waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(), has_key), waiting_.end());
  for (const auto& job : running_)
    if (has_key(job)) job->canceled = true;
  for (auto& [job, delivery] : finished_)
    if (has_key(job)) job->canceled = true;
}

std::size_t Jobs::poll() {
  std::size_t count = 0;
  while (true) {
    std::pair<std::shared_ptr<Job>, Delivery> next;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (finished_.empty()) return count;
      next = std::move(finished_.front());
      finished_.pop_front();
    }
    ++count;
    if (!next.first->canceled && next.second) next.second();
  }
}

bool Jobs::idle() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return waiting_.empty() && running_.empty() && finished_.empty();
}

bool Jobs::is_pending(const std::string& key) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto has_key = [&](const std::shared_ptr<Job>& job) {
    return job->status.key == key && !job->canceled;
  };
  return std::any_of(waiting_.begin(), waiting_.end(), has_key) ||
         std::any_of(running_.begin(), running_.end(), has_key) ||
         std::any_of(finished_.begin(), finished_.end(),
                     [&](const auto& finished) { return has_key(finished.first); });
}

std::vector<JobStatus> Jobs::status() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<JobStatus> all;
  for (const auto& job : running_)
    if (!job->canceled) all.push_back(job->status);
  for (const auto& job : waiting_) all.push_back(job->status);
  return all;
}

std::shared_ptr<Jobs::Job> Jobs::next_job() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return closing_ || !waiting_.empty(); });
  if (closing_) return nullptr;
  auto job = waiting_.front();
  waiting_.pop_front();
  running_.push_back(job);
  return job;
}

void Jobs::run_worker() {
  while (const auto job = next_job()) {
    Delivery delivery;
    try {
      JobProgress progress(*this, *job);
      delivery = job->work(progress);
    } catch (const JobCanceled&) {
      job->canceled = true;
    } catch (const std::exception& error) {
      delivery = [failed = job->failed, message = reason_of(error)] {
        if (failed) failed(message);
      };
    }
    end(job, std::move(delivery));
  }
}

void Jobs::end(const std::shared_ptr<Job>& job, Delivery delivery) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    running_.erase(std::find(running_.begin(), running_.end(), job));
    job->work = nullptr;
    if (!closing_) finished_.emplace_back(job, std::move(delivery));
  }
  if (wake_) wake_();
}

}  // namespace slalom
