// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "delayed_response.h"
#include "profile.h"

#include <cstddef>
#include <string>

namespace slalom {

/// A response to commands: dead time, first-order lag, and gain (measured / commanded in the steady
/// state).
struct ResponseFit {
  std::string problem;             ///< why there is no estimate; "" otherwise
  Profile delay, delay_tau, gain;  ///< s, s, -; without a problem
  std::size_t samples = 0;         ///< measured velocities
};

/// Least squares of the simulated response of
///     tau dv/dt + v = gain u(t - delay)
/// to the commands u, which are held until the next, against the measured velocities (an
/// output-error model: L. Ljung, "System Identification", 2nd ed., 1999, section 4.3; noise of the
/// measurements does not bias it). The acceleration is limited. If the limit is unknown, it is
/// fitted too if the log is much more likely with it than without. The velocity at the first
/// measurement is free.
///
/// Only velocities measured later than `max_delay` (s) after the first command, and not after the
/// last, are used. Their noise counts as independent.
ResponseFit fit_response(const ResponseData& data, double max_delay);

}  // namespace slalom
