// SPDX-License-Identifier: BSD-3-Clause
#include "../descriptor_parameters.h"
#include "confined_fraction.h"

#include <cmath>

namespace slalom::descriptors {
namespace {

constexpr int kMinSamples = 200;
constexpr int kMaxSamples = 200000;
constexpr double kMaxStandardError = 0.005;

/// Mean and its standard error under the assumption of independent samples, which is conservative
/// for this low-discrepancy sequence.
class SampleMean {
 public:
  void add(double x) {
    ++count_;
    const double change = x - mean_;
    mean_ += change / count_;
    squares_ += change * (x - mean_);
  }
  int count() const { return count_; }
  double value() const { return mean_; }
  double error() const { return count_ < 2 ? 1.0 : std::sqrt(squares_ / (count_ - 1.0) / count_); }

 private:
  int count_ = 0;
  double mean_ = 0, squares_ = 0;
};

Value sampled_confinement(const DescriptorContext& context, const Occupancy& cells) {
  constexpr double kR2X = 0.7548776662466927;  // 1/p and 1/p^2, p the plastic number
  constexpr double kR2Y = 0.5698402909980532;
  SampleMean mean;
  for (int i = 1;
       i <= kMaxSamples && !(mean.count() >= kMinSamples && mean.error() <= kMaxStandardError);
       ++i) {
    const mrpt::math::TPoint2D point =
        cells.to_world(fractional_part(0.5 + i * kR2X) * cells.size_x(),
                       fractional_part(0.5 + i * kR2Y) * cells.size_y());
    const mrpt::math::TPoint2D at = cells.to_cells(point);
    if (cells.occupied(static_cast<int>(at.x), static_cast<int>(at.y))) continue;
    mean.add(confined_fraction(context.world, point, context.sensor_range,
                               fractional_part(i * kGoldenRatio)));
  }
  if (mean.count() == 0) return Value::na("no free sample among " + std::to_string(kMaxSamples));
  return Value::of(mean.value(), mean.error());
}

}  // namespace

std::string confinement_method(const DescriptorContext& context) {
  return context.exact_confinement ? "confinement=integrated" : "";
}

/// (1/area F) integral over F of the fraction of directions in which a ray hits O within R.
///
/// Sample points are the members of Roberts' R2 sequence (additive recurrence with the plastic
/// number) that lie in F; the ray fans are rotated from point to point by the golden ratio.
/// Sampling stops when the standard error of the mean is at most kMaxStandardError. Optionally the
/// exact arcs are integrated over all free cells instead.
Value confinement(const DescriptorContext& context) {
  const Occupancy& cells = context.world.occupancy();
  if (cells.count_occupied() == cells.cells().size()) return Value::na("no free space");
  return context.exact_confinement ? Value::of(exact_confinement(cells, context.sensor_range))
                                   : sampled_confinement(context, cells);
}

}  // namespace slalom::descriptors
