// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace slalom {

constexpr double kModelAccuracy = 1e-3;  // m/s, rad/s; accuracy of the model of the response

/// Least squares of measured velocities with given lag and limit of acceleration.
struct LagFit {
  double residual = 0;  ///< sum of squares
  double gain = 0;
  double information = 0;  ///< the sum of squares grows by that times the square of a changed gain
  std::size_t samples = 0;
  double total = 0;  ///< sum of squares of the distances of the velocities from their mean

  /// The sum of squares with another gain.
  double residual_with(double other_gain) const {
    return residual + information * (other_gain - gain) * (other_gain - gain);
  }
};

/// Sums over velocities that are gain * response + c * decay, with free gain and c.
class ResponseSums {
 public:
  void add(double decay, double response, double measured) {
    ++n_;
    dd_ += decay * decay;
    df_ += decay * response;
    dm_ += decay * measured;
    ff_ += response * response;
    fm_ += response * measured;
    mm_ += measured * measured;
    m_ += measured;
  }

  /// Requires at least one velocity.
  LagFit solve() const {
    LagFit fit;
    fit.samples = n_;
    fit.total = mm_ - m_ * m_ / static_cast<double>(n_);
    fit.information = std::max(0.0, ff_ - df_ * df_ / dd_);
    const double covariance = fm_ - df_ * dm_ / dd_;
    if (fit.information > 0) fit.gain = covariance / fit.information;
    fit.residual = std::max(0.0, mm_ - dm_ * dm_ / dd_ - fit.gain * covariance);
    return fit;
  }

 private:
  std::size_t n_ = 0;
  double dd_ = 0, df_ = 0, dm_ = 0, ff_ = 0, fm_ = 0, mm_ = 0, m_ = 0;
};

}  // namespace slalom
