// SPDX-License-Identifier: BSD-3-Clause
#include "finish_jobs.h"

#include <slalom/studio/jobs.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace slalom {
namespace {

/// Runs until it is canceled.
Jobs::Delivery run_forever(Progress& progress) {
  progress.start("counting", 1000000);
  for (std::size_t i = 0;; ++i) {
    progress.advance(i);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(Jobs, RunInOneThreadAndDeliverInAnother) {
  Jobs jobs;
  std::thread::id worked, delivered;
  jobs.start("a", "A",
             [&](Progress&) -> Jobs::Delivery {
               worked = std::this_thread::get_id();
               return [&] { delivered = std::this_thread::get_id(); };
             },
             {});
  finish_jobs(jobs);
  EXPECT_EQ(delivered, std::this_thread::get_id());
  EXPECT_NE(worked, delivered);
  EXPECT_NE(worked, std::thread::id());
}

TEST(Jobs, ReportWhyTheyFailed) {
  Jobs jobs;
  std::string reason;
  jobs.start(
      "a", "A", [](Progress&) -> Jobs::Delivery { throw std::runtime_error("disk full"); },
      [&](const std::string& message) { reason = message; });
  finish_jobs(jobs);
  EXPECT_EQ(reason, "disk full");
}

TEST(Jobs, DeliverNothingWhenCanceled) {
  Jobs jobs;
  bool failed = false;
  jobs.start("a", "A", run_forever, [&](const std::string&) { failed = true; });
  wait_until([&] { return !jobs.status().empty() && !jobs.status()[0].stage.empty(); });
  EXPECT_EQ(jobs.status()[0].stage, "counting");
  EXPECT_EQ(jobs.status()[0].total, 1000000U);
  jobs.cancel("a");
  EXPECT_TRUE(jobs.status().empty());
  finish_jobs(jobs);
  EXPECT_FALSE(failed);
}

TEST(Jobs, ReplaceOlderJobsOfTheSameKey) {
  Jobs jobs;
  std::string delivered;
  const auto delivering = [&](const std::string& text) {
    return [&delivered, text](Progress&) { return [&delivered, text] { delivered += text; }; };
  };
  jobs.start("a", "A", delivering("old"), {});
  wait_until([&] { return jobs.status().empty(); });
  jobs.start("a", "A", delivering("new"), {});  // the old one is finished, but not delivered
  jobs.start("b", "B", delivering("other"), {});
  finish_jobs(jobs);
  EXPECT_TRUE(delivered == "newother" || delivered == "othernew") << delivered;
}

TEST(Jobs, ArePendingUntilTheyAreDeliveredOrCanceled) {
  Jobs jobs;
  EXPECT_FALSE(jobs.is_pending("a"));
  bool delivered = false;
  const auto start = [&] {
    jobs.start("a", "A", [&](Progress&) { return [&] { delivered = true; }; }, {});
    wait_until([&] { return jobs.status().empty(); });  // the work is done
    EXPECT_TRUE(jobs.is_pending("a"));
  };
  start();
  EXPECT_FALSE(jobs.is_pending("b"));
  finish_jobs(jobs);
  EXPECT_TRUE(delivered);
  EXPECT_FALSE(jobs.is_pending("a"));
  start();
  jobs.cancel("a");
  EXPECT_FALSE(jobs.is_pending("a"));
}

TEST(Jobs, AreCanceledByTheDestructor) {
  std::atomic<bool> delivered = false;
  {
    Jobs jobs({}, 1);
    jobs.start("a", "A", run_forever, {});
    jobs.start("b", "B", [&](Progress&) { return [&] { delivered = true; }; }, {});
  }
  EXPECT_FALSE(delivered);
}

}  // namespace
}  // namespace slalom
