#pragma once

#include <slalom/trajectory/path.h>

#include <mrpt/math/TPose2D.h>

#include <array>
#include <string>
#include <vector>

namespace slalom {

/// One recorded instant (s, m, rad, m/s, rad/s; world frame).
struct Sample {
  double t = 0;
  mrpt::math::TPose2D pose;
  double v = 0, w = 0;  ///< actual speeds, ahead and of turning
  double command_v = 0,
         command_w = 0;           ///< what the method asked for, in force until the next sample;
                                  ///< NaN where a log does not tell
  double vy = 0, command_vy = 0;  ///< the same to the left; 0 for a differential drive

  /// The fields in the order of their declaration, for whoever writes, reads or hashes them all.
  static constexpr std::size_t kNumbers = 10;
  std::array<double, kNumbers> numbers() const;
  static Sample from_numbers(const std::array<double, kNumbers>& numbers);
};

/// Samples in order of time; sample 0 is the start.
struct Trajectory {
  std::vector<Sample> samples;

  double duration() const;  ///< t_N - t_1; 0 with fewer than two samples
  Path path() const;
  std::string hash() const;  ///< of all samples, bit by bit
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

std::string to_string(Outcome outcome);                ///< e.g. "method_crash"
Outcome outcome_from_string(const std::string& text);  ///< throws Error (File)
const std::vector<Outcome>& all_outcomes();

}  // namespace slalom
