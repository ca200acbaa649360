// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/distance.h>
#include <slalom/core/pose.h>
#include <slalom/references/footprint_contact.h>
#include <slalom/scenario/contact.h>
#include <slalom/scenario/geometry.h>

#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

class DiscContact : public FootprintContact {
 public:
  DiscContact(const World& world, double radius) : world_(world), radius_(radius) {}

  bool touches(const TPose2D& pose) const override {
    return is_blocked(TPoint2D(pose), TPoint2D(pose));
  }

  bool find_contact(const TPose2D& from, TPose2D& to, double& fraction) override {
    const TPoint2D a = TPoint2D(from), b = TPoint2D(to), motion = b - a;
    // Distances between poses, without the last bit: they only say when to test.
    free_travel_ -= std::sqrt(motion.x * motion.x + motion.y * motion.y);
    if (free_travel_ > 0) return false;
    if (!is_blocked(a, b)) {
      free_travel_ = world_.distance_field().clearance(b) - radius_;
      return false;
    }
    double low = 0, high = 1;
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (low + high);
      (is_blocked(a, a + (b - a) * middle) ? high : low) = middle;
    }
    fraction = high;
    to = interpolate(from, to, high);
    return true;
  }

  bool is_free(const TPose2D& from, const TPose2D& to, double margin) const override {
    const double limit = radius_ + margin;
    return world_.distance_field().segment_clearance(TPoint2D(from), TPoint2D(to), limit) >= limit;
  }

 private:
  bool is_blocked(const TPoint2D& a, const TPoint2D& b) const {
    return world_.distance_field().segment_clearance(a, b, radius_) < radius_ - kContactTolerance;
  }

  const World& world_;
  double radius_;
  /// Distance (m) that the robot can move without contact: avoids exact tests in open space.
  double free_travel_ = 0;
};

/// A polygon, swept by conservative advancement: no point of it moves farther than the robot
/// plus the rotation times the enclosing radius, so a motion up to the clearance is safe.
class PolygonContact : public FootprintContact {
 public:
  PolygonContact(const World& world, const Footprint& footprint)
      : world_(world), footprint_(footprint) {}

  bool touches(const TPose2D& pose) const override {
    return clearance(pose) < kContact || contains_obstacle(pose);
  }

  bool find_contact(const TPose2D& from, TPose2D& to, double& fraction) override {
    const double motion = longest_way(from, to);
    if (motion < free_travel_) {
      free_travel_ -= motion;
      return false;
    }
    for (double at = 0; at < 1;) {
      const TPose2D pose = interpolate(from, to, at);
      free_travel_ = clearance(pose);
      if (free_travel_ < kContact) {
        fraction = at;
        to = pose;
        return true;
      }
      const double left = (1 - at) * motion;
      if (left <= free_travel_) {
        free_travel_ -= left;
        return false;
      }
      at += free_travel_ / motion;
    }
    return false;
  }

  bool is_free(const TPose2D& from, const TPose2D& to, double margin) const override {
    const double motion = longest_way(from, to);
    for (double at = 0;;) {
      const double free = clearance(interpolate(from, to, at)) - margin;
      if (free < kContact) return false;
      if ((1 - at) * motion <= free) return true;
      at += free / motion;
    }
  }

 private:
  /// Clearance (m) below which there is contact: bounds the number of advances along a wall.
  static constexpr double kContact = 1e-4;

  /// m, the farthest that a point of the polygon moves.
  double longest_way(const TPose2D& from, const TPose2D& to) const {
    const double turn = std::abs(mrpt::math::wrapToPi(to.phi - from.phi));
    return distance_between(from, to) + footprint_.enclosing_radius() * turn;
  }

  double clearance(const TPose2D& pose) const {
    return world_.distance_field().outline_clearance(footprint_.corners_at(pose));
  }

  /// Whether an occupied cell lies inside the polygon without touching its outline.
  bool contains_obstacle(const TPose2D& pose) const {
    const Occupancy& cells = world_.occupancy();
    const TPoint2D center = cells.to_cells(TPoint2D(pose));
    const int reach =
        static_cast<int>(std::ceil(footprint_.enclosing_radius() / cells.resolution()));
    const int cx = static_cast<int>(std::floor(center.x)),
              cy = static_cast<int>(std::floor(center.y));
    const Polygon outline{footprint_.corners_at(pose)};
    for (int y = cy - reach; y <= cy + reach; ++y)
      for (int x = cx - reach; x <= cx + reach; ++x)
        if (cells.occupied(x, y) && contains(outline, cells.cell_center(x, y))) return true;
    return false;
  }

  const World& world_;
  Footprint footprint_;
  double free_travel_ = 0;
};

}  // namespace

std::unique_ptr<FootprintContact> make_footprint_contact(const World& world,
                                                         const Footprint& footprint) {
  if (footprint.is_disc())
    return std::make_unique<DiscContact>(world, footprint.enclosing_radius());
  return std::make_unique<PolygonContact>(world, footprint);
}

}  // namespace slalom
