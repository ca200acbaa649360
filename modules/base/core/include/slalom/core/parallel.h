// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace slalom {

/// Calls work(0) ... work(count - 1), each once, on up to `jobs` threads (at least one), and
/// returns when all are done. `work` must be thread-safe. If calls throw, those already started are
/// finished and the exception of the smallest index is rethrown, so that the result does not depend
/// on the number of threads.
void parallel_for(std::size_t count, int jobs, const std::function<void(std::size_t)>& work);

/// Returns make(0) ... make(count - 1) in that order, computed on up to `jobs` threads.
template <typename Make>
auto parallel_map(std::size_t count, int jobs, Make make)
    -> std::vector<decltype(make(std::size_t{0}))> {
  std::vector<std::optional<decltype(make(std::size_t{0}))>> made(count);
  parallel_for(count, jobs, [&](std::size_t i) { made[i].emplace(make(i)); });
  std::vector<decltype(make(std::size_t{0}))> results;
  results.reserve(count);
  for (auto& one : made) results.push_back(std::move(*one));
  return results;
}

/// Lets calls with the numbers 0, 1, ... pass one after the other in this order.
class Turns {
 public:
  /// Waits until all calls before have ended, then calls `act`. False if one of them failed; then
  /// `act` is not called.
  bool take(std::size_t number, const std::function<void()>& act);
  /// No call passes after those before `number`.
  void fail(std::size_t number);

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t next_ = 0;
  bool failed_ = false;

  void end(bool failed);
};

/// Calls use(make(0)), use(make(1)), ... in this order and one at a time, with make() on up to
/// `jobs` threads; at most `jobs` results exist at the same time. Exceptions as of parallel_for().
template <typename Make, typename Use>
void parallel_in_order(std::size_t count, int jobs, Make make, Use use) {
  Turns turns;
  parallel_for(count, jobs, [&](std::size_t i) {
    std::optional<decltype(make(i))> made;
    try {
      made.emplace(make(i));
    } catch (...) {
      turns.fail(i);
      throw;
    }
    turns.take(i, [&] { use(std::move(*made)); });
  });
}

}  // namespace slalom
