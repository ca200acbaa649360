#include <slalom/gui/jobs.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>

namespace slalom {
namespace {

void poll_until_idle(Jobs& jobs) {
  while (!jobs.idle()) {
    jobs.poll();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/// Goes on until it is cancelled.
Jobs::Delivery work_for_ever(Progress& progress) {
  progress.start("counting", 1000000);
  for (std::size_t i = 0;; ++i) {
    progress.advance(i);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(Jobs, WorkOnOneThreadAndDeliverOnAnother) {
  Jobs jobs;
  std::thread::id worked, delivered;
  jobs.start("a", "A",
             [&](Progress&) -> Jobs::Delivery {
               worked = std::this_thread::get_id();
               return [&] { delivered = std::this_thread::get_id(); };
             },
             {});
  poll_until_idle(jobs);
  EXPECT_EQ(delivered, std::this_thread::get_id());
  EXPECT_NE(worked, delivered);
  EXPECT_NE(worked, std::thread::id());
}

TEST(Jobs, TellWhyTheyFailed) {
  Jobs jobs;
  std::string why;
  jobs.start(
      "a", "A", [](Progress&) -> Jobs::Delivery { throw std::runtime_error("no paper"); },
      [&](const std::string& message) { why = message; });
  poll_until_idle(jobs);
  EXPECT_EQ(why, "no paper");
}

TEST(Jobs, ThatAreCancelledEndAndDeliverNothing) {
  Jobs jobs;
  bool failed = false;
  jobs.start("a", "A", work_for_ever, [&](const std::string&) { failed = true; });
  while (jobs.status().empty() || jobs.status()[0].stage.empty()) std::this_thread::yield();
  EXPECT_EQ(jobs.status()[0].stage, "counting");
  EXPECT_EQ(jobs.status()[0].total, 1000000U);
  jobs.cancel("a");
  EXPECT_TRUE(jobs.status().empty());
  poll_until_idle(jobs);
  EXPECT_FALSE(failed);
}

TEST(Jobs, OfOneKeyTakeEachOthersPlace) {
  Jobs jobs;
  std::string delivered;
  const auto saying = [&](const std::string& text) {
    return [&delivered, text](Progress&) { return [&delivered, text] { delivered += text; }; };
  };
  jobs.start("a", "A", saying("old"), {});
  while (!jobs.status().empty()) std::this_thread::yield();
  jobs.start("a", "A", saying("new"), {});  // the old one has ended, but was not delivered yet
  jobs.start("b", "B", saying("other"), {});
  poll_until_idle(jobs);
  EXPECT_TRUE(delivered == "newother" || delivered == "othernew") << delivered;
}

TEST(Jobs, EndWithTheirOwner) {
  std::atomic<bool> delivered = false;
  {
    Jobs jobs({}, 1);
    jobs.start("a", "A", work_for_ever, {});
    jobs.start("b", "B", [&](Progress&) { return [&] { delivered = true; }; }, {});
  }
  EXPECT_FALSE(delivered);
}

}  // namespace
}  // namespace slalom
