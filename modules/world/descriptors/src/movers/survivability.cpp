// SPDX-License-Identifier: BSD-3-Clause
#include "../sample_lattice.h"
#include "horizon.h"

#include <slalom/descriptors/descriptor.h>
#include <slalom/scenario/contact.h>

#include <algorithm>

namespace slalom::descriptors {
namespace {

using mrpt::math::TPoint2D;

/// The first time (s) in the segment at which its mover touches a robot that stands at p; the
/// horizon if it does not.
double contact_time(const MoverSegment& segment, const TPoint2D& p, double reach) {
  const double duration = segment.end - segment.begin;
  const auto within = range_within(segment.from - p, segment.velocity * duration, reach);
  if (!within || within->second <= 0 || within->first >= 1) return kMoverHorizon;
  return segment.begin + std::max(0.0, within->first) * duration;
}

double survival_time(const std::vector<std::vector<MoverSegment>>& motions,
                     const std::vector<double>& reaches, const TPoint2D& p) {
  double time = kMoverHorizon;
  for (std::size_t i = 0; i < motions.size(); ++i)
    for (const MoverSegment& segment : motions[i]) {
      if (segment.begin >= time) break;
      time = std::min(time, contact_time(segment, p, reaches[i]));
    }
  return time;
}

}  // namespace

/// Mean over the lattice points where the robot fits of the time that it could stand there before a
/// mover touches it, up to 12 s. After Shi et al., "Evaluating Dynamic Environment Difficulty for
/// Obstacle Avoidance Benchmarking", 2024.
Value survivability(const DescriptorContext& context) {
  const Movers& movers = context.world.scenario().movers();
  if (movers.empty()) return Value::na(kNoMovers);
  std::vector<std::vector<MoverSegment>> motions;
  std::vector<double> reaches;
  for (const Mover& mover : movers) {
    motions.push_back(segments_of(mover, kMoverHorizon));
    reaches.push_back(mover.radius + context.robot_radius());
  }
  double sum = 0;
  std::size_t count = 0;
  for (const TPoint2D& point : lattice_points(context.world.occupancy())) {
    if (context.world.distance_field().clearance(point) <
        context.robot_radius() - kContactTolerance)
      continue;
    sum += survival_time(motions, reaches, point);
    ++count;
  }
  if (count == 0) return Value::na("the robot fits at no lattice point");
  return Value::of(sum / static_cast<double>(count));
}

}  // namespace slalom::descriptors
