#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace slalom {

constexpr double kModelAccuracy = 1e-3;  // m/s, rad/s; accuracy of the model of the response

/// Least squares with given lag.
struct LagFit {
  double residual = 0;  ///< sum of squares
  double gain = 0;
  double information = 0;  ///< the variance of the gain is that of the residuals divided by it
  std::size_t samples = 0, segments = 0;
  double sum = 0, sum_of_squares = 0;  ///< of the samples

  /// Of the residuals.
  double variance() const {
    const double freedom =
        std::max(1.0, static_cast<double>(samples) - static_cast<double>(segments) - 3);
    return std::max(residual / freedom, kModelAccuracy * kModelAccuracy);
  }
  /// Of the samples.
  double total_variance() const {
    const auto n = static_cast<double>(samples);
    return sum_of_squares / n - std::pow(sum / n, 2);
  }
};

/// Sums over a segment: consecutive velocities, the first of which is a free parameter. It decays
/// as `decay`, and `forced` is the response at rest to commands with gain 1.
class SegmentSums {
 public:
  void add(double decay, double forced, double measured) {
    ++n_;
    dd_ += decay * decay;
    df_ += decay * forced;
    dm_ += decay * measured;
    ff_ += forced * forced;
    fm_ += forced * measured;
    mm_ += measured * measured;
    m_ += measured;
  }

  /// Adds the sums of what the first velocity does not explain; `residual` is with gain 0 here.
  void add_to(LagFit& fit, double& forced_measured) const {
    if (n_ < 2) return;
    fit.samples += n_;
    ++fit.segments;
    fit.residual += mm_ - dm_ * dm_ / dd_;
    fit.sum += m_;
    fit.sum_of_squares += mm_;
    fit.information += ff_ - df_ * df_ / dd_;
    forced_measured += fm_ - df_ * dm_ / dd_;
  }

 private:
  std::size_t n_ = 0;
  double dd_ = 0, df_ = 0, dm_ = 0, ff_ = 0, fm_ = 0, mm_ = 0, m_ = 0;
};

}  // namespace slalom
