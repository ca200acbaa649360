// SPDX-License-Identifier: BSD-3-Clause
#include "common.h"
#include "mover_encounters.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

void visit_interval(const MetricContext& context, const Mover& mover, const Sample& first,
                    const Sample& second, const std::function<void(const Encounter&)>& visit) {
  const double begin = run_time(context, first), end = run_time(context, second);
  const TPoint2D at_begin(first.pose),
      velocity = (TPoint2D(second.pose) - at_begin) * (1 / (end - begin));
  for (double t = begin; t < end;) {
    const double next = std::min(mover.next_change(t), end);
    if (mover.present(0.5 * (t + next))) {
      const TPoint2D from = at_begin + velocity * (t - begin) - mover.position(t);
      const TPoint2D to = at_begin + velocity * (next - begin) - mover.position(next);
      visit({t, next, from, to - from, reach_of(context, mover)});
    }
    t = next;
  }
}

}  // namespace

std::optional<Value> na_without_movers(const MetricContext& context) {
  if (const auto na = na_without_samples(context)) return na;
  if (!context.movers.empty()) return std::nullopt;
  return Value::na("no moving obstacles");
}

double run_time(const MetricContext& context, const Sample& sample) {
  return sample.t - context.trajectory.samples.front().t;
}

double reach_of(const MetricContext& context, const Mover& mover) {
  return mover.radius + context.robot.shape().enclosing_radius();
}

void for_each_encounter(const MetricContext& context,
                        const std::function<void(const Encounter&)>& visit) {
  const auto& samples = context.trajectory.samples;
  for (const Mover& mover : context.movers)
    for (std::size_t i = 1; i < samples.size(); ++i)
      visit_interval(context, mover, samples[i - 1], samples[i], visit);
}

double smallest_gap(const Encounter& e) {
  const double a = e.movement.x * e.movement.x + e.movement.y * e.movement.y;
  const double b = e.from.x * e.movement.x + e.from.y * e.movement.y;
  const TPoint2D nearest = e.from + e.movement * (a > 0 ? std::clamp(-b / a, 0.0, 1.0) : 0.0);
  return math::hypot(nearest.x, nearest.y) - e.reach;
}

}  // namespace slalom
