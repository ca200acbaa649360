// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/workers/worker_pool.h>

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

namespace slalom {
namespace {

/// With work items that sleep instead of computing. The parent reads the clock once for each work
/// item that it assigns, and once for each worker that it looks at and that has not answered: at
/// those that sent something, and at all of them every 20 ms. One that looked at all workers for
/// each answer would read it 64 times as often.
TEST(WorkerScaling, TheParentLooksAtTheWorkersThatHaveSentSomething) {
  constexpr std::size_t kItems = 1500;
  constexpr int kWorkers = 64;
  std::size_t looks = 0, answers = 0;
  PoolOptions options;
  options.schedule.workers = kWorkers;
  options.schedule.ordered = false;
  options.hooks.clock = [&] {
    ++looks;
    return steady_seconds();
  };
  const double begin = steady_seconds();
  run_in_workers(
      kItems, options,
      [&](std::size_t i, SharedTaskLog&) {
        std::this_thread::sleep_for(std::chrono::microseconds(20'000 + 500 * (i % kWorkers)));
        return std::string(15'000, 'x');  // as long as a run
      },
      [&](std::size_t, WorkResult&& result) {
        if (result.payload.size() == 15'000) ++answers;
      },
      nullptr);
  EXPECT_EQ(answers, kItems);
  const double intervals = (steady_seconds() - begin) / 0.02 + 1;
  EXPECT_LT(static_cast<double>(looks), 4 * kItems + kWorkers * intervals);
}

}  // namespace
}  // namespace slalom
