// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/math.h>
#include <slalom/core/random.h>
#include <slalom/falsification/candidates.h>
#include <slalom/generation/scene.h>

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// A rectangle (m) with its longer side in direction `angle` (rad).
Polygon bar(const TPoint2D& center, double length, double thickness, double angle) {
  const TPoint2D along(math::cos(angle) * length / 2, math::sin(angle) * length / 2);
  const TPoint2D across(-math::sin(angle) * thickness / 2, math::cos(angle) * thickness / 2);
  return {{center - along - across, center + along - across, center + along + across,
           center - along + across}};
}

class MicroWorld {
 public:
  MicroWorld(RandomEngine& engine, double scale) : engine_(engine), scale_(scale) {}

  Scenario draw() {
    draw_task();
    Primitives obstacles;
    for (int left = uniform_int(engine_, 1, 6); left > 0; --left) add_obstacle(obstacles, left);
    const double side = kSide * scale_;
    return Scenario::continuous("micro", {0, 0, side, side}, std::move(obstacles), start_, goal_);
  }

 private:
  static constexpr double kSide = 6;  // m

  double length(double low, double high) { return scale_ * uniform_real(engine_, low, high); }

  void draw_task() {
    const double direction = uniform_real(engine_, -M_PI, M_PI), distance = length(3, 4.6);
    const TPoint2D center(scale_ * kSide / 2, scale_ * kSide / 2);
    const TPoint2D half(math::cos(direction) * distance / 2, math::sin(direction) * distance / 2);
    start_ = {center.x - half.x, center.y - half.y,
              direction + uniform_real(engine_, -M_PI / 4, M_PI / 4)};
    goal_ = center + half;
  }

  /// Around the task, up to 1.2 m beside it.
  TPoint2D draw_center() {
    const double part = uniform_real(engine_, 0, 1);
    const TPoint2D from(start_.x, start_.y);
    const TPoint2D on_task = from + (goal_ - from) * part;
    const double dx = length(-1.2, 1.2);
    return on_task + TPoint2D(dx, length(-1.2, 1.2));
  }

  void add_obstacle(Primitives& obstacles, int& left) {
    const TPoint2D center = draw_center();
    const int kind = uniform_int(engine_, 0, 3);
    if (kind < 2) {
      const double log_radius = uniform_real(engine_, math::log(0.03), math::log(0.5));
      obstacles.discs.push_back({center, scale_ * math::exp(log_radius)});
      return;
    }
    const double long_side = length(0.4, 2), thickness = length(0.06, 0.3);
    const double angle = uniform_real(engine_, 0, M_PI);
    obstacles.polygons.push_back(bar(center, long_side, thickness, angle));
    if (kind == 2 || left < 2) return;
    --left;
    const double gap = thickness + length(0.7, 1.4);
    const TPoint2D beside = center + TPoint2D(-math::sin(angle) * gap, math::cos(angle) * gap);
    obstacles.polygons.push_back(bar(beside, long_side, thickness, angle));
  }

  RandomEngine& engine_;
  double scale_;
  mrpt::math::TPose2D start_;
  TPoint2D goal_;
};

}  // namespace

Scenario draw_micro_world(RandomEngine& engine, double scale) {
  return MicroWorld(engine, scale).draw();
}

}  // namespace slalom
