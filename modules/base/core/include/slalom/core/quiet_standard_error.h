// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>

namespace slalom {

/// Discards what is written to standard error while it lives: around calls of libraries that return
/// errors and print them, too, without a way to keep them from it. Output of other threads is lost
/// meanwhile, so the calls must be short. A second one waits for the first.
class QuietStandardError {
 public:
  QuietStandardError();
  ~QuietStandardError();
  QuietStandardError(const QuietStandardError&) = delete;
  QuietStandardError& operator=(const QuietStandardError&) = delete;

 private:
  std::unique_lock<std::mutex> lock_;
  int saved_ = -1;
};

}  // namespace slalom
