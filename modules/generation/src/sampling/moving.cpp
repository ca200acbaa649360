// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/distance.h>
#include <slalom/generation/moving.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// Whether no segment is so short that its time would not be that of the speed.
bool has_long_segments(const std::vector<Waypoint>& walk) {
  constexpr double kShortest = 10 * kMinSegmentDuration;
  for (std::size_t i = 1; i < walk.size(); ++i)
    if (walk[i].t - walk[i - 1].t < kShortest) return false;
  return walk.size() > 1;
}

}  // namespace

std::vector<Waypoint> walk_along(const std::vector<TPoint2D>& path, double speed, double begin) {
  Mover mover;
  for (const TPoint2D& position : path) mover.waypoints.push_back({begin, position});
  set_speed(mover, speed);
  if (begin > 0) mover.waypoints.insert(mover.waypoints.begin(), {0, path[0]});
  return mover.waypoints;
}

Movers sample_movers(RandomEngine& engine, const MoverOptions& options, MoverEnd after,
                     const TPoint2D& start, double clear_radius, const WalkSampler& sample) {
  constexpr int kTries = 60;
  const int count = uniform_int(engine, options.min_movers, options.max_movers);
  Movers movers;
  for (int i = 0; i < count; ++i) {
    const double radius = uniform_real(engine, options.min_radius, options.max_radius);
    const double speed = uniform_real(engine, options.min_speed, options.max_speed);
    for (int k = 0; k < kTries; ++k) {
      std::vector<Waypoint> walk = sample(radius, speed);
      if (!has_long_segments(walk) ||
          distance_between(walk[0].position, start) < radius + clear_radius)
        continue;
      movers.push_back({"mover_" + std::to_string(movers.size()), radius, std::move(walk), after});
      break;
    }
  }
  return movers;
}

void MoverOptions::visit(OptionVisitor& v) {
  v.option("min_movers", min_movers, "-", "minimum number of moving obstacles",
           Range::between(0, 1000));
  v.option("max_movers", max_movers, "-", "maximum number of moving obstacles",
           Range::between(0, 1000));
  v.option("min_radius", min_radius, "m", "minimum radius of a moving obstacle", Range::positive());
  v.option("max_radius", max_radius, "m", "maximum radius of a moving obstacle", Range::positive());
  v.option("min_speed", min_speed, "m/s", "minimum speed of a moving obstacle",
           Range::between(0.01, 100));
  v.option("max_speed", max_speed, "m/s", "maximum speed of a moving obstacle",
           Range::between(0.01, 100));
}

}  // namespace slalom
