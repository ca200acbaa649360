#pragma once

#include <slalom/core/value.h>

#include <cstddef>
#include <string>
#include <vector>

namespace slalom {

/// One velocity of a robot (linear or angular), in m/s or rad/s.
struct ResponseData {
  std::vector<double> command_times, commands;  ///< each is in force until the next
  std::vector<double> times, measured;
  double max_acceleration = 0;  ///< m/s^2, rad/s^2; 0: unknown
};

/// A response to commands: dead time, first-order lag, and gain (measured / commanded in the steady
/// state), each with its standard error.
struct ResponseFit {
  std::string problem;           ///< why there is no estimate; "" otherwise
  Value delay, delay_tau, gain;  ///< s, s, -; without a problem
  std::size_t samples = 0;       ///< measured velocities that the fit explains
};

/// Least squares of the simulated response of
///     tau dv/dt + v = gain u(t - delay)
/// to the commands u, which are held until the next, against the measured velocities (an
/// output-error model: L. Ljung, "System Identification", 2nd ed., 1999, section 4.3; noise of the
/// measurements does not bias it). The response starts with a free velocity after each interval in
/// which the limit of acceleration is or may be active; these intervals are not fitted. If the
/// limit is unknown, that with which the complete response is most likely is assumed, if there is
/// one.
///
/// The standard error of a parameter is the distance at which the sum of squares, minimized over
/// the others, has increased by the residual variance: that of the covariance matrix where the sum
/// is quadratic (Ljung, section 9.4), and the range of equally good values where it is flat. Only
/// velocities measured later than `max_delay` (s) after the first command, and not after the last,
/// are used.
ResponseFit fit_response(const ResponseData& data, double max_delay);

}  // namespace slalom
