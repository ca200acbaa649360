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

}  // namespace
}  // namespace slalom
