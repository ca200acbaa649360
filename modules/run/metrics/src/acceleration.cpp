// SPDX-License-Identifier: BSD-3-Clause
#include "common.h"
#include "speed.h"

namespace slalom::metrics {
namespace {

enum class Motion { Linear, Angular };

/// A difference quotient and the duration (s) of its interval.
struct Rate {
  double value, dt;
};

std::vector<Rate> accelerations(const SpeedProfile& speeds, Motion motion) {
  const std::vector<double>& speed = motion == Motion::Linear ? speeds.v : speeds.w;
  std::vector<Rate> rates;
  for (std::size_t i = 1; i < speed.size(); ++i) {
    const double dt = speeds.t[i] - speeds.t[i - 1];
    rates.push_back({(speed[i] - speed[i - 1]) / dt, dt});
  }
  return rates;
}

/// Second differences of the speed: changes between accelerations, which refer to the midpoints of
/// their intervals.
std::vector<Rate> jerks(const std::vector<Rate>& accelerations) {
  std::vector<Rate> rates;
  for (std::size_t i = 1; i < accelerations.size(); ++i) {
    const double dt = 0.5 * (accelerations[i].dt + accelerations[i - 1].dt);
    rates.push_back({(accelerations[i].value - accelerations[i - 1].value) / dt, dt});
  }
  return rates;
}

/// Root mean square over time.
Value rms(const std::vector<Rate>& rates, const char* reason) {
  if (rates.empty()) return Value::na(reason);
  double sum = 0, time = 0;
  for (const Rate& rate : rates) {
    sum += rate.value * rate.value * rate.dt;
    time += rate.dt;
  }
  return Value::of(std::sqrt(sum / time));
}

Value rms_acceleration(const MetricContext& context, Motion motion) {
  if (const auto na = na_without_time(context)) return *na;
  const SpeedProfile speeds = without_short_intervals(speed_profile(context));
  return rms(accelerations(speeds, motion), "fewer than two samples");
}

Value rms_jerk(const MetricContext& context, Motion motion) {
  if (const auto na = na_without_time(context)) return *na;
  const SpeedProfile speeds = without_short_intervals(speed_profile(context));
  return rms(jerks(accelerations(speeds, motion)), "fewer than three samples");
}

}  // namespace

Value rms_linear_acceleration(const MetricContext& context) {
  return rms_acceleration(context, Motion::Linear);
}

Value rms_angular_acceleration(const MetricContext& context) {
  return rms_acceleration(context, Motion::Angular);
}

Value rms_linear_jerk(const MetricContext& context) {
  return rms_jerk(context, Motion::Linear);
}

Value rms_angular_jerk(const MetricContext& context) {
  return rms_jerk(context, Motion::Angular);
}

}  // namespace slalom::metrics
