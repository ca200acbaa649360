// SPDX-License-Identifier: BSD-3-Clause
#include "mover_tracker.h"

#include <slalom/core/math.h>

#include <cmath>

namespace slalom {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;
using mrpt::math::TVector2D;

namespace {

TPoint2D rotated(const TPoint2D& p, double cosine, double sine) {
  return {cosine * p.x - sine * p.y, sine * p.x + cosine * p.y};
}

/// Two errors along the axes of the robot frame.
TVector2D track_error(RandomEngine& random, double sigma) {
  if (sigma == 0) return {0, 0};
  const double x = normal(random, 0, sigma);
  return {x, normal(random, 0, sigma)};
}

}  // namespace

MoverTracker::MoverTracker(const Movers& movers, const TrackerModel& model, std::uint64_t seed,
                           std::size_t scripted)
    : movers_(movers),
      scripted_(scripted),
      model_(model),
      position_(derive_seed(seed, "tracks/position")),
      velocity_(derive_seed(seed, "tracks/velocity")),
      dropout_(derive_seed(seed, "tracks/dropout")) {}

/// m/s, of the motion up to `t` for people: they choose the one from `t` on at that instant.
TPoint2D MoverTracker::known_velocity(std::size_t i, double t) const {
  constexpr double kRounding = 1e-9;  // s, of times of updates
  const bool is_chosen_now = i >= scripted_ && !model_.intention;
  return movers_[i].velocity(is_chosen_now ? t - kRounding : t);
}

const std::vector<Track>& MoverTracker::sense(const TPose2D& pose, double t) {
  tracks_.clear();
  const auto [sine, cosine] = math::sin_cos(pose.phi);
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    const Mover& mover = movers_[i];
    const TVector2D position_error = track_error(position_, model_.position_sigma);
    const TVector2D velocity_error = track_error(velocity_, model_.velocity_sigma);
    const bool missing =
        model_.dropout_ratio > 0 && uniform_real(dropout_, 0, 1) < model_.dropout_ratio;
    if (missing || !mover.present(t)) continue;
    const TPoint2D to = mover.position(t) - TPoint2D(pose);
    if (math::hypot(to.x, to.y) > model_.range) continue;
    tracks_.push_back({static_cast<std::int32_t>(i), rotated(to, cosine, -sine) + position_error,
                       rotated(known_velocity(i, t), cosine, -sine) + velocity_error,
                       mover.radius});
  }
  return tracks_;
}

}  // namespace slalom
