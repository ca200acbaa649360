// SPDX-License-Identifier: BSD-3-Clause
#include "common/rolling_memory.h"

#include <slalom/core/math.h>

#include <algorithm>

namespace reactive {

RollingMemory::RollingMemory(double half_size, double resolution)
    : half_size_(half_size),
      resolution_(resolution),
      cells_(2 * static_cast<std::int64_t>(std::ceil(half_size / resolution)) + 2),
      index_(static_cast<std::size_t>(cells_ * cells_), -1) {}

void RollingMemory::clear() {
  std::fill(index_.begin(), index_.end(), -1);
  points_.clear();
}

void RollingMemory::clear_outside(const Point& center, double half_size) {
  for (std::size_t i = points_.size(); i-- > 0;) {
    const Point& p = points_[i];
    if (std::max(std::abs(p.x - center.x), std::abs(p.y - center.y)) > half_size) remove(i);
  }
}

void RollingMemory::clear_along(const Pose& pose, const std::vector<double>& ranges,
                                const Robot& robot, double range) {
  if (range <= 0 || ranges.size() < 2) return;
  const Transform frame(pose);
  const double step = robot.aperture / static_cast<double>(ranges.size() - 1);
  const double last = static_cast<double>(ranges.size() - 1);
  const auto center = [&](double coordinate) {
    return (std::floor(coordinate / resolution_) + 0.5) * resolution_;
  };
  for (std::size_t i = points_.size(); i-- > 0;) {
    const Point local = frame.to_robot({center(points_[i].x), center(points_[i].y)});
    const double distance = slalom::math::hypot(local.x, local.y);
    if (distance > range) continue;
    const double at = (slalom::math::atan2(local.y, local.x) + 0.5 * robot.aperture) / step;
    const double half = slalom::math::asin(std::min(1.0, 0.5 * resolution_ / distance)) / step;
    const double low = std::max(0.0, std::ceil(at - half)), high = std::min(last, at + half);
    for (double ray = low; ray <= high; ++ray) {
      if (ranges[static_cast<std::size_t>(ray)] <= distance) continue;
      remove(i);
      break;
    }
  }
}

std::int64_t RollingMemory::cell_of(double coordinate) const {
  const auto cell = static_cast<std::int64_t>(std::floor(coordinate / resolution_)) % cells_;
  return cell < 0 ? cell + cells_ : cell;
}

std::size_t RollingMemory::slot_of(const Point& p) const {
  return static_cast<std::size_t>(cell_of(p.y) * cells_ + cell_of(p.x));
}

void RollingMemory::insert(const Point& p) {
  std::int32_t& at = index_[slot_of(p)];
  if (at >= 0) {
    points_[static_cast<std::size_t>(at)] = p;
    return;
  }
  at = static_cast<std::int32_t>(points_.size());
  points_.push_back(p);
}

void RollingMemory::remove(std::size_t index) {
  index_[slot_of(points_[index])] = -1;
  const Point last = points_.back();
  points_.pop_back();
  if (index == points_.size()) return;
  points_[index] = last;
  index_[slot_of(last)] = static_cast<std::int32_t>(index);
}

bool RollingMemory::sees_through(const Point& local, const std::vector<double>& ranges,
                                 const Robot& robot) {
  constexpr double kBeyond = 0.15;  // m: minimum distance behind a point
  const double step = robot.aperture / static_cast<double>(ranges.size() - 1);
  const double at = (slalom::math::atan2(local.y, local.x) + 0.5 * robot.aperture) / step;
  const double range = slalom::math::hypot(local.x, local.y) + kBeyond;
  // Four adjacent rays must agree, because points lie at edges and rays drop out.
  const double first = std::floor(at) - 1;
  if (!(first >= 0) || first + 3 >= static_cast<double>(ranges.size())) return false;
  const auto i = static_cast<std::size_t>(first);
  for (std::size_t k = i; k < i + 4; ++k)
    if (ranges[k] <= range) return false;
  return true;
}

/// Computes the directions of the rays, unless they are known.
void RollingMemory::aim(std::size_t rays, double aperture) {
  if (rays_.size() == rays && aperture_ == aperture) return;
  rays_.clear();
  aperture_ = aperture;
  for (std::size_t i = 0; i < rays; ++i) {
    const double angle = ray_angle(i, rays, aperture);
    rays_.push_back({slalom::math::cos(angle), slalom::math::sin(angle)});
  }
}

void RollingMemory::update(const Pose& pose, const std::vector<double>& ranges,
                           const Robot& robot) {
  const Transform frame(pose);
  aim(ranges.size(), robot.aperture);
  for (std::size_t i = points_.size(); i-- > 0;) {
    const Point& p = points_[i];
    const bool outside =
        std::max(std::abs(p.x - pose.x), std::abs(p.y - pose.y)) > half_size_ - resolution_;
    if (outside || (ranges.size() > 4 && sees_through(frame.to_robot(p), ranges, robot))) remove(i);
  }
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (!(ranges[i] >= 0 && ranges[i] < 0.999 * robot.max_range)) continue;  // no obstacle
    const Point p = frame.to_world({ranges[i] * rays_[i].x, ranges[i] * rays_[i].y});
    if (std::max(std::abs(p.x - pose.x), std::abs(p.y - pose.y)) < half_size_ - resolution_)
      insert(p);
  }
}

}  // namespace reactive
