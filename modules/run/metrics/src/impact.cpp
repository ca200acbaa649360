// SPDX-License-Identifier: BSD-3-Clause
#include "common.h"
#include "mover_encounters.h"

#include <slalom/core/math.h>

#include <algorithm>

namespace slalom::metrics {
namespace {

/// The pose `dt` seconds before this sample, extrapolated with the sample's velocity.
mrpt::math::TPose2D pose_before(const Sample& sample, double dt) {
  const double phi = sample.pose.phi - sample.w * dt;
  const double c = math::cos(phi), s = math::sin(phi);
  return {sample.pose.x - (sample.v * c - sample.vy * s) * dt,
          sample.pose.y - (sample.v * s + sample.vy * c) * dt, phi};
}

}  // namespace

/// Speed along the contact normal at the first contact, which ends a run: the rate of decrease of
/// the footprint's clearance from static obstacles.
Value impact_speed(const MetricContext& context) {
  constexpr double kStep = 1e-3;  // s, corresponds to about 1 mm
  if (context.outcome != Outcome::Collision)
    return Value::na("outcome: " + to_string(context.outcome));
  if (const auto na = na_without_samples(context)) return *na;
  if (touched_mover(context) != nullptr) return Value::na("contact with a mover");
  const Sample& last = context.trajectory.samples.back();
  const double before =
      footprint_clearance(context.world, context.robot.shape(), pose_before(last, kStep));
  const double now = footprint_clearance(context.world, context.robot.shape(), last.pose);
  return Value::of(std::max(0.0, (before - now) / kStep));
}

/// Minimum time to contact at a constant closing speed: d_i / (rate of decrease of the clearance
/// since the previous sample), over the samples with a decrease.
Value min_time_to_collision(const MetricContext& context) {
  constexpr double kMinClosingSpeed = 1e-6;  // m/s; lower values are rounding noise
  if (const auto na = na_without_time(context)) return *na;
  const auto& samples = context.trajectory.samples;
  std::optional<double> min_time;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double gap = context.clearances[i];
    const double closing = (context.clearances[i - 1] - gap) / (samples[i].t - samples[i - 1].t);
    if (closing < kMinClosingSpeed) continue;
    const double time = std::max(0.0, gap) / closing;
    min_time = min_time ? std::min(*min_time, time) : time;
  }
  return min_time ? Value::of(*min_time) : Value::na("the clearance never decreased");
}

}  // namespace slalom::metrics
