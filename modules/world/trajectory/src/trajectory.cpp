// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/hash.h>
#include <slalom/trajectory/trajectory.h>

#include <cmath>

namespace slalom {

std::array<double, Sample::kNumbers> Sample::numbers() const {
  return {t, pose.x, pose.y, pose.phi, v, w, command_v, command_w, vy, command_vy, traveled};
}

Sample Sample::from_numbers(const std::array<double, kNumbers>& n) {
  return {n[0], {n[1], n[2], n[3]}, n[4], n[5], n[6], n[7], n[8], n[9], n[10]};
}

double Trajectory::duration() const {
  return samples.size() < 2 ? 0.0 : samples.back().t - samples.front().t;
}

Path Trajectory::path() const {
  Path path;
  path.reserve(samples.size());
  for (const Sample& sample : samples) path.emplace_back(sample.pose.x, sample.pose.y);
  return path;
}

double Trajectory::traveled() const {
  if (samples.empty()) return 0;
  const double recorded = samples.back().traveled - samples.front().traveled;
  return std::isfinite(recorded) ? recorded : length(path());
}

std::string Trajectory::hash() const {
  Hasher hasher;
  for (const Sample& s : samples)
    for (const double number : s.numbers()) hasher.add(number);
  return hasher.hex();
}

}  // namespace slalom
