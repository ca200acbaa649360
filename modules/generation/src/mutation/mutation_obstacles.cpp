// SPDX-License-Identifier: BSD-3-Clause
#include "scene_mutation.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// Changes the obstacles of a scene.
class ObstacleMutator {
 public:
  ObstacleMutator(Scene& scene, const MutationLimits& limits, RandomEngine& engine)
      : scene_(scene), limits_(limits), engine_(engine) {}

  bool apply(Mutation mutation) {
    switch (mutation) {
      case Mutation::Add:
        return add();
      case Mutation::Remove:
        return remove();
      case Mutation::Move:
        return move();
      case Mutation::Resize:
        return resize();
      case Mutation::ResizeAll:
        return resize_all();
      case Mutation::Duplicate:
        return duplicate();
      default:
        return false;
    }
  }

 private:
  double uniform(double low, double high) { return uniform_real(engine_, low, high); }

  /// Calls `change` with a random fraction of the obstacles, at least one.
  template <typename Change>
  bool change_some(Change change) {
    if (scene_.obstacles.empty()) return false;
    const double fraction = sample_log_uniform(engine_, 0.02, 1);
    const int last = static_cast<int>(scene_.obstacles.size()) - 1;
    change(scene_.obstacles[static_cast<std::size_t>(uniform_int(engine_, 0, last))]);
    const std::size_t count = scene_.obstacles.size();  // obstacles added meanwhile are unchanged
    for (std::size_t i = 0; i < count; ++i)
      if (uniform(0, 1) < fraction) change(scene_.obstacles[i]);
    return true;
  }

  bool add() {
    const int count = 1 << uniform_int(engine_, 0, 5);
    const double largest =
        sample_log_uniform(engine_, 2 * limits_.resolution, shorter_side(scene_) / 4);
    for (int i = 0; i < count; ++i) {
      const TPoint2D center{uniform(scene_.bounds.x_min, scene_.bounds.x_max),
                            uniform(scene_.bounds.y_min, scene_.bounds.y_max)};  // x is drawn first
      const double size = uniform(largest / 3, largest);
      if (uniform_int(engine_, 0, 1) == 0)
        scene_.obstacles.emplace_back(Disc{center, size});
      else
        scene_.obstacles.emplace_back(draw_polygon(center, size));
    }
    return true;
  }

  /// Convex, with vertices on an ellipse: from a slab to a regular polygon.
  Polygon draw_polygon(const TPoint2D& center, double size) {
    const int corners = uniform_int(engine_, 3, 6);
    const double turn = uniform(0, M_PI), flat = uniform(0.1, 1);
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * M_PI * (i + uniform(-0.2, 0.2)) / corners;
      const double x = size * math::cos(angle), y = flat * size * math::sin(angle);
      polygon.vertices.emplace_back(center.x + x * math::cos(turn) - y * math::sin(turn),
                                    center.y + x * math::sin(turn) + y * math::cos(turn));
    }
    return polygon;
  }

  bool remove() {
    if (scene_.obstacles.empty()) return false;
    const double fraction = sample_log_uniform(engine_, 0.02, 1);
    const int last = static_cast<int>(scene_.obstacles.size()) - 1;
    scene_.obstacles.erase(scene_.obstacles.begin() + uniform_int(engine_, 0, last));
    scene_.remove_if([&](const Scene::Obstacle&) { return uniform(0, 1) < fraction; });
    return true;
  }

  bool move() {
    const double sigma = sample_log_uniform(engine_, limits_.resolution, shorter_side(scene_) / 3);
    return change_some([&](Scene::Obstacle& obstacle) {
      const double dx = normal(engine_, 0, sigma), dy = normal(engine_, 0, sigma);
      translate(obstacle, dx, dy);
    });
  }

  bool resize() {
    const double sigma = uniform(0.05, 0.7);
    return change_some([&](Scene::Obstacle& obstacle) {
      scale_within(obstacle, math::exp(normal(engine_, 0, sigma)));
    });
  }

  bool resize_all() {
    if (scene_.obstacles.empty()) return false;
    const double factor = math::exp(normal(engine_, 0, uniform(0.05, 0.7)));
    for (Scene::Obstacle& obstacle : scene_.obstacles) scale_within(obstacle, factor);
    return true;
  }

  /// Scales unless the result is below a minimum size or larger than any workspace.
  void scale_within(Scene::Obstacle& obstacle, double factor) {
    constexpr double kMinSize = 0.02;  // m
    Scene::Obstacle changed = obstacle;
    scale(changed, factor);
    const Disc* disc = std::get_if<Disc>(&changed);
    const double size = disc != nullptr
                            ? disc->radius
                            : std::sqrt(std::abs(signed_area(std::get<Polygon>(changed))));
    if (size >= kMinSize && size <= limits_.max_extent) obstacle = changed;
  }

  bool duplicate() {
    const double reach = sample_log_uniform(engine_, 4 * limits_.resolution, shorter_side(scene_));
    std::vector<Scene::Obstacle> copies;
    if (!change_some([&](Scene::Obstacle& obstacle) {
          copies.push_back(obstacle);
          const double dx = uniform(-reach, reach), dy = uniform(-reach, reach);
          translate(copies.back(), dx, dy);
        }))
      return false;
    scene_.obstacles.insert(scene_.obstacles.end(), copies.begin(), copies.end());
    return true;
  }

  Scene& scene_;
  const MutationLimits& limits_;
  RandomEngine& engine_;
};

}  // namespace

bool mutate_obstacles(Scene& scene, Mutation mutation, const MutationLimits& limits,
                      RandomEngine& engine) {
  return ObstacleMutator(scene, limits, engine).apply(mutation);
}

}  // namespace slalom
