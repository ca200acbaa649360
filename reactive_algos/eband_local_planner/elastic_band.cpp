// SPDX-License-Identifier: BSD-3-Clause
#include "common/cost_to_go.h"
#include "eband_local_planner/elastic_band.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>

namespace eband_local_planner {

using namespace reactive;

namespace {

Point sum(const Point& a, const Point& b, double factor = 1) {
  return {a.x + factor * b.x, a.y + factor * b.y};
}

double dot(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y;
}

}  // namespace

double max_radius(const BandParameters& parameters) {
  return slalom::math::log(252) / parameters.costmap_weight;
}

/// B(b) = {q: |q - b| < rho(b)}. A costmap of ROS holds the distance to obstacles as its
/// exponential, in integers up to 252 and within the inflation radius: beyond, it counts as that of
/// cost 1.
Bubble ElasticBand::bubble_at(const Point& center) const {
  const double clearance = map_.at(center), maximum = max_radius(parameters_);
  if (clearance >= std::max(parameters_.inflation_radius, clearance_)) return {center, maximum};
  return {center, std::clamp(clearance - clearance_, 0.0, maximum)};
}

bool ElasticBand::is_tiny(const Bubble& bubble) const {
  return bubble.radius <= parameters_.eband_tiny_bubble_expansion;
}

/// Bubbles that are larger than the free space, beyond the inflation radius, do not guarantee that
/// the line between their centers is free.
bool ElasticBand::overlap(const Bubble& a, const Bubble& b) const {
  return distance(a.center, b.center) <
             parameters_.eband_min_relative_overlap * (a.radius + b.radius) &&
         line_is_free(map_, a.center, b.center, clearance_);
}

/// Appends bubbles that connect `a` and `b`. Returns false if there is an obstacle between them.
bool ElasticBand::fill(const Bubble& a, const Bubble& b, std::vector<Bubble>& filled) const {
  if (overlap(a, b)) return true;
  const Bubble middle =
      bubble_at({0.5 * (a.center.x + b.center.x), 0.5 * (a.center.y + b.center.y)});
  if (is_tiny(middle) || !fill(a, middle, filled)) return false;
  filled.push_back(middle);
  return fill(middle, b, filled);
}

/// Fills gaps and removes bubbles whose neighbors overlap. Returns false if a gap stays.
bool ElasticBand::refine() {
  std::vector<Bubble> filled{bubbles_.front()};
  for (std::size_t i = 1; i < bubbles_.size(); ++i) {
    if (!fill(bubbles_[i - 1], bubbles_[i], filled)) return false;
    filled.push_back(bubbles_[i]);
  }
  bubbles_.assign(1, filled.front());
  for (std::size_t i = 1; i < filled.size(); ++i)
    if (i + 1 == filled.size() || !overlap(bubbles_.back(), filled[i + 1]))
      bubbles_.push_back(filled[i]);
  return true;
}

/// One of the two terms of the contraction force: neighbors pull equally at any distance, so that
/// the tension along the band is uniform.
Point ElasticBand::contraction(const Bubble& bubble, const Bubble& neighbor) const {
  const double length = distance(bubble.center, neighbor.center);
  if (length <= parameters_.eband_tiny_bubble_distance) return {};
  return sum({}, sum(neighbor.center, bubble.center, -1),
             parameters_.eband_internal_force_gain / length);
}

/// k_r times the gradient of rho by differences over h = rho(b), as in the paper. Like
/// eband_local_planner, and unlike the paper, not scaled with rho_0 - rho: it fades where the
/// bubbles reach their maximum radius.
Point ElasticBand::repulsion(const Bubble& bubble) const {
  const double h = std::max(bubble.radius, parameters_.eband_tiny_bubble_expansion);
  const auto radius = [&](double dx, double dy) {
    return bubble_at({bubble.center.x + dx, bubble.center.y + dy}).radius;
  };
  return sum({}, {radius(h, 0) - radius(-h, 0), radius(0, h) - radius(0, -h)},
             parameters_.eband_external_force_gain / (2 * h));
}

/// The force on `bubble` in the place of the i-th one, without its component along the band, which
/// would move bubbles to each other.
Point ElasticBand::force_at(std::size_t i, const Bubble& bubble) const {
  const Bubble &before = bubbles_[i - 1], &after = bubbles_[i + 1];
  const Point total =
      sum(sum(contraction(bubble, before), contraction(bubble, after)), repulsion(bubble));
  const Point along = sum(before.center, after.center, -1);
  const double squared = dot(along, along);
  return squared > 0 ? sum(total, along, -dot(total, along) / squared) : total;
}

/// b_new = b_old + alpha f with alpha = rho(b_old), so that a bubble stays within its free space;
/// with shorter steps if it passes its equilibrium by far.
void ElasticBand::move(std::size_t i) {
  const Point force = this->force(i);
  Bubble moved = bubble_at(sum(bubbles_[i].center, force, bubbles_[i].radius));
  if (is_tiny(moved)) return;
  const Point next = force_at(i, moved);
  const double limit =
      std::max(parameters_.eband_equilibrium_relative_overshoot * std::sqrt(dot(force, force)),
               parameters_.eband_significant_force_lower_bound);
  if (dot(next, force) < 0 && dot(next, next) > limit * limit) moved = equilibrium(i, force);
  std::vector<Bubble> unused;
  if (fill(bubbles_[i - 1], moved, unused) && fill(moved, bubbles_[i + 1], unused))
    bubbles_[i] = moved;
}

/// The bubble where the force changes its direction, by steps that are halved each time.
Bubble ElasticBand::equilibrium(std::size_t i, const Point& force) const {
  Bubble result = bubbles_[i];
  Point previous = force, step = sum({}, force, 0.5 * result.radius);
  for (int depth = 0; depth <= parameters_.eband_equilibrium_approx_max_recursion_depth; ++depth) {
    const Bubble tried = bubble_at(sum(result.center, step));
    if (is_tiny(tried)) break;
    result = tried;
    const Point next = force_at(i, tried);
    step = sum({}, step, dot(next, previous) < 0 ? -0.5 : 0.5);
    previous = next;
  }
  return result;
}

/// Returns false, with an empty band, if there is no band without bubbles in collision.
bool ElasticBand::optimize() {
  bubbles_.erase(std::remove_if(bubbles_.begin() + 1, bubbles_.end(),
                                [&](const Bubble& bubble) { return is_tiny(bubble); }),
                 bubbles_.end());
  bool connected = bubbles_.size() > 1 && refine();
  for (int k = 0; connected && k < parameters_.num_iterations_eband_optimization; ++k) {
    for (std::size_t i = 1; i + 1 < bubbles_.size(); ++i) move(i);
    for (std::size_t i = bubbles_.size() - 1; i-- > 1;) move(i);
    connected = refine();
  }
  if (!connected) bubbles_.clear();
  return connected;
}

/// A robot that is too close to an obstacle has a bubble all the same, if it does not touch it.
void ElasticBand::limit_clearance(const Point& robot) {
  const double here = map_.at(robot) - 2 * parameters_.eband_tiny_bubble_expansion;
  clearance_ = std::max(robot_radius_, std::min(clearance_, here));
}

bool ElasticBand::set_path(const std::vector<Point>& path, double clearance) {
  bubbles_.clear();
  if (path.empty()) return false;
  clearance_ = clearance;
  limit_clearance(path.front());
  for (const Point& p : path) bubbles_.push_back(bubble_at(p));
  return optimize();
}

bool ElasticBand::update(const Point& robot) {
  if (bubbles_.empty()) return false;
  limit_clearance(robot);
  for (Bubble& bubble : bubbles_) bubble = bubble_at(bubble.center);
  const Bubble here = bubble_at(robot);
  const auto connected = std::find_if(bubbles_.rbegin(), bubbles_.rend() - 1,
                                      [&](const Bubble& bubble) { return overlap(here, bubble); });
  bubbles_.erase(bubbles_.begin(), connected.base() - 1);
  bubbles_.insert(bubbles_.begin(), here);
  return optimize();
}

}  // namespace eband_local_planner
