// SPDX-License-Identifier: BSD-3-Clause
#include "common.h"
#include "fourier.h"
#include "speed.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <optional>

namespace slalom::metrics {
namespace {

/// |v| sampled at equal intervals of dt seconds.
struct UniformSpeed {
  std::vector<double> v;
  double dt = 0;
};

constexpr std::size_t kMaxSamples = std::size_t{1} << 20;

/// Resamples the profile at its median interval, linear between samples; an incomplete interval at
/// the end is omitted. nullopt with `reason` if that is not possible.
std::optional<UniformSpeed> uniform_speed(const SpeedProfile& speeds, std::string& reason) {
  const double dt = median_interval(speeds.t);
  const double steps = std::floor((speeds.t.back() - speeds.t.front()) / dt + 1e-6);
  if (!(steps < static_cast<double>(kMaxSamples))) {
    reason = "more than " + std::to_string(kMaxSamples) + " median intervals";
    return std::nullopt;
  }
  UniformSpeed uniform;
  uniform.dt = dt;
  std::size_t i = 0;
  for (double k = 0; k <= steps; ++k) {
    const double t = speeds.t.front() + k * dt;
    while (i + 2 < speeds.t.size() && speeds.t[i + 1] <= t) ++i;
    const double fraction = std::min(1.0, (t - speeds.t[i]) / (speeds.t[i + 1] - speeds.t[i]));
    const double before = std::abs(speeds.v[i]), after = std::abs(speeds.v[i + 1]);
    uniform.v.push_back(before + fraction * (after - before));
  }
  if (uniform.v.size() >= 3) return uniform;
  reason = "fewer than three samples";
  return std::nullopt;
}

/// The uniform speed profile of a run with motion, or NA.
std::optional<UniformSpeed> speed_of(const MetricContext& context, Value& na) {
  if (const auto none = na_without_time(context)) {
    na = *none;
    return std::nullopt;
  }
  std::string reason;
  auto uniform = uniform_speed(without_short_intervals(speed_profile(context)), reason);
  if (uniform && *std::max_element(uniform->v.begin(), uniform->v.end()) <= 0) {
    reason = "the robot did not move";
    uniform.reset();
  }
  if (!uniform) na = Value::na(reason);
  return uniform;
}

/// Negative arc length of the normalized magnitude spectrum, both axes scaled to 1; up to 10 Hz or
/// half the sampling rate, between the first and the last magnitude of at least 5 %.
double spectral_arc_length(const UniformSpeed& speed) {
  constexpr double kCut = 10, kThreshold = 0.05;
  constexpr std::size_t kPadding = 16;
  std::size_t size = 1;
  while (size < speed.v.size()) size *= 2;
  size *= kPadding;
  std::vector<double> magnitudes = magnitude_spectrum(speed.v, size);
  const double highest = *std::max_element(magnitudes.begin(), magnitudes.end());
  const double bins = std::floor(kCut * speed.dt * static_cast<double>(size) + 1e-9);
  std::size_t last = std::min(magnitudes.size() - 1, static_cast<std::size_t>(bins)), first = 0;
  const auto is_low = [&](std::size_t i) { return magnitudes[i] < kThreshold * highest; };
  while (first < last && is_low(first)) ++first;
  while (last > first && is_low(last)) --last;
  double sum = 0;
  for (std::size_t i = first + 1; i <= last; ++i)
    sum += math::hypot(1 / static_cast<double>(last - first),
                       (magnitudes[i] - magnitudes[i - 1]) / highest);
  return -sum;
}

}  // namespace

/// SPARC (Balasubramanian et al. 2015), with their parameters.
Value sparc(const MetricContext& context) {
  Value na = Value::na("");
  const auto speed = speed_of(context, na);
  if (!speed) return na;
  const double arc = spectral_arc_length(*speed);
  return arc < 0 ? Value::of(arc) : Value::na("the spectrum is a single line");
}

/// -ln |(T^3 / v_peak^2) integral of (d2v/dt2)^2 dt| (Balasubramanian et al. 2015); as there, the
/// duration is the number of samples times dt.
Value log_dimensionless_jerk(const MetricContext& context) {
  constexpr double kRounding = 1e-12;
  Value na = Value::na("");
  const auto speed = speed_of(context, na);
  if (!speed) return na;
  const std::vector<double>& v = speed->v;
  double sum = 0;
  for (std::size_t i = 2; i < v.size(); ++i) {
    const double jerk = (v[i] - 2 * v[i - 1] + v[i - 2]) / (speed->dt * speed->dt);
    sum += jerk * jerk * speed->dt;
  }
  const double duration = static_cast<double>(v.size()) * speed->dt;
  const double peak = *std::max_element(v.begin(), v.end());
  const double jerk = duration * duration * duration / (peak * peak) * sum;
  if (jerk < kRounding) return Value::na("zero jerk");
  return Value::of(-math::log(jerk));
}

}  // namespace slalom::metrics
