// SPDX-License-Identifier: BSD-3-Clause
#include "common.h"
#include "mover_encounters.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace slalom::metrics {
namespace {

using mrpt::math::TPoint2D;

/// E. T. Hall, The Hidden Dimension, 1966: distances (m) between people, that is 18 inches and 4
/// feet, rounded.
constexpr double kIntimateSpace = 0.45, kPersonalSpace = 1.2;

/// The smallest distance (m) from a mover that was present; nullopt if none was.
std::optional<double> smallest_mover_gap(const MetricContext& context) {
  std::optional<double> smallest;
  for_each_encounter(context, [&](const Encounter& encounter) {
    const double gap = smallest_gap(encounter);
    smallest = smallest ? std::min(*smallest, gap) : gap;
  });
  return smallest;
}

/// The time (s) in which some mover is nearer than `distance` (m).
Value time_nearer_than(const MetricContext& context, double distance) {
  if (const auto na = na_without_movers(context)) return *na;
  if (const auto na = na_without_time(context)) return *na;
  std::vector<std::pair<double, double>> spans;
  for_each_encounter(context, [&](const Encounter& e) {
    const auto within = range_within(e.from, e.movement, e.reach + distance);
    if (!within) return;
    const double duration = e.end - e.begin;
    spans.emplace_back(e.begin + std::clamp(within->first, 0.0, 1.0) * duration,
                       e.begin + std::clamp(within->second, 0.0, 1.0) * duration);
  });
  std::sort(spans.begin(), spans.end());
  double total = 0, until = 0;
  for (const auto& [begin, end] : spans) {
    total += std::max(0.0, end - std::max(begin, until));
    until = std::max(until, end);
  }
  return Value::of(total);
}

TPoint2D velocity_of(const Sample& sample) {
  const double c = math::cos(sample.pose.phi), s = math::sin(sample.pose.phi);
  return {sample.v * c - sample.vy * s, sample.v * s + sample.vy * c};
}

/// The time (s) after which they touch if both keep their velocities; nullopt if they do not.
std::optional<double> time_to_contact(const MetricContext& context, const Sample& sample,
                                      const Mover& mover) {
  const double t = run_time(context, sample);
  if (!mover.present(t)) return std::nullopt;
  const auto within =
      range_within(TPoint2D(sample.pose) - mover.position(t),
                   velocity_of(sample) - mover.velocity(t), reach_of(context, mover));
  if (!within || within->second <= 0) return std::nullopt;
  return std::max(0.0, within->first);
}

}  // namespace

/// The smallest distance over time, not only at samples.
Value min_mover_clearance(const MetricContext& context) {
  if (const auto na = na_without_movers(context)) return *na;
  if (const auto na = na_without_time(context)) return *na;
  const auto gap = smallest_mover_gap(context);
  return gap ? Value::of(*gap) : Value::na("no mover was present");
}

/// Minimum over the samples and movers of the time to contact at constant velocities.
Value mover_time_to_collision(const MetricContext& context) {
  if (const auto na = na_without_movers(context)) return *na;
  std::optional<double> shortest;
  for (const Sample& sample : context.trajectory.samples)
    for (const Mover& mover : context.movers)
      if (const auto time = time_to_contact(context, sample, mover))
        shortest = shortest ? std::min(*shortest, *time) : *time;
  return shortest ? Value::of(*shortest) : Value::na("never on a collision course");
}

Value personal_space_time(const MetricContext& context) {
  return time_nearer_than(context, kPersonalSpace);
}

/// How far the robot entered: the radius of the personal space minus the smallest distance, at
/// least 0.
Value personal_space_depth(const MetricContext& context) {
  if (const auto na = na_without_movers(context)) return *na;
  if (const auto na = na_without_time(context)) return *na;
  const double gap = smallest_mover_gap(context).value_or(kPersonalSpace);
  return Value::of(std::clamp(kPersonalSpace - gap, 0.0, kPersonalSpace));
}

Value intimate_space_time(const MetricContext& context) {
  return time_nearer_than(context, kIntimateSpace);
}

}  // namespace slalom::metrics
