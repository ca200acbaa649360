// SPDX-License-Identifier: BSD-3-Clause
#include "common.h"
#include "mover_encounters.h"

#include <algorithm>

namespace slalom {
namespace {

std::optional<Value> na_without_people(const MetricContext& context) {
  if (const auto na = na_without_samples(context)) return na;
  if (context.hindrances.empty()) return Value::na("no people");
  return na_without_verdict(context);
}

}  // namespace

namespace metrics {

/// Time that people lose by the robot, the sum over all.
Value people_hindrance(const MetricContext& context) {
  if (const auto na = na_without_people(context)) return *na;
  double sum = 0;
  for (const Hindrance& one : context.hindrances) sum += one.time;
  return Value::of(sum);
}

/// Share of all people who lose more than half a second.
Value people_hindered(const MetricContext& context) {
  constexpr double kNoticeable = 0.5;  // s
  if (const auto na = na_without_people(context)) return *na;
  const auto hindered = std::count_if(context.hindrances.begin(), context.hindrances.end(),
                                      [&](const Hindrance& one) { return one.time > kNoticeable; });
  return Value::of(static_cast<double>(hindered) / static_cast<double>(context.hindrances.size()));
}

/// Change of the velocity of people by the robot, the mean over the updates with it in reach.
Value people_speed_change(const MetricContext& context) {
  if (const auto na = na_without_people(context)) return *na;
  double sum = 0, updates = 0;
  for (const Hindrance& one : context.hindrances) {
    sum += one.speed_change;
    updates += one.updates;
  }
  if (updates > 0) return Value::of(sum / updates);
  return Value::na("nobody who notices the robot had it in reach");
}

/// 1 if the person had noticed the robot: by Crowd such a contact is the robot's doing.
Value contact_blame(const MetricContext& context) {
  if (const auto na = na_without_people(context)) return *na;
  if (context.outcome != Outcome::Collision)
    return Value::na("outcome: " + to_string(context.outcome));
  const Mover* mover = touched_mover(context);
  // People follow the movers of the scenario.
  const Mover* people = context.movers.data() + context.movers.size() - context.hindrances.size();
  if (mover == nullptr || mover < people) return Value::na("no contact with a person");
  return Value::of(context.hindrances[static_cast<std::size_t>(mover - people)].is_noticed ? 1 : 0);
}

}  // namespace metrics
}  // namespace slalom
