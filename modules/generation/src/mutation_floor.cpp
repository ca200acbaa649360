#include "scene.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace slalom {
namespace {

/// Changes the room that a scene has.
class FloorMutator {
 public:
  FloorMutator(Scene& scene, const MutationLimits& limits, RandomEngine& engine)
      : scene_(scene), limits_(limits), engine_(engine) {}

  bool apply(Mutation mutation) {
    switch (mutation) {
      case Mutation::Frame:
        return frame();
      case Mutation::ScaleFloor:
        return scale_floor();
      case Mutation::ExtendFloor:
        return extend_floor();
      case Mutation::CropFloor:
        return crop_floor();
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
    const double share = uniform(0, 1);
    const auto thickness = [&](double room) {
      return std::max(0.0, (room - berth(limits_)) * std::min(1.0, share + uniform(-0.2, 0.2)));
    };
    const double x0 = b.x_min + thickness(left - b.x_min),
                 x1 = b.x_max - thickness(b.x_max - right);
    const double y0 = b.y_min + thickness(low - b.y_min), y1 = b.y_max - thickness(b.y_max - high);
    for (const auto& [xa, ya, xb, yb] :
         {std::array{b.x_min, b.y_min, x0, b.y_max}, std::array{x1, b.y_min, b.x_max, b.y_max},
          std::array{x0, b.y_min, x1, y0}, std::array{x0, y1, x1, b.y_max}})
      if (xb - xa > limits_.resolution && yb - ya > limits_.resolution)
        scene_.obstacles.emplace_back(make_block(xa, ya, xb, yb));
    return true;
  }

  bool scale_floor() {
    const double longest = std::max(scene_.bounds.width(), scene_.bounds.height());
    const double least = limits_.min_floor / shorter_side(scene_),
                 most = limits_.max_floor / longest;
    if (least >= most) return false;
    const double factor = std::clamp(std::exp(normal(engine_, 0, uniform(0.05, 0.8))), least, most);
    for (Scene::Obstacle& obstacle : scene_.obstacles) stretch(obstacle, factor);
    Bounds& b = scene_.bounds;
    b = {b.x_min * factor, b.y_min * factor, b.x_max * factor, b.y_max * factor};
    scene_.start = {scene_.start.x * factor, scene_.start.y * factor, scene_.start.phi};
    scene_.goal = scene_.goal * factor;
    return true;
  }

  bool extend_floor() {
    Bounds& b = scene_.bounds;
    const double dx = limits_.max_floor - b.width(), dy = limits_.max_floor - b.height();
    if (dx <= 0 && dy <= 0) return false;
    const double more = uniform(0, 1) * uniform(0, 1);
    const double wider = std::max(0.0, dx) * more, higher = std::max(0.0, dy) * more;
    const double left = uniform(0, wider), below = uniform(0, higher);
    b = {b.x_min - left, b.y_min - below, b.x_max + wider - left, b.y_max + higher - below};
    return true;
  }

  bool crop_floor() {
    Bounds& b = scene_.bounds;
    const auto [left, right] = std::minmax(scene_.start.x, scene_.goal.x);
    const auto [low, high] = std::minmax(scene_.start.y, scene_.goal.y);
    const double most = uniform(0, 1);
    const auto cut = [&](double room) {
      return std::max(0.0, room - berth(limits_)) * uniform(0, most);
    };
    const Bounds cropped = {b.x_min + cut(left - b.x_min), b.y_min + cut(low - b.y_min),
                            b.x_max - cut(b.x_max - right), b.y_max - cut(b.y_max - high)};
    if (std::min(cropped.width(), cropped.height()) < limits_.min_floor) return false;
    b = cropped;
    scene_.drop_if(
        [&](const Scene::Obstacle& obstacle) { return !b.contains(center_of(obstacle)); });
    return true;
  }

  Scene& scene_;
  const MutationLimits& limits_;
  RandomEngine& engine_;
};

}  // namespace

bool mutate_floor(Scene& scene, Mutation mutation, const MutationLimits& limits,
                  RandomEngine& engine) {
  return FloorMutator(scene, limits, engine).apply(mutation);
}

}  // namespace slalom
