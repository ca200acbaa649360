// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/progress.h>

#include <array>
#include <csignal>
#include <memory>

namespace slalom {

/// During its lifetime, SIGINT, SIGTERM and SIGHUP only set a flag, so that a campaign can stop and
/// keep its state. In the main thread; an inner guard keeps the flag of the outer one.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  static bool raised();

 private:
  static constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, kSignals.size()> old_ = {};
};

/// make_terminal_progress() for jobs that the same command continues. During its lifetime, SIGINT,
/// SIGTERM and SIGHUP make its next advance() throw Interrupted, so that transactions and locks are
/// ended.
std::unique_ptr<Progress> make_interruptible_progress(bool quiet);

}  // namespace slalom
