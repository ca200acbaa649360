// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/wall_clock.h>

#include <cstddef>
#include <functional>
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
  /// Text behind the counts on a terminal, such as "nd 80/200, gap 40/200". Called when they are
  /// drawn, until the end of this object.
  virtual void set_detail(const std::function<std::string()>&) {}
};

/// No output.
std::unique_ptr<Progress> make_silent_progress();

/// On standard error if it is a terminal: a progress bar of one line, cut to the terminal's width,
/// with the rate and the estimated time left after 1 s of `clock`. Otherwise, for log files: a line
/// every 10 s with the count and the estimated time left, so none for short jobs. No output if
/// `quiet`.
std::unique_ptr<Progress> make_terminal_progress(bool quiet, WallClock clock = steady_seconds);

}  // namespace slalom
