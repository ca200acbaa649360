// SPDX-License-Identifier: BSD-3-Clause
#include "scene_mutation.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// Clears a corridor from start to goal, or fills the rest of the workspace.
class CorridorMutator {
 public:
  CorridorMutator(Scene& scene, const MutationLimits& limits, RandomEngine& engine)
      : scene_(scene), limits_(limits), engine_(engine) {}

  bool apply(Mutation mutation) {
    switch (mutation) {
      case Mutation::Carve:
        return carve();
      case Mutation::Fill:
        return fill();
      default:
        return false;
    }
  }

 private:
  double uniform(double low, double high) { return uniform_real(engine_, low, high); }

  bool carve() {
    if (scene_.obstacles.empty()) return false;
    const auto path = sample_path(scene_.bounds, scene_.start, scene_.goal, engine_);
    const double margin = clearance_margin(limits_);
    const double half =
        sample_log_uniform(engine_, margin, std::max(margin, shorter_side(scene_) / 4));
    scene_.remove_if([&](const Scene::Obstacle& obstacle) { return gap(path, obstacle) < half; });
    return true;
  }

  /// Distance from a path to an obstacle, sampled every 0.1 m.
  static double gap(const std::vector<TPoint2D>& path, const Scene::Obstacle& obstacle) {
    double min_gap = distance(path.front(), obstacle);
    for (std::size_t i = 1; i < path.size(); ++i) {
      const TPoint2D step = path[i] - path[i - 1];
      const double pieces = std::ceil(math::hypot(step.x, step.y) / 0.1);
      for (double k = 1; k <= pieces; ++k)
        min_gap = std::min(min_gap, distance(path[i - 1] + step * (k / pieces), obstacle));
    }
    return min_gap;
  }

  bool fill() {
    const auto path = sample_path(scene_.bounds, scene_.start, scene_.goal, engine_);
    const double pitch =
        sample_log_uniform(engine_, std::max(2 * limits_.resolution, shorter_side(scene_) / 80),
                           shorter_side(scene_) / 6);
    const double margin = clearance_margin(limits_);
    const double half =
        sample_log_uniform(engine_, margin, std::max(margin, shorter_side(scene_) / 3));
    const double fraction = uniform_int(engine_, 0, 1) == 0 ? 1 : uniform(0.1, 1);
    if (uniform_int(engine_, 0, 2) > 0) scene_.obstacles.clear();
    const Bounds& b = scene_.bounds;
    for (double y = b.y_min; y < b.y_max; y += pitch) {
      double from = b.x_min, x = b.x_min;
      for (; x < b.x_max; x += pitch) {
        const bool outside =
            distance({x + pitch / 2, y + pitch / 2}, path) >= half + pitch / std::sqrt(2.0);
        if (outside && uniform(0, 1) < fraction) continue;
        add_run(from, x, y, pitch);
        from = x + pitch;
      }
      add_run(from, x, y, pitch);
    }
    return true;
  }

  void add_run(double from, double to, double y, double pitch) {
    const Bounds& b = scene_.bounds;
    to = std::min(to, b.x_max);
    if (to - from < pitch / 2) return;
    scene_.obstacles.emplace_back(rectangle(from, y, to, std::min(y + pitch, b.y_max)));
  }

  Scene& scene_;
  const MutationLimits& limits_;
  RandomEngine& engine_;
};

}  // namespace

bool mutate_along_path(Scene& scene, Mutation mutation, const MutationLimits& limits,
                       RandomEngine& engine) {
  return CorridorMutator(scene, limits, engine).apply(mutation);
}

}  // namespace slalom
