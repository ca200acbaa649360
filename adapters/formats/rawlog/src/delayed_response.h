// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace slalom {

constexpr double kSameTime = 1e-6;  // s; timestamps are rounded to 2e-7
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// One velocity of a robot (linear or angular), in m/s or rad/s.
struct ResponseData {
  std::vector<double> command_times, commands;  ///< each is in force until the next
  std::vector<double> times, measured;
  double max_acceleration = 0;  ///< m/s^2, rad/s^2; 0: unknown
};

/// The velocity of a robot with a first-order lag whose acceleration is limited.
class LaggedVelocity {
 public:
  LaggedVelocity(double start, double tau, double limit)
      : velocity_(start), tau_(tau), limit_(limit) {}

  double velocity() const { return velocity_; }
  double decay() const { return decay_; }  ///< derivative of the velocity by that at the start

  void advance(double target, double duration) {
    if (std::isfinite(limit_)) {
      // While the lag demands more than the limit, the velocity is a ramp.
      const double gap = target - velocity_;
      const double ramp = std::max(0.0, std::abs(gap) / limit_ - tau_);
      velocity_ += std::copysign(limit_ * std::min(ramp, duration), gap);
      if (ramp >= duration) return;
      duration -= ramp;
    }
    const double rest = tau_ > 0 ? exponential(duration) : 0;
    velocity_ = target + (velocity_ - target) * rest;
    decay_ *= rest;
  }

 private:
  double exponential(double duration) {
    constexpr double kSameDuration = 1e-9;  // s; most durations are equal
    if (!(std::abs(duration - duration_) < kSameDuration)) {
      duration_ = duration;
      exponential_ = math::exp(-duration / tau_);
    }
    return exponential_;
  }

  double velocity_, tau_, limit_;
  double decay_ = 1;
  double duration_ = 0, exponential_ = 1;  ///< the latest
};

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
