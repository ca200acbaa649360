// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/geometry.h"
#include "common/robot.h"

namespace dwa_local_planner {

/// Forbids to reverse the direction of motion, or of rotation in place, until the robot has moved:
/// the oscillation critic of base_local_planner.
class OscillationCritic {
 public:
  /// m and rad, from where a direction was reversed; m/s, below which a motion is a rotation.
  OscillationCritic(double reset_dist, double reset_angle, double min_vel_trans)
      : reset_dist_(reset_dist), reset_angle_(reset_angle), min_vel_trans_(min_vel_trans) {}

  void reset() { forward_ = rotation_ = {}; }
  void take_over(const OscillationCritic& before) {
    forward_ = before.forward_;
    rotation_ = before.rotation_;
    reversed_at_ = before.reversed_at_;
  }
  bool allows(const reactive::Twist& twist) const;
  void commanded(const reactive::Twist& twist, const reactive::Pose& pose);

 private:
  struct Direction {
    int last = 0;  ///< the sign of the last motion
    int only = 0;  ///< the sign that is allowed; 0 both
    void move(int sign) {
      if (sign == 0) return;
      if (last != 0 && sign != last) only = sign;
      last = sign;
    }
  };

  double reset_dist_, reset_angle_, min_vel_trans_;
  Direction forward_, rotation_;
  reactive::Pose reversed_at_;
};

}  // namespace dwa_local_planner
