// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "steering.h"

#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <thread>
#include <vector>

namespace slalom {

/// The node of a test, without its middleware: PEER [--stamped] [--timer] [--odometry] [FAULT]. It
/// commands by steer() for each scan, or from a timer of 0.1 s of simulated time, as soon as it has
/// a goal; with --odometry it also turns with the newest velocity, and handles scans before it.
///
/// The fault occurs on the way to goals with y > 3, from the fifth scan on since the robot moves.
class NavigatingNode {
 public:
  struct Answer {
    Steering velocity;
    std::int64_t stamp = 0;   // ns, of its scan
    std::size_t padding = 0;  // bytes of frame_id
  };

  NavigatingNode(int argc, char** argv, std::function<void(const Answer&)> publish)
      : publish_(std::move(publish)) {
    for (int i = 1; i < argc; ++i) {
      const std::string argument = argv[i];
      if (argument == "--stamped")
        stamped_ = true;
      else if (argument == "--timer")
        timer_ = true;
      else if (argument == "--odometry")
        uses_odometry_ = true;
      else
        fault_ = argument;
    }
  }

  /// A parameter: the factor of its velocities.
  double speed() const { return speed_; }
  /// Returns the reason for which it is refused, or "".
  std::string set_speed(double speed) {
    if (speed > 1) return "it is beyond 1";
    if (fault_ != "forgetful") speed_ = speed;
    return "";
  }

  bool stamped() const { return stamped_; }
  bool uses_odometry() const { return uses_odometry_; }
  /// The fault, for those that concern the middleware.
  const std::string& fault() const { return fault_; }
  bool has_fault_now() const { return faulty_run_ && scans_ >= 5; }

  void on_goal(double y) {
    faulty_run_ = y > 3;
    scans_ = 0;
    has_goal_ = true;
  }

  void on_odometry(double v) {
    moves_ = v > 0;
    measured_v_ = v;
  }

  void on_scan(std::int64_t stamp, const std::vector<float>& ranges, float angle_min,
               float angle_increment) {
    previous_stamp_ = latest_.stamp;
    latest_ = {steer(ranges.data(), ranges.size(), angle_min, angle_increment), stamp};
    if (moves_) ++scans_;
    if (!timer_) answer();
  }

  /// The first time activates simulated time only, as in rclcpp.
  void on_clock(std::int64_t now) {
    const bool due = now_ > 0 && now / kPeriod > now_ / kPeriod;
    now_ = now;
    if (timer_ && due) answer();
  }

  static constexpr double kTurn = 0.1;  // rad/m

 private:
  static constexpr std::int64_t kPeriod = 100'000'000;  // ns

  void answer() {
    if (!has_goal_ || latest_.stamp == 0) return;
    Answer answer = latest_;
    answer.velocity.v *= speed_;
    if (uses_odometry_) answer.velocity.w += kTurn * measured_v_;
    if (fault_ == "thinks") std::this_thread::sleep_for(std::chrono::milliseconds(30));
    if (has_fault_now()) {
      if (fault_ == "silent") return;
      if (fault_ == "exit") std::exit(3);
      if (fault_ == "killed") std::raise(SIGKILL);
      if (fault_ == "nan") answer.velocity.v = std::numeric_limits<double>::quiet_NaN();
      if (fault_ == "fast") answer.velocity.v = 9;
      if (fault_ == "stale") answer.stamp = previous_stamp_;
      if (fault_ == "huge") answer.padding = 200'000;
      if (fault_ == "pauses" && scans_ % 2 == 0) return;
    }
    if (fault_ == "twice") publish_({{0.05, 0}, answer.stamp});
    publish_(answer);
  }

  std::function<void(const Answer&)> publish_;
  std::string fault_;
  bool stamped_ = false, timer_ = false, uses_odometry_ = false, has_goal_ = false,
       faulty_run_ = false, moves_ = false;
  int scans_ = 0;
  double speed_ = 1, measured_v_ = 0;
  Answer latest_;
  std::int64_t previous_stamp_ = 0, now_ = 0;
};

}  // namespace slalom
