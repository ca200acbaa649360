// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/core/Clock.h>

namespace slalom {

/// The simulated time of one run. mrpt::Clock is process-wide and MRPT's navigators fail when it is
/// set back, so every run of a process begins at least two seconds after the end of the previous
/// one.
class SimulatedClock {
 public:
  SimulatedClock();
  void set(double seconds);  ///< since the start of the run; must not decrease
  mrpt::Clock::time_point now() const { return now_; }
  mrpt::Clock::time_point at(double seconds) const;  ///< since the start of the run

 private:
  mrpt::Clock::time_point start_, now_;
};

}  // namespace slalom
