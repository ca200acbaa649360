// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/placement.h>
#include <slalom/map_formats/world_import.h>

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// The obstacles of a robot on the ground, made of the solids of a world, and what is left out.
class WorldParts {
 public:
  WorldParts(std::string where, const WorldOptions& options);

  // Solids in the frame of a pose, lengths in m; a cylinder and a capsule stand on z.
  void add_box(const Placement& pose, double x, double y, double z);
  void add_cylinder(const Placement& pose, double radius, double length);
  void add_sphere(const Placement& pose, double radius);
  /// The prism of an outline, which must be simple, from z_low to z_high. Returns false for one
  /// that is tilted and not convex.
  bool add_prism(const Placement& pose, const Polygon& outline, double z_low, double z_high);
  void add_mover(Mover mover) { movers_.push_back(std::move(mover)); }

  /// Cells that become the workspace, with the obstacles in it.
  void set_grid(mrpt::maps::COccupancyGridMap2D grid) { grid_ = std::move(grid); }
  void set_bounds(const Bounds& bounds) { bounds_ = bounds; }  ///< instead of the margin
  void set_task(std::optional<mrpt::math::TPose2D> start,
                std::optional<mrpt::math::TPoint2D> goal) {
    start_ = start;
    goal_ = goal;
  }

  /// `kind` in plural, for example "meshes".
  void leave_out(const std::string& kind, const std::string& name);

  /// Counts work, which files that include each other could multiply.
  void count(std::size_t& counter, std::size_t limit, const std::string& what) const;

  /// The world within `margin` around its obstacles and its task, or within its grid and around
  /// them. Throws Error (File) if there are none.
  ImportedWorld finish(const std::string& name) const;

 private:
  bool in_heights(double low, double high);
  void add_polygon(Polygon polygon);
  void add_disc(const mrpt::math::TPoint2D& center, double radius);
  std::string left_out_text() const;
  Bounds extent() const;
  Scenario continuous(const std::string& name) const;
  Scenario on_grid(const std::string& name) const;

  std::string where_;
  WorldOptions options_;
  Primitives obstacles_;
  Movers movers_;
  std::optional<mrpt::maps::COccupancyGridMap2D> grid_;
  std::optional<Bounds> bounds_;
  std::optional<mrpt::math::TPose2D> start_;
  std::optional<mrpt::math::TPoint2D> goal_;
  std::size_t outside_heights_ = 0, solids_ = 0;
  /// Names, with their numbers, by kind.
  std::vector<std::pair<std::string, std::vector<std::pair<std::string, int>>>> left_out_;
};

}  // namespace slalom
