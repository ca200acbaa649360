// SPDX-License-Identifier: BSD-3-Clause
#include "follow_the_gap.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>

namespace follow_the_gap {
namespace {

/// Half the angular width of an enlarged obstacle; pi/2 if the robot is inside it.
double half_angle(double range, double radius) {
  return range <= radius ? M_PI / 2 : slalom::math::asin(radius / range);
}

double nearest_of(const std::vector<double>& ranges) {
  return *std::min_element(ranges.begin(), ranges.end());
}

/// Speed from which the robot can stop within `free_distance`, with a margin.
double stopping_speed(double free_distance, const Robot& robot) {
  constexpr double kMargin = 0.05;  // m
  return std::sqrt(2 * 0.7 * robot.max_accel_v * std::max(0.0, free_distance - kMargin));
}

Twist rotate_in_place(int side, const Robot& robot) {
  return {0, side * robot.max_w};
}

}  // namespace

std::vector<Gap> find_gaps(const std::vector<double>& ranges, double aperture, double radius,
                           double horizon) {
  const std::size_t count = ranges.size();
  std::vector<char> closed(count, 0);
  const double step = count < 2 ? 1.0 : aperture / static_cast<double>(count - 1);
  for (std::size_t i = 0; i < count; ++i) {
    if (ranges[i] > horizon) continue;
    const auto reach = static_cast<std::ptrdiff_t>(half_angle(ranges[i], radius) / step);
    const auto at = static_cast<std::ptrdiff_t>(i);
    const auto last = std::min(at + reach, static_cast<std::ptrdiff_t>(count) - 1);
    for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(at - reach, 0); k <= last; ++k)
      closed[static_cast<std::size_t>(k)] = 1;
  }
  std::vector<Gap> gaps;
  for (std::size_t i = 0; i < count; ++i) {
    if (closed[i] != 0) continue;
    std::size_t end = i;
    while (end + 1 < count && closed[end + 1] == 0) ++end;
    gaps.push_back({ray_angle(i, count, aperture), ray_angle(end, count, aperture)});
    i = end;
  }
  return gaps;
}

const Gap* choose_gap(const std::vector<Gap>& gaps, double goal_angle, double goal_weight) {
  const Gap* best = nullptr;
  double best_value = 0;
  for (const Gap& gap : gaps) {
    const double nearest = std::clamp(goal_angle, gap.low, gap.high);
    const double value = gap.width() - goal_weight * std::abs(goal_angle - nearest) * 2;
    if (best != nullptr && value <= best_value) continue;
    best = &gap;
    best_value = value;
  }
  return best;
}

double final_heading(const Gap& gap, double goal_angle, double nearest, double alpha) {
  const double center = 0.5 * (gap.low + gap.high);
  const double weight = alpha / std::max(nearest, 1e-3);
  const double heading = (weight * center + goal_angle) / (weight + 1);
  return std::clamp(heading, gap.low, gap.high);
}

double free_distance_ahead(const std::vector<double>& ranges, double aperture, double max_range,
                           double radius) {
  constexpr double kRounding = 1e-9;
  double free_distance = max_range;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (ranges[i] >= max_range) continue;
    const double angle = ray_angle(i, ranges.size(), aperture);
    // Most rays end beside the robot's way, by |sin a| >= |a| / (pi / 2), or behind: no sine
    // needed.
    if (ranges[i] * std::min(std::abs(angle) / (M_PI / 2), 1.0) > radius * (1 + kRounding))
      continue;
    const double x = ranges[i] * slalom::math::cos(angle), y = ranges[i] * slalom::math::sin(angle);
    if (x <= 0 || std::abs(y) >= radius) continue;
    free_distance = std::min(free_distance, x - std::sqrt(radius * radius - y * y));
  }
  return std::max(0.0, free_distance);
}

Twist decide(const std::vector<double>& ranges, double goal_x, double goal_y,
             const Parameters& parameters, const Robot& robot, int& last_side) {
  const double goal_angle = slalom::math::atan2(goal_y, goal_x);
  const double goal_distance = slalom::math::hypot(goal_x, goal_y);
  const double enlarged = robot.radius + parameters.margin;
  constexpr double kShorter = 0.8;
  const double seen = 0.999 * robot.max_range;  // a ray without an obstacle has max_range
  double horizon = std::min({parameters.look_ahead, goal_distance + robot.radius, seen});
  std::vector<Gap> gaps = find_gaps(ranges, robot.aperture, enlarged, horizon);
  // A look-ahead at which no direction is free is too long.
  while (gaps.empty() && horizon * kShorter > 2 * enlarged) {
    horizon *= kShorter;
    gaps = find_gaps(ranges, robot.aperture, enlarged, horizon);
  }
  const Gap* gap = choose_gap(gaps, goal_angle, parameters.goal_weight);
  if (gap == nullptr) {
    if (last_side == 0) last_side = goal_angle >= 0 ? 1 : -1;
    return rotate_in_place(last_side, robot);
  }
  last_side = 0;
  const double nearest = nearest_of(ranges);
  const double heading = nearest < horizon
                             ? final_heading(*gap, goal_angle, nearest, parameters.alpha)
                             : std::clamp(goal_angle, gap->low, gap->high);
  const double w = std::clamp(parameters.turn_gain * heading, -robot.max_w, robot.max_w);
  if (std::abs(heading) > parameters.turn_in_place) return {0, w};
  const double free_distance = free_distance_ahead(ranges, robot.aperture, robot.max_range,
                                                   robot.radius + 0.5 * parameters.margin);
  const double v =
      std::min({robot.max_v * slalom::math::cos(heading), stopping_speed(free_distance, robot),
                stopping_speed(goal_distance + 0.3, robot)});
  return {std::clamp(v, 0.0, robot.max_v), w};
}

Twist stop_before_turning(const Twist& wanted, double measured_v, const Robot& robot,
                          double period) {
  const bool stops = std::abs(measured_v) <= robot.max_accel_v * period;
  return wanted.v > 0 || stops ? wanted : Twist{};
}

}  // namespace follow_the_gap
