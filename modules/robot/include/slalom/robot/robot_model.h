#pragma once

#include <slalom/core/options.h>

namespace slalom {

/// The robot: a disc with bounded speeds and accelerations. Defaults are the paper's robot: forward
/// motion only. Section [robot].
struct RobotModel {
  std::string kinematics = "diff_drive";
  double radius = 0.25;      ///< m, disc footprint
  double max_v = 1.0;        ///< m/s
  double max_w = 1.5;        ///< rad/s
  double max_accel_v = 1.0;  ///< m/s^2
  double max_accel_w = 3.0;  ///< rad/s^2
  bool forward_only = true;

  void visit(OptionVisitor& v);
};

/// The range sensor, at the robot's centre, looking along its heading. Section [sensor].
struct SensorModel {
  double aperture_deg = 180;
  int rays = 181;
  double max_range = 8.0;  ///< m

  void visit(OptionVisitor& v);
  double aperture() const;  ///< rad
};

}  // namespace slalom
