// SPDX-License-Identifier: BSD-3-Clause
#include "turning_in_place.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr double kLast = 8;         // s
constexpr double kStanding = 0.05;  // m/s
constexpr double kTurning = 0.1;    // rad/s
constexpr std::size_t kFewest = 3;

}  // namespace

void TurningInPlace::add(std::size_t method, const RunRecord& run, const Trajectory& trajectory) {
  if (run.outcome == to_string(Outcome::Success) || trajectory.samples.empty()) return;
  ++failures_[method];
  if (ends_turning_in_place(trajectory)) ++turning_[method];
}

std::string TurningInPlace::line_of(std::size_t method) const {
  const std::size_t turning = turning_[method], failures = failures_[method];
  if (turning < kFewest || 2 * turning < failures) return "";
  return "turns in place at the end of " + std::to_string(turning) + " of " +
         std::to_string(failures) + " failures: does it see what it turns to?";
}

bool ends_turning_in_place(const Trajectory& trajectory) {
  const std::vector<Sample>& samples = trajectory.samples;
  if (samples.empty()) return false;
  const auto is_late = [&](const Sample& one) { return one.t >= samples.back().t - kLast; };
  const auto first = std::find_if(samples.begin(), samples.end(), is_late);
  const auto turning = std::count_if(first, samples.end(), [](const Sample& one) {
    return math::hypot(one.v, one.vy) < kStanding && std::abs(one.w) > kTurning;
  });
  return 2 * turning > samples.end() - first;
}

}  // namespace slalom
