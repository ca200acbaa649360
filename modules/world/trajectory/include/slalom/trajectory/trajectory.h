// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/enum_names.h>
#include <slalom/trajectory/path.h>

#include <mrpt/math/TPose2D.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace slalom {

/// The recorded state at one time (s, m, rad, m/s, rad/s; world frame).
struct Sample {
  double t = 0;
  mrpt::math::TPose2D pose;
  double v = 0, w = 0;  ///< actual linear and angular velocity
  double command_v = 0,
         command_w = 0;           ///< of the method, in effect until the next sample;
                                  ///< NaN if a log does not have it
  double vy = 0, command_vy = 0;  ///< the same to the left; 0 for a differential drive
  /// m, driven up to here along the true motion; NaN if it is not known, as in a log.
  double traveled = std::numeric_limits<double>::quiet_NaN();

  /// The fields in the order of their declaration, for writing, reading and hashing.
  static constexpr std::size_t kNumbers = 11;
  std::array<double, kNumbers> numbers() const;
  static Sample from_numbers(const std::array<double, kNumbers>& numbers);
};

/// Samples ordered by time; sample 0 is the start.
struct Trajectory {
  std::vector<Sample> samples;

  double duration() const;  ///< t_N - t_1; 0 with fewer than two samples
  Path path() const;
  /// m, from the first to the last sample: as recorded, else straight between samples.
  double traveled() const;
  std::string hash() const;  ///< of the bits of all samples
};

/// How a run ended.
enum class Outcome {
  Success,
  Collision,
  Timeout,
  Stuck,
  LeftWorkspace,
  MethodCrash,
  MethodDeadline,
  MethodInvalidCommand,
  MethodError,
  UnsolvableScenario,
  InfrastructureError
};
constexpr auto enum_names(Outcome) {
  return std::array{"success",
                    "collision",
                    "timeout",
                    "stuck",
                    "left_workspace",
                    "method_crash",
                    "method_deadline",
                    "method_invalid_command",
                    "method_error",
                    "unsolvable_scenario",
                    "infrastructure_error"};
}

}  // namespace slalom
