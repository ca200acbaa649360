// SPDX-License-Identifier: BSD-3-Clause
#include "common.h"
#include "mover_encounters.h"

#include <slalom/core/geometry.h>
#include <slalom/scenario/mover.h>

#include <algorithm>

namespace slalom {
namespace {

std::optional<Value> na_without_people(const MetricContext& context) {
  if (const auto na = na_without_samples(context)) return na;
  if (context.hindrances.empty()) return Value::na("no people");
  return na_without_verdict(context);
}

Value mean_over_people(const MetricContext& context, std::optional<double> Hindrance::*delay) {
  if (const auto na = na_without_people(context)) return *na;
  double sum = 0, count = 0;
  for (const Hindrance& one : context.hindrances) {
    if (!(one.*delay)) continue;
    sum += *(one.*delay);
    ++count;
  }
  if (count > 0) return Value::of(sum / count);
  return Value::na("nobody arrives with and without the robot, or until_arrival is 0");
}

/// People follow the movers of the scenario.
const Mover* first_person(const MetricContext& context) {
  return context.movers.data() + context.movers.size() - context.hindrances.size();
}

/// The deepest overlap (m) of two movers that are present, up to `until` (s); 0 if there is none.
double deepest_overlap(const Mover& a, const Mover& b, double until) {
  const std::vector<MoverSegment> of_a = segments_of(a, until), of_b = segments_of(b, until);
  const auto place = [](const MoverSegment& segment, double t) {
    return segment.from + segment.velocity * (t - segment.begin);
  };
  double deepest = 0;
  for (std::size_t i = 0, j = 0; i < of_a.size() && j < of_b.size();) {
    const double begin = std::max(of_a[i].begin, of_b[j].begin),
                 end = std::min(of_a[i].end, of_b[j].end);
    if (begin <= end) {
      const auto nearest = nearest_on_segment({0, 0}, place(of_a[i], begin) - place(of_b[j], begin),
                                              place(of_a[i], end) - place(of_b[j], end));
      deepest = std::max(deepest, a.radius + b.radius - nearest.norm());
    }
    ++(of_a[i].end < of_b[j].end ? i : j);
  }
  return deepest;
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

/// Time that people are behind where they would be without the robot, the mean over all.
Value people_deficit(const MetricContext& context) {
  if (const auto na = na_without_people(context)) return *na;
  double sum = 0;
  for (const Hindrance& one : context.hindrances) sum += one.deficit;
  return Value::of(sum / static_cast<double>(context.hindrances.size()));
}

/// Lateness of the arrivals of those who arrive with and without the robot, the mean.
Value people_delay(const MetricContext& context) {
  return mean_over_people(context, &Hindrance::delay);
}

/// Change of their arrivals by a start that is moved by nothing that matters, the mean.
Value people_delay_floor(const MetricContext& context) {
  return mean_over_people(context, &Hindrance::delay_floor);
}

/// The deepest one of two people. All walk straight between updates.
Value people_overlap(const MetricContext& context) {
  if (const auto na = na_without_people(context)) return *na;
  const double end = run_time(context, context.trajectory.samples.back());
  double deepest = 0;
  for (const Mover* a = first_person(context); a != context.movers.data() + context.movers.size();
       ++a)
    for (const Mover* b = first_person(context); b != a; ++b)
      deepest = std::max(deepest, deepest_overlap(*a, *b, end));
  return Value::of(deepest);
}

/// 1 if the person had noticed the robot: by Crowd such a contact is the robot's doing.
Value contact_blame(const MetricContext& context) {
  if (const auto na = na_without_people(context)) return *na;
  if (context.outcome != Outcome::Collision)
    return Value::na("outcome: " + to_string(context.outcome));
  const Mover* mover = touched_mover(context);
  const Mover* people = first_person(context);
  if (mover == nullptr || mover < people) return Value::na("no contact with a person");
  return Value::of(context.hindrances[static_cast<std::size_t>(mover - people)].is_noticed ? 1 : 0);
}

}  // namespace metrics
}  // namespace slalom
