// SPDX-License-Identifier: BSD-3-Clause
#include "dubins_curve.h"
#include "pose_motions.h"
#include "pose_states.h"

#include <slalom/core/distance.h>
#include <slalom/core/math.h>
#include <slalom/references/footprint_contact.h>

#include <mrpt/math/wrap2pi.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

namespace ob = ompl::base;
using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;
using mrpt::math::wrapToPi;

TPose2D interpolated(const TPose2D& a, const TPose2D& b, double fraction) {
  return {a.x + fraction * (b.x - a.x), a.y + fraction * (b.y - a.y),
          wrapToPi(a.phi + fraction * wrapToPi(b.phi - a.phi))};
}

/// Straight motions.
class StraightMotions : public PoseMotions {
 public:
  StraightMotions(const World& world, const RobotModel& robot) : PoseMotions(world, robot) {}

  double length(const TPose2D& a, const TPose2D& b) const override {
    return distance_between(a, b);
  }
  TPose2D between(const TPose2D& a, const TPose2D& b, double fraction) const override {
    if (robot().holonomic()) return interpolated(a, b, fraction);
    const auto poses = rotate_and_drive(a, b, robot().forward_only);
    return interpolated(poses[1], poses[2], fraction);
  }
  bool is_free(const TPose2D& a, const TPose2D& b, double& fraction) const override {
    bool free = false;
    if (robot().holonomic()) {
      free = sweeps_free(a, b);
    } else {
      const auto poses = rotate_and_drive(a, b, robot().forward_only);
      free = sweeps_free(poses[1], poses[2]) && rotates_free(poses[0], poses[1]) &&
             rotates_free(poses[2], poses[3]);
    }
    if (!free) fraction = 0;
    return free;
  }
  void append_positions(const TPose2D&, const TPose2D& b, Path& path) const override {
    path.emplace_back(b.x, b.y);
  }

 private:
  bool sweeps_free(const TPose2D& a, TPose2D b) const {
    double unused = 1;
    return !make_footprint_contact(world(), footprint())->find_contact(a, b, unused);
  }
  /// In the shorter direction, or in the other one.
  bool rotates_free(const TPose2D& a, const TPose2D& b) const {
    if (sweeps_free(a, b)) return true;
    const double turn = wrapToPi(b.phi - a.phi);
    const double other_way = turn > 0 ? turn - 2 * M_PI : turn + 2 * M_PI;
    TPose2D from = a;
    constexpr int kParts = 3;  // each of less than a half turn
    for (int i = 1; i <= kParts; ++i) {
      const TPose2D to(a.x, a.y, wrapToPi(a.phi + other_way * i / kParts));
      if (!sweeps_free(from, to)) return false;
      from = to;
    }
    return true;
  }
};

class ReedsSheppCurve {
 public:
  ReedsSheppCurve(const TPose2D& a, const TPose2D& b, double radius)
      : space_(std::make_shared<ob::ReedsSheppStateSpace>(radius)),
        from_(space_),
        to_(space_),
        state_(space_) {
    set_pose(from_.get(), a);
    set_pose(to_.get(), b);
    length_ = space_->distance(from_.get(), to_.get());
  }
  double length() const { return length_; }
  TPose2D at(double fraction) {
    space_->interpolate(from_.get(), to_.get(), fraction, is_first_, path_, state_.get());
    return pose_of(state_.get());
  }

 private:
  std::shared_ptr<ob::ReedsSheppStateSpace> space_;
  ob::ScopedState<ob::SE2StateSpace> from_, to_, state_;
  double length_ = 0;
  bool is_first_ = true;
  ob::ReedsSheppStateSpace::ReedsSheppPath path_;
};

template <typename Curve>
class CurveMotions : public PoseMotions {
 public:
  CurveMotions(const World& world, const RobotModel& robot) : PoseMotions(world, robot) {
    constexpr double kMaxDeviation = 1e-5;  // m
    step_ = std::min(0.5 * world.occupancy().resolution(),
                     std::sqrt(8 * robot.min_turning_radius * kMaxDeviation));
  }

  double length(const TPose2D& a, const TPose2D& b) const override {
    return curve_of(a, b).length();
  }
  TPose2D between(const TPose2D& a, const TPose2D& b, double fraction) const override {
    return curve_of(a, b).at(fraction);
  }
  bool is_free(const TPose2D& a, const TPose2D& b, double& fraction) const override {
    Curve curve = curve_of(a, b);
    double known_free = 0;
    const bool free = is_free_part(curve, {0, a}, {1, b}, known_free);
    if (!free) fraction = known_free;
    return free;
  }
  void append_positions(const TPose2D& a, const TPose2D& b, Path& path) const override {
    Curve curve = curve_of(a, b);
    int steps = 1;  // the chords of is_free_part()
    while (curve.length() > steps * step_) steps *= 2;
    for (int i = 1; i < steps; ++i) {
      const TPose2D pose = curve.at(static_cast<double>(i) / steps);
      path.emplace_back(pose.x, pose.y);
    }
    path.emplace_back(b.x, b.y);
  }

 private:
  Curve curve_of(const TPose2D& a, const TPose2D& b) const {
    return {a, b, robot().min_turning_radius};
  }
  struct PoseAt {
    double fraction = 0;
    TPose2D pose;
  };

  /// Bisects the part: it is free if the clearance of its middle is half its length.
  bool is_free_part(Curve& curve, const PoseAt& a, const PoseAt& b, double& known_free) const {
    const double part = (b.fraction - a.fraction) * curve.length();
    if (part <= step_) {
      TPose2D end = b.pose;
      double unused = 1;
      const auto contact = make_footprint_contact(world(), footprint());
      if (contact->find_contact(a.pose, end, unused)) return false;
      known_free = b.fraction;
      return true;
    }
    const double fraction = 0.5 * (a.fraction + b.fraction);
    const PoseAt middle{fraction, curve.at(fraction)};
    const double reach = footprint().enclosing_radius() + 0.5 * part;
    constexpr double kMargin = 1e-3;  // m, above the tolerances of contact
    if (world().distance_field().clearance_lower_bound(TPoint2D(middle.pose)) > reach + kMargin) {
      known_free = b.fraction;
      return true;
    }
    return is_free_part(curve, a, middle, known_free) && is_free_part(curve, middle, b, known_free);
  }

  double step_ = 0;  ///< m
};

}  // namespace

bool PoseMotions::is_free_at(const TPose2D& pose) const {
  return world_.scenario().bounds().contains({pose.x, pose.y}) &&
         !make_footprint_contact(world_, footprint_)->touches(pose);
}

std::array<TPose2D, 4> rotate_and_drive(const TPose2D& a, const TPose2D& b, bool forward_only) {
  constexpr double kNoDistance = 1e-9;  // m
  double heading = a.phi;
  if (distance_between(a, b) > kNoDistance) {
    heading = math::atan2(b.y - a.y, b.x - a.x);
    const auto rotation = [&](double at) {
      return std::abs(wrapToPi(at - a.phi)) + std::abs(wrapToPi(b.phi - at));
    };
    if (!forward_only && rotation(heading + M_PI) < rotation(heading))
      heading = wrapToPi(heading + M_PI);
  }
  return {a, TPose2D(a.x, a.y, heading), TPose2D(b.x, b.y, heading), b};
}

std::unique_ptr<PoseMotions> make_pose_motions(const World& world, const RobotModel& robot) {
  if (robot.min_turning_radius == 0) return std::make_unique<StraightMotions>(world, robot);
  if (robot.forward_only) return std::make_unique<CurveMotions<DubinsCurve>>(world, robot);
  return std::make_unique<CurveMotions<ReedsSheppCurve>>(world, robot);
}

double length(const PoseMotions& motions, const std::vector<TPose2D>& poses) {
  double sum = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) sum += motions.length(poses[i - 1], poses[i]);
  return sum;
}

Path positions_along(const PoseMotions& motions, const std::vector<TPose2D>& poses) {
  Path all = {TPoint2D(poses.front())};
  for (std::size_t i = 1; i < poses.size(); ++i)
    motions.append_positions(poses[i - 1], poses[i], all);
  Path path = {all.front()};
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (i + 1 < all.size()) {
      const TPoint2D to = all[i] - path.back(), on = all[i + 1] - all[i];
      constexpr double kCollinear = 1e-10;  // m^2
      if (std::abs(to.x * on.y - to.y * on.x) < kCollinear && to.x * on.x + to.y * on.y >= 0)
        continue;
    }
    path.push_back(all[i]);
  }
  return path;
}

}  // namespace slalom
