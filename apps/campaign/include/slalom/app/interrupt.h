#pragma once

#include <csignal>

namespace slalom {

/// During its lifetime, SIGINT and SIGTERM only set a flag, so that a campaign can stop and keep
/// its state.
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
