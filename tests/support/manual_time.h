// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/wall_clock.h>

#include <atomic>
#include <new>
#include <sys/mman.h>
#include <unistd.h>

namespace slalom {

/// A clock that advances only on request of a work item, in any process. Limits are therefore never
/// exceeded because the machine is slow.
class ManualTime {
 public:
  ManualTime()
      : shared_(new (mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE,
                          MAP_SHARED | MAP_ANONYMOUS, -1, 0)) Shared()) {}
  ~ManualTime() { munmap(shared_, sizeof(Shared)); }
  ManualTime(const ManualTime&) = delete;
  ManualTime& operator=(const ManualTime&) = delete;

  WallClock clock() const {
    return [shared = shared_] {
      ++shared->readings;
      return shared->seconds.load();
    };
  }
  void advance(double seconds) {
    double now = shared_->seconds;
    while (!shared_->seconds.compare_exchange_weak(now, now + seconds)) continue;
  }

  /// The same, but waits until the pool has checked the limits before and after: a work item that
  /// exceeds one is killed before this function returns.
  void advance_observed(double seconds) {
    wait_for_reading();
    advance(seconds);
    wait_for_reading();
  }

 private:
  /// Waits for a check of the limits that starts after this call, and for its end.
  void wait_for_reading() const {
    const unsigned before = shared_->readings;
    while (shared_->readings - before < 2) usleep(500);
  }

  struct Shared {
    std::atomic<double> seconds = 0;
    std::atomic<unsigned> readings = 0;
  };
  Shared* shared_;
};

}  // namespace slalom
