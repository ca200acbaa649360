#pragma once

#include "response_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slalom {

constexpr double kSameTime = 1e-6;  // s; timestamps are rounded to 2e-7
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// The velocity `duration` after v, with a constant target; the acceleration is at most `limit`.
inline double respond(double v, double target, double tau, double duration,
                      double limit = kNoLimit) {
  if (std::isfinite(limit)) {
    // While the lag demands more than the limit, the velocity is a ramp.
    const double gap = target - v;
    const double ramp = std::max(0.0, std::abs(gap) / limit - tau);
    v += std::copysign(limit * std::min(ramp, duration), gap);
    if (ramp >= duration) return v;
    duration -= ramp;
  }
  return tau > 0 ? target + (v - target) * std::exp(-duration / tau) : target;
}

/// The command in force `delay` ago, as time passes.
class DelayedCommands {
 public:
  DelayedCommands(const ResponseData& data, double delay) : data_(data), delay_(delay) {
    while (next_ < data.commands.size() && switch_time() < data.times.front() - kSameTime) ++next_;
  }

  /// Calls piece(command, duration) for each part of the interval with a constant command.
  template <typename Piece>
  void advance(double from, double to, Piece piece) {
    while (next_ < data_.commands.size() && switch_time() < to - kSameTime) {
      const double at = std::max(from, switch_time());
      piece(data_.commands[next_ - 1], at - from);
      from = at;
      ++next_;
    }
    piece(data_.commands[next_ - 1], to - from);
  }

 private:
  double switch_time() const { return data_.command_times[next_] + delay_; }

  const ResponseData& data_;
  double delay_;
  std::size_t next_ = 1;
};

}  // namespace slalom
