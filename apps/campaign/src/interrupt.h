#pragma once

#include <csignal>

namespace slalom {

/// While it lives, SIGINT and SIGTERM only raise a flag, so that a campaign can end with its state
/// kept.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  static bool raised();

 private:
  struct sigaction old_int_ {};
  struct sigaction old_term_ {};
};

}  // namespace slalom
