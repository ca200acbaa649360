#pragma once

#include <cstddef>
#include <functional>
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

}  // namespace slalom
