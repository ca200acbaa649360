// SPDX-License-Identifier: BSD-3-Clause
#include "scene_mutation.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace slalom {
namespace {

/// Changes the workspace of a scene.
class WorkspaceMutator {
 public:
  WorkspaceMutator(Scene& scene, const MutationLimits& limits, RandomEngine& engine)
      : scene_(scene), limits_(limits), engine_(engine) {}

  bool apply(Mutation mutation) {
    switch (mutation) {
      case Mutation::Frame:
        return frame();
      case Mutation::ScaleWorkspace:
        return scale_workspace();
      case Mutation::ExtendWorkspace:
        return extend_workspace();
      case Mutation::CropWorkspace:
        return crop_workspace();
      default:
        return false;
    }
  }

 private:
  double uniform(double low, double high) { return uniform_real(engine_, low, high); }

  bool frame() {
    const Bounds b = scene_.bounds;
    const auto [left, right] = std::minmax(scene_.start.x, scene_.goal.x);
    const auto [low, high] = std::minmax(scene_.start.y, scene_.goal.y);
    const double fraction = uniform(0, 1);
    const auto thickness = [&](double space) {
      return std::max(
          0.0, (space - clearance_margin(limits_)) * std::min(1.0, fraction + uniform(-0.2, 0.2)));
    };
    const double x0 = b.x_min + thickness(left - b.x_min),
                 x1 = b.x_max - thickness(b.x_max - right);
    const double y0 = b.y_min + thickness(low - b.y_min), y1 = b.y_max - thickness(b.y_max - high);
    for (const auto& [xa, ya, xb, yb] :
         {std::array{b.x_min, b.y_min, x0, b.y_max}, std::array{x1, b.y_min, b.x_max, b.y_max},
          std::array{x0, b.y_min, x1, y0}, std::array{x0, y1, x1, b.y_max}})
      if (xb - xa > limits_.resolution && yb - ya > limits_.resolution)
        scene_.obstacles.emplace_back(rectangle(xa, ya, xb, yb));
    return true;
  }

  bool scale_workspace() {
    const double longest = std::max(scene_.bounds.width(), scene_.bounds.height());
    const double min_factor = limits_.min_extent / shorter_side(scene_),
                 max_factor = limits_.max_extent / longest;
    if (min_factor >= max_factor) return false;
    const double factor =
        std::clamp(math::exp(normal(engine_, 0, uniform(0.05, 0.8))), min_factor, max_factor);
    for (Scene::Obstacle& obstacle : scene_.obstacles) scale_about_origin(obstacle, factor);
    Bounds& b = scene_.bounds;
    b = {b.x_min * factor, b.y_min * factor, b.x_max * factor, b.y_max * factor};
    scene_.start = {scene_.start.x * factor, scene_.start.y * factor, scene_.start.phi};
    scene_.goal = scene_.goal * factor;
    return true;
  }

  bool extend_workspace() {
    Bounds& b = scene_.bounds;
    const double dx = limits_.max_extent - b.width(), dy = limits_.max_extent - b.height();
    if (dx <= 0 && dy <= 0) return false;
    const double fraction = uniform(0, 1) * uniform(0, 1);
    const double wider = std::max(0.0, dx) * fraction, higher = std::max(0.0, dy) * fraction;
    const double left = uniform(0, wider), below = uniform(0, higher);
    b = {b.x_min - left, b.y_min - below, b.x_max + wider - left, b.y_max + higher - below};
    return true;
  }

  bool crop_workspace() {
    Bounds& b = scene_.bounds;
    const auto [left, right] = std::minmax(scene_.start.x, scene_.goal.x);
    const auto [low, high] = std::minmax(scene_.start.y, scene_.goal.y);
    const double max_fraction = uniform(0, 1);
    const auto cut = [&](double space) {
      return std::max(0.0, space - clearance_margin(limits_)) * uniform(0, max_fraction);
    };
    const Bounds cropped = {b.x_min + cut(left - b.x_min), b.y_min + cut(low - b.y_min),
                            b.x_max - cut(b.x_max - right), b.y_max - cut(b.y_max - high)};
    if (std::min(cropped.width(), cropped.height()) < limits_.min_extent) return false;
    b = cropped;
    scene_.remove_if(
        [&](const Scene::Obstacle& obstacle) { return !b.contains(center_of(obstacle)); });
    return true;
  }

  Scene& scene_;
  const MutationLimits& limits_;
  RandomEngine& engine_;
};

}  // namespace

bool mutate_workspace(Scene& scene, Mutation mutation, const MutationLimits& limits,
                      RandomEngine& engine) {
  return WorkspaceMutator(scene, limits, engine).apply(mutation);
}

}  // namespace slalom
