// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/parallel.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

namespace slalom {
namespace {

TEST(Parallel, ReturnsResultsInOrder) {
  for (const int jobs : {-1, 1, 2, 7}) {
    const auto squares = parallel_map(20, jobs, [](std::size_t i) {
      std::this_thread::sleep_for(std::chrono::microseconds(20 * (20 - i)));
      return static_cast<int>(i * i);
    });
    ASSERT_EQ(squares.size(), 20u);
    for (int i = 0; i < 20; ++i) EXPECT_EQ(squares[static_cast<std::size_t>(i)], i * i);
  }
}

TEST(Parallel, EachIndexIsCalledOnce) {
  std::vector<std::atomic<int>> calls(500);
  parallel_for(calls.size(), 4, [&](std::size_t i) { ++calls[i]; });
  for (const auto& count : calls) EXPECT_EQ(count, 1);
}

TEST(Parallel, WithoutWorkNothingIsCalled) {
  parallel_for(0, 4, [](std::size_t) { FAIL(); });
}

TEST(Parallel, RethrowsTheFailureOfTheSmallestIndex) {
  for (const int jobs : {1, 2, 5}) try {
      parallel_for(50, jobs, [](std::size_t i) {
        if (i == 3) std::this_thread::sleep_for(std::chrono::milliseconds(2));
        if (i >= 3 && i % 2 == 1) throw std::runtime_error(std::to_string(i));
      });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "3") << jobs;
    }
}

TEST(Parallel, ResultsAreUsedInOrder) {
  for (const int jobs : {1, 2, 5}) {
    std::vector<std::size_t> used;
    std::atomic<int> existing{0};
    const auto make = [&](std::size_t i) {
      EXPECT_LE(++existing, jobs);
      if (i % 3 == 0) std::this_thread::yield();
      return i;
    };
    parallel_in_order(100, jobs, make, [&](std::size_t i) {
      used.push_back(i);
      --existing;
    });
    ASSERT_EQ(used.size(), 100U);
    for (std::size_t i = 0; i < used.size(); ++i) EXPECT_EQ(used[i], i);
  }
}

TEST(Parallel, NothingIsUsedAfterAFailure) {
  for (const bool makes : {true, false})
    for (const int jobs : {1, 2, 5}) {
      std::vector<std::size_t> used;
      const auto fail_at_seven = [](std::size_t i, bool fails) {
        if (fails && i >= 7) throw std::runtime_error(std::to_string(i));
        return i;
      };
      try {
        parallel_in_order(
            50, jobs, [&](std::size_t i) { return fail_at_seven(i, makes); },
            [&](std::size_t i) { used.push_back(fail_at_seven(i, !makes)); });
        FAIL() << "nothing was thrown";
      } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "7");
      }
      EXPECT_EQ(used.size(), 7U);
    }
}

}  // namespace
}  // namespace slalom
