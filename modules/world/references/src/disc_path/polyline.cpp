// SPDX-License-Identifier: BSD-3-Clause
#include "occupied_rows.h"

#include <slalom/core/math.h>
#include <slalom/references/disc_path.h>
#include <slalom/scenario/contact.h>

namespace slalom {
namespace disc_path {
namespace {

/// An arc of the polyline's own radius.
struct Bend {
  Vector center;
  double first_angle = 0;
  double sweep = 0;  ///< signed; may have the wrong sign by rounding errors
};

/// A path in cells whose arcs have a radius in the middle of what collision checking tolerates, so
/// that chords on both sides of it are free.
class RoundedPath {
 public:
  RoundedPath(const DiscPath& path, const Occupancy& cells)
      : start_(cells.to_cells(path.start)), goal_(cells.to_cells(path.goal)) {
    radius_ = (path.radius + 0.5 * kContactTolerance) / cells.resolution();
    for (const DiscArc& arc : path.arcs) bends_.push_back({cells.to_cells(arc.center), 0, 0});
    for (std::size_t i = 0; i < bends_.size(); ++i) set_angles(path.arcs, i);
  }

  double radius() const { return radius_; }
  const std::vector<Bend>& bends() const { return bends_; }
  double turned() const {
    double sum = 0;
    for (const Bend& bend : bends_) sum += std::abs(bend.sweep);
    return sum;
  }

  Vector point_at(const Bend& bend, double angle) const {
    return bend.center + unit(angle) * radius_;
  }

 private:
  /// From the tangents to the circles before and after; start and goal are circles of radius 0.
  void set_angles(const std::vector<DiscArc>& arcs, std::size_t i) {
    const bool is_first = i == 0, is_last = i + 1 == bends_.size();
    const double own = arcs[i].turn * radius_;
    const auto arriving =
        common_tangent(is_first ? start_ : bends_[i - 1].center,
                       is_first ? 0 : arcs[i - 1].turn * radius_, bends_[i].center, own);
    const auto leaving =
        common_tangent(bends_[i].center, own, is_last ? goal_ : bends_[i + 1].center,
                       is_last ? 0 : arcs[i + 1].turn * radius_);
    const auto angle_of = [&](const Vector& direction) {
      return math::atan2(-arcs[i].turn * direction.x, arcs[i].turn * direction.y);
    };
    Bend& bend = bends_[i];
    bend.first_angle = arriving ? angle_of(arriving->direction) : arcs[i].first_angle;
    const double last =
        leaving ? angle_of(leaving->direction) : arcs[i].first_angle + arcs[i].turn * arcs[i].sweep;
    bend.sweep = std::remainder(last - bend.first_angle, 2 * M_PI);
  }

  Vector start_, goal_;
  double radius_ = 0;
  std::vector<Bend> bends_;
};

/// The vertices of `count` chords that touch the arc from outside.
std::vector<Vector> vertices_around(const RoundedPath& path, const Bend& bend, int count) {
  const double step = bend.sweep / count;
  const double distance = path.radius() / math::cos(0.5 * step);
  std::vector<Vector> vertices;
  for (int i = 0; i < count; ++i)
    vertices.push_back(bend.center + unit(bend.first_angle + (i + 0.5) * step) * distance);
  return vertices;
}

/// The fewest vertices that the excess allows, more if the chords touch what is on the other side
/// of the path.
std::vector<Vector> free_vertices(const RoundedPath& path, const Bend& bend, double max_step,
                                  const OccupiedRows& rows, double checked_radius) {
  constexpr int kMaxCount = 1 << 15;
  const Vector first = path.point_at(bend, bend.first_angle);
  const Vector last = path.point_at(bend, bend.first_angle + bend.sweep);
  int count = std::max(1, static_cast<int>(std::ceil(std::abs(bend.sweep) / max_step)));
  while (true) {
    std::vector<Vector> vertices = vertices_around(path, bend, count);
    Vector from = first;
    bool is_free = true;
    for (std::size_t i = 0; i < vertices.size() && is_free; ++i) {
      is_free = is_sweep_free(rows, from, vertices[i], checked_radius);
      from = vertices[i];
    }
    is_free = is_free && is_sweep_free(rows, from, last, checked_radius);
    if (is_free || count >= kMaxCount) return vertices;
    count *= 2;
  }
}

}  // namespace
}  // namespace disc_path

/// A chord of angle s around an arc of radius r exceeds it by r s^3 / 12 (and higher orders).
Path to_polyline(const DiscPath& path, const Occupancy& cells, double max_excess) {
  const disc_path::RoundedPath rounded(path, cells);
  const double around = rounded.turned() * path.radius;
  constexpr double kMargin = 0.9, kMaxStep = 0.5;  // for the higher orders and the radius
  const double max_step =
      around > 0 ? std::min(kMaxStep, std::sqrt(12 * kMargin * max_excess * path.length / around))
                 : kMaxStep;
  const disc_path::OccupiedRows rows(cells);
  const double checked_radius = path.radius / cells.resolution() - disc_path::kClearanceTolerance;
  Path points = {path.start};
  for (const disc_path::Bend& bend : rounded.bends())
    for (const disc_path::Vector& p : free_vertices(rounded, bend, max_step, rows, checked_radius))
      points.push_back(cells.to_world(p.x, p.y));
  points.push_back(path.goal);
  return points;
}

}  // namespace slalom
