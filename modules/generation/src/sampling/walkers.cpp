// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/distance.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/generation/moving.h>
#include <slalom/generation/start_goal.h>
#include <slalom/generation/walkers.h>

#include <string>
#include <vector>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr int kSegments = 6, kStarts = 200, kTargets = 30;
constexpr double kStartMargin = 1, kMinSegment = 0.5;  // m

/// Samples the paths of walkers that keep `clearance` (m) from obstacles with their centers.
class PathSampler {
 public:
  PathSampler(const World& world, double clearance, RandomEngine& engine)
      : world_(world), clearance_(clearance), engine_(engine) {}

  /// The positions of a path that begins at least `start_distance` (m) from the start of the robot;
  /// fewer than two if there is none.
  std::vector<TPoint2D> sample(double start_distance) {
    const auto& start = world_.scenario().start();
    for (int i = 0; i < kStarts; ++i) {
      std::vector<TPoint2D> path = {sample_position(engine_, world_.scenario().bounds())};
      if (distance_between(path[0], TPoint2D(start.x, start.y)) < start_distance) continue;
      if (world_.distance_field().clearance(path[0]) < clearance_) continue;
      while (path.size() <= kSegments && add_segment(path)) continue;
      if (path.size() > 1) return path;
    }
    return {};
  }

 private:
  bool add_segment(std::vector<TPoint2D>& path) {
    for (int i = 0; i < kTargets; ++i) {
      const TPoint2D target = sample_position(engine_, world_.scenario().bounds());
      if (distance_between(path.back(), target) < kMinSegment) continue;
      const double limit = 2 * clearance_;
      if (world_.distance_field().segment_clearance(path.back(), target, limit) < clearance_)
        continue;
      path.push_back(target);
      return true;
    }
    return false;
  }

  const World& world_;
  double clearance_;
  RandomEngine& engine_;
};

/// The path there and back.
std::vector<TPoint2D> to_and_fro(std::vector<TPoint2D> path) {
  const std::vector<TPoint2D> back(std::next(path.rbegin()), path.rend());
  path.insert(path.end(), back.begin(), back.end());
  return path;
}

}  // namespace

Movers sample_walkers(const World& world, double robot_radius, const WalkerOptions& options,
                      RandomEngine& engine) {
  Movers walkers;
  for (int i = 0; i < options.count; ++i) {
    const double radius = uniform_real(engine, options.min_radius, options.max_radius);
    const double speed = uniform_real(engine, options.min_speed, options.max_speed);
    PathSampler sampler(world, radius + kWallMargin, engine);
    const std::vector<TPoint2D> path = sampler.sample(radius + robot_radius + kStartMargin);
    if (path.empty())
      throw job_error(world.scenario().name(),
                      "no path for a walker of radius " + format_fixed(radius, 2) + " m",
                      "smaller walkers, or fewer obstacles");
    walkers.push_back({"walker_" + std::to_string(i), radius, walk_along(to_and_fro(path), speed),
                       MoverEnd::Loop});
  }
  return walkers;
}

Scenario with_walkers(const World& world, double robot_radius, const WalkerOptions& options,
                      RandomEngine& engine) {
  Movers movers = world.scenario().movers();
  for (Mover& walker : sample_walkers(world, robot_radius, options, engine))
    movers.push_back(std::move(walker));
  return world.scenario().with_movers(std::move(movers));
}

}  // namespace slalom
