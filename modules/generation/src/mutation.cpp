#include "mutation.h"
#include "scene.h"

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr double kPi = 3.14159265358979323846;

/// Changes one scene in one way; each change returns false where it does not apply.
class SceneMutator {
 public:
  SceneMutator(Scene& scene, const MutationLimits& limits, RandomEngine& engine)
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
      case Mutation::Carve:
        return carve();
      case Mutation::Fill:
        return fill();
      case Mutation::Frame:
        return frame();
      case Mutation::ScaleFloor:
        return scale_floor();
      case Mutation::ExtendFloor:
        return extend_floor();
      case Mutation::CropFloor:
        return crop_floor();
      case Mutation::MoveTask:
        break;
    }
    move_task(scene_.bounds, limits_, engine_, scene_.start, scene_.goal);
    return true;
  }

 private:
  double side() const { return std::min(scene_.bounds.width(), scene_.bounds.height()); }
  double uniform(double low, double high) { return uniform_real(engine_, low, high); }
  /// What must stay free about start, goal and ways.
  double berth() const { return limits_.robot_radius + 1.5 * limits_.resolution; }

  /// A share of the obstacles, at least one: calls `change` with each.
  template <typename Change>
  bool change_some(Change change) {
    if (scene_.obstacles.empty()) return false;
    const double share = draw_length(engine_, 0.02, 1);
    const int last = static_cast<int>(scene_.obstacles.size()) - 1;
    change(scene_.obstacles[static_cast<std::size_t>(uniform_int(engine_, 0, last))]);
    const std::size_t count = scene_.obstacles.size();  // what is added meanwhile is left alone
    for (std::size_t i = 0; i < count; ++i)
      if (uniform(0, 1) < share) change(scene_.obstacles[i]);
    return true;
  }

  bool add() {
    const int count = 1 << uniform_int(engine_, 0, 5);
    const double largest = draw_length(engine_, 2 * limits_.resolution, side() / 4);
    for (int i = 0; i < count; ++i) {
      const TPoint2D center(uniform(scene_.bounds.x_min, scene_.bounds.x_max),
                            uniform(scene_.bounds.y_min, scene_.bounds.y_max));
      const double size = uniform(largest / 3, largest);
      if (uniform_int(engine_, 0, 1) == 0)
        scene_.obstacles.emplace_back(Disc{center, size});
      else
        scene_.obstacles.emplace_back(draw_polygon(center, size));
    }
    return true;
  }

  /// Convex, its corners on an ellipse: from a slab to a regular polygon.
  Polygon draw_polygon(const TPoint2D& center, double size) {
    const int corners = uniform_int(engine_, 3, 6);
    const double turn = uniform(0, kPi), flat = uniform(0.1, 1);
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * kPi * (i + uniform(-0.2, 0.2)) / corners;
      const double x = size * std::cos(angle), y = flat * size * std::sin(angle);
      polygon.vertices.emplace_back(center.x + x * std::cos(turn) - y * std::sin(turn),
                                    center.y + x * std::sin(turn) + y * std::cos(turn));
    }
    return polygon;
  }

  bool remove() {
    if (scene_.obstacles.empty()) return false;
    const double share = draw_length(engine_, 0.02, 1);
    const int last = static_cast<int>(scene_.obstacles.size()) - 1;
    scene_.obstacles.erase(scene_.obstacles.begin() + uniform_int(engine_, 0, last));
    drop_if([&](const Scene::Obstacle&) { return uniform(0, 1) < share; });
    return true;
  }

  bool move() {
    const double sigma = draw_length(engine_, limits_.resolution, side() / 3);
    return change_some([&](Scene::Obstacle& obstacle) {
      const double dx = normal(engine_, 0, sigma), dy = normal(engine_, 0, sigma);
      translate(obstacle, dx, dy);
    });
  }

  bool resize() {
    const double sigma = uniform(0.05, 0.7);
    return change_some([&](Scene::Obstacle& obstacle) {
      scale_within(obstacle, std::exp(normal(engine_, 0, sigma)));
    });
  }

  bool resize_all() {
    if (scene_.obstacles.empty()) return false;
    const double factor = std::exp(normal(engine_, 0, uniform(0.05, 0.7)));
    for (Scene::Obstacle& obstacle : scene_.obstacles) scale_within(obstacle, factor);
    return true;
  }

  /// Neither too small to be seen nor larger than any floor.
  void scale_within(Scene::Obstacle& obstacle, double factor) {
    constexpr double kSmallest = 0.02;  // m
    Scene::Obstacle changed = obstacle;
    scale(changed, factor);
    const Disc* disc = std::get_if<Disc>(&changed);
    const double size = disc != nullptr
                            ? disc->radius
                            : std::sqrt(std::abs(signed_area(std::get<Polygon>(changed))));
    if (size >= kSmallest && size <= limits_.max_floor) obstacle = changed;
  }

  bool duplicate() {
    const double reach = draw_length(engine_, 4 * limits_.resolution, side());
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

  bool carve() {
    if (scene_.obstacles.empty()) return false;
    const auto way = draw_way(scene_.bounds, scene_.start, scene_.goal, engine_);
    const double half = draw_length(engine_, berth(), std::max(berth(), side() / 4));
    drop_if([&](const Scene::Obstacle& obstacle) { return gap(way, obstacle) < half; });
    return true;
  }

  /// Distance from a way to an obstacle, looked at every tenth of a metre.
  static double gap(const std::vector<TPoint2D>& way, const Scene::Obstacle& obstacle) {
    double least = distance(way.front(), obstacle);
    for (std::size_t i = 1; i < way.size(); ++i) {
      const TPoint2D step = way[i] - way[i - 1];
      const double pieces = std::ceil(std::hypot(step.x, step.y) / 0.1);
      for (double k = 1; k <= pieces; ++k)
        least = std::min(least, distance(way[i - 1] + step * (k / pieces), obstacle));
    }
    return least;
  }

  bool fill() {
    const auto way = draw_way(scene_.bounds, scene_.start, scene_.goal, engine_);
    const double pitch =
        draw_length(engine_, std::max(2 * limits_.resolution, side() / 80), side() / 6);
    const double half = draw_length(engine_, berth(), std::max(berth(), side() / 3));
    const double share = uniform_int(engine_, 0, 1) == 0 ? 1 : uniform(0.1, 1);
    if (uniform_int(engine_, 0, 2) > 0) scene_.obstacles.clear();
    const Bounds& b = scene_.bounds;
    for (double y = b.y_min; y < b.y_max; y += pitch) {
      double from = b.x_min, x = b.x_min;
      for (; x < b.x_max; x += pitch) {
        const bool keeps =
            distance({x + pitch / 2, y + pitch / 2}, way) >= half + pitch / std::sqrt(2.0);
        if (keeps && uniform(0, 1) < share) continue;
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
    scene_.obstacles.emplace_back(make_block(from, y, to, std::min(y + pitch, b.y_max)));
  }

  bool frame() {
    const Bounds b = scene_.bounds;
    const auto [left, right] = std::minmax(scene_.start.x, scene_.goal.x);
    const auto [low, high] = std::minmax(scene_.start.y, scene_.goal.y);
    const double share = uniform(0, 1);
    const auto thickness = [&](double room) {
      return std::max(0.0, (room - berth()) * std::min(1.0, share + uniform(-0.2, 0.2)));
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
    const double least = limits_.min_floor / side(), most = limits_.max_floor / longest;
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
    const auto cut = [&](double room) { return std::max(0.0, room - berth()) * uniform(0, most); };
    const Bounds cropped = {b.x_min + cut(left - b.x_min), b.y_min + cut(low - b.y_min),
                            b.x_max - cut(b.x_max - right), b.y_max - cut(b.y_max - high)};
    if (std::min(cropped.width(), cropped.height()) < limits_.min_floor) return false;
    b = cropped;
    drop_if([&](const Scene::Obstacle& obstacle) { return !b.contains(center_of(obstacle)); });
    return true;
  }

  template <typename Condition>
  void drop_if(Condition condition) {
    auto& obstacles = scene_.obstacles;
    obstacles.erase(std::remove_if(obstacles.begin(), obstacles.end(), condition), obstacles.end());
  }

  Scene& scene_;
  const MutationLimits& limits_;
  RandomEngine& engine_;
};

/// Start and goal as another obstacle may now stand on them.
void clear_ends(Scene& scene, const MutationLimits& limits) {
  const double berth = limits.robot_radius + 1.5 * limits.resolution;
  auto& obstacles = scene.obstacles;
  const auto too_near = [&](const Scene::Obstacle& obstacle) {
    return distance({scene.start.x, scene.start.y}, obstacle) < berth ||
           distance(scene.goal, obstacle) < berth;
  };
  obstacles.erase(std::remove_if(obstacles.begin(), obstacles.end(), too_near), obstacles.end());
}

std::optional<Scenario> mutate_scene(const Scenario& parent, Mutation mutation,
                                     const MutationLimits& limits, RandomEngine& engine) {
  Scene scene(parent);
  if (!SceneMutator(scene, limits, engine).apply(mutation)) return std::nullopt;
  clear_ends(scene, limits);
  if (scene.obstacles.size() > limits.max_obstacles) return std::nullopt;
  return scene.scenario(parent.name());
}

std::optional<Scenario> mutate_task(const Scenario& parent, const MutationLimits& limits,
                                    RandomEngine& engine) {
  mrpt::math::TPose2D start = parent.start();
  TPoint2D goal = parent.goal();
  move_task(parent.bounds(), limits, engine, start, goal);
  return parent.with_task(start, goal);
}

}  // namespace

std::optional<Scenario> mutate(const Scenario& parent, Mutation mutation,
                               const MutationLimits& limits, RandomEngine& engine) {
  std::optional<Scenario> child;
  if (parent.representation() == Representation::Continuous)
    child = mutate_scene(parent, mutation, limits, engine);
  else if (mutation == Mutation::MoveTask)
    child = mutate_task(parent, limits, engine);
  else if (parent.representation() == Representation::Grid)
    child = mutate_grid(parent, mutation, limits, engine);
  if (!child) return std::nullopt;
  const auto& start = child->start();
  const double straight = std::hypot(child->goal().x - start.x, child->goal().y - start.y);
  if (straight < limits.min_distance) return std::nullopt;
  return child;
}

}  // namespace slalom
