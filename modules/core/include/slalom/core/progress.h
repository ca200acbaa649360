// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/wall_clock.h>

#include <cstddef>
#include <memory>
#include <string>

namespace slalom {

/// Receives the progress of a long job. Implementations must be cheap to call.
class Progress {
 public:
  virtual ~Progress() = default;
  virtual void start(const std::string& what, std::size_t total) = 0;
  /// `done` of `total` so far. If that is more than one at the first call, it was done earlier and
  /// tells nothing about the speed.
  virtual void advance(std::size_t done) = 0;
  virtual void finish() = 0;  ///< the work ended, with all done or before
};

/// No output.
std::unique_ptr<Progress> make_silent_progress();

/// A progress bar on standard error if it is a terminal; otherwise, for log files, a line every 10
/// s of `clock` with the count and the estimated time left, so none for short jobs. No output if
/// `quiet`.
std::unique_ptr<Progress> make_terminal_progress(bool quiet, WallClock clock = steady_seconds);

}  // namespace slalom
