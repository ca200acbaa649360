// SPDX-License-Identifier: BSD-3-Clause
#include "dwa_local_planner/recovery.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>

namespace dwa_local_planner {

using namespace reactive;

Recovery::Recovery(const Parameters& parameters, const Robot& robot, const Footprint& footprint)
    : parameters_(parameters), footprint_(footprint) {
  if (!parameters.recovery_behavior_enabled) return;
  const bool rotates = parameters.clearing_rotation_allowed;
  behaviors_ = {Behavior::ConservativeReset};
  if (rotates) behaviors_.push_back(Behavior::Rotate);
  if (parameters.backup_allowed && !robot.forward_only) behaviors_.push_back(Behavior::BackUp);
  behaviors_.push_back(Behavior::AggressiveReset);
  if (rotates) behaviors_.push_back(Behavior::Rotate);
}

void Recovery::take_over(const Recovery& before) {
  if (behaviors_ != before.behaviors_) return;
  next_ = before.next_;
  is_active_ = before.is_active_;
  begin_ = before.begin_;
  last_ = before.last_;
  turned_ = before.turned_;
}

void Recovery::start(const Pose& pose, RollingMemory& memory) {
  if (behaviors_.empty()) return;
  const Behavior behavior = behaviors_[next_];
  next_ = (next_ + 1) % behaviors_.size();
  // The reset distances are the side lengths of squares.
  const double side = behavior == Behavior::ConservativeReset
                          ? parameters_.conservative_reset_dist
                          : 4 * footprint_.circumscribed_radius();
  is_active_ = behavior == Behavior::Rotate || behavior == Behavior::BackUp;
  if (!is_active_) memory.clear_outside({pose.x, pose.y}, 0.5 * side);
  begin_ = last_ = pose;
  turned_ = 0;
}

std::optional<Twist> Recovery::step(const Costmap& map, const Pose& pose) {
  if (!is_active_) return std::nullopt;
  const std::size_t active = (next_ + behaviors_.size() - 1) % behaviors_.size();
  const auto command =
      behaviors_[active] == Behavior::Rotate ? rotate(map, pose) : back_up(map, pose);
  is_active_ = command.has_value();
  return command;
}

std::optional<Twist> Recovery::rotate(const Costmap& map, const Pose& pose) {
  constexpr double kStep = 0.017, kDone = 0.1;  // rad
  turned_ += std::abs(wrapped(pose.phi - last_.phi));
  last_ = pose;
  const double remaining = 2 * M_PI - turned_;
  if (remaining < kDone) return std::nullopt;
  for (double angle = 0; angle < remaining; angle += kStep)
    if (footprint_.cost(map, {pose.x, pose.y, pose.phi + angle}) == Inflation::kLethal)
      return std::nullopt;
  const double w = std::sqrt(2 * parameters_.acc_lim_theta * remaining);
  return Twist{0, std::clamp(w, std::min(parameters_.min_vel_theta, parameters_.max_vel_theta),
                             parameters_.max_vel_theta)};
}

std::optional<Twist> Recovery::back_up(const Costmap& map, const Pose& pose) {
  const double remaining =
      parameters_.backup_dist - slalom::math::hypot(pose.x - begin_.x, pose.y - begin_.y);
  if (remaining <= 0) return std::nullopt;
  for (double back = 0; back <= remaining; back += parameters_.resolution) {
    const Point p = to_world(pose, {-back, 0});
    if (footprint_.cost(map, {p.x, p.y, pose.phi}) == Inflation::kLethal) return std::nullopt;
  }
  return Twist{-parameters_.backup_speed, 0};
}

}  // namespace dwa_local_planner
