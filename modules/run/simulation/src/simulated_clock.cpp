// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_clock.h"

#include <cmath>

namespace slalom {
namespace {

using mrpt::Clock;

/// The latest time of all runs of this process; its initial value is the same in every process.
Clock::time_point& latest_time() {
  static Clock::time_point latest = Clock::fromDouble(1e9);
  return latest;
}

/// An integer number of ticks, so that time differences do not depend on the start time of the run.
Clock::duration to_ticks(double seconds) {
  return Clock::duration(static_cast<Clock::rep>(std::llround(seconds * 1e7)));
}

/// An integer second, so that times in floating point are rounded identically in each run.
Clock::time_point next_start() {
  return Clock::fromDouble(std::ceil(Clock::toDouble(latest_time())) + 2);
}

}  // namespace

SimulatedClock::SimulatedClock() : start_(next_start()), now_(start_) {
  set(0);
  Clock::setActiveClock(Clock::Simulated);
}

Clock::time_point SimulatedClock::at(double seconds) const {
  return start_ + to_ticks(seconds);
}

void SimulatedClock::set(double seconds) {
  now_ = at(seconds);
  latest_time() = now_;
  Clock::setSimulatedTime(now_);
}

}  // namespace slalom
