// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/value.h>
#include <slalom/rawlog/motion_log.h>
#include <slalom/robot/robot_model.h>
#include <slalom/statistics/statistics.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// An estimated property of a robot.
struct Estimate {
  std::string id;  ///< the key of an .ini, or v_bias, w_bias
  std::string unit;
  Value value;
  std::size_t samples = 0;                ///< velocities, or ranges, on which it is based
  std::optional<Interval> interval = {};  ///< with the confidence of Identification
  std::string no_interval = {};           ///< why a value has none
};

/// The estimates from one log.
struct Identification {
  static constexpr double kConfidence = 0.95;

  std::string log;
  /// [robot] delay and delay_tau; v_bias and w_bias: measured / commanded linear and angular
  /// velocity in the steady state; [sensor] noise_sigma, dropout_ratio and quantum.
  std::vector<Estimate> estimates;
  std::vector<std::string> warnings;  ///< delays or time constants of v and w that differ

  const Estimate& at(const std::string& id) const;  ///< throws std::out_of_range
};

struct IdentificationSetup {
  double max_delay = 1;             ///< s; the largest delay that is considered
  std::optional<RobotModel> robot;  ///< its limits of velocity and acceleration, if known
};

/// Estimates the response of a robot to commands and the noise of its range sensor. Delay and time
/// constant are those with which the velocities v and w together are most likely. The noise is that
/// of each ray in the longest phase in which the robot is stationary, of at least 20 scans. Leaves
/// `log` empty.
///
/// Intervals of the response are of profile likelihood; those of the noise are of the chi-squared
/// distribution of a variance, and those of the dropout of C. J. Clopper, E. S. Pearson, "The use
/// of confidence or fiducial limits illustrated in the case of the binomial", Biometrika 26, 1934.
Identification identify(const MotionLog& log, const IdentificationSetup& setup);

/// A table, and the estimates as a fragment of an .ini.
std::string render_text(const Identification& identification);
/// One line.
std::string render_json(const Identification& identification);

}  // namespace slalom
