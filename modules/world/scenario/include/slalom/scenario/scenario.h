// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/enum_names.h>
#include <slalom/scenario/geometry.h>
#include <slalom/scenario/mover.h>
#include <slalom/scenario/person.h>
#include <slalom/scenario/published_path.h>

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimplePointsMap.h>

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace slalom {

using GridMapPtr = std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>;
using PointMapPtr = std::shared_ptr<const mrpt::maps::CSimplePointsMap>;

enum class Representation { Continuous, Grid, Points };
constexpr auto enum_names(Representation) {
  return std::array{"continuous", "grid", "points"};
}

/// One obstacle avoidance problem: a workspace, its obstacles, which may include moving ones, a
/// start pose and a goal position, which may have a heading. Immutable; its identity is the hash of
/// its content (geometry, start, goal; movers, people and the heading of the goal if there are
/// any), not its name.
///
/// Grids are binarized on construction. MRPT stores in a cell the probability that it is *free* (0
/// occupied, 1 free): above 0.5 the cell is free, below it is occupied; unknown cells (exactly 0.5
/// as stored by MRPT) are occupied unless the importer made them free. Resolution in m; cell (0,0)
/// has its lower left corner at (x_min, y_min) of the bounds.
class Scenario {
 public:
  /// Throw Error (File) naming `name` when bounds are empty or not finite, start or goal lie
  /// outside them, or a primitive is degenerate (radius <= 0, polygon not simple).
  static Scenario continuous(std::string name, Bounds bounds, Primitives obstacles,
                             mrpt::math::TPose2D start, mrpt::math::TPoint2D goal);
  static Scenario grid(std::string name, const mrpt::maps::COccupancyGridMap2D& map,
                       mrpt::math::TPose2D start, mrpt::math::TPoint2D goal);
  static Scenario points(std::string name, Bounds bounds, const mrpt::maps::CSimplePointsMap& map,
                         mrpt::math::TPose2D start, mrpt::math::TPoint2D goal);

  Representation representation() const;
  const std::string& name() const { return name_; }
  const Bounds& bounds() const { return bounds_; }
  const mrpt::math::TPose2D& start() const { return start_; }
  const mrpt::math::TPoint2D& goal() const { return goal_; }
  /// rad, the robot's heading at the goal; nullopt if any will do.
  const std::optional<double>& goal_heading() const { return rest_.goal_heading; }
  const std::string& hash() const { return hash_; }  ///< 32 hexadecimal digits

  const Primitives& primitives() const;  ///< requires Continuous
  const GridMapPtr& grid_map()
      const;  ///< requires Grid; cells are p2l(1), free, or p2l(0), occupied
  const PointMapPtr& point_map() const;  ///< requires Points

  /// Moving obstacles; none unless set. Representations, the distance field, the ray caster and the
  /// reference paths are those of the static obstacles.
  const Movers& movers() const { return rest_.movers; }
  /// People, who react to each other and to the robot; none unless set. The same holds for them.
  const People& people() const { return rest_.people; }

  /// The path that was published with this environment, or null. Not part of the content.
  const PublishedPathPtr& published_path() const { return published_path_; }

  Scenario renamed(std::string name) const;
  /// The same environment, movers, people and goal heading with another start and goal; without the
  /// published path, which belongs to these.
  Scenario with_start_goal(mrpt::math::TPose2D start, mrpt::math::TPoint2D goal) const;
  /// The same with this heading of the goal, or without one. Throws Error (File) unless it is
  /// finite.
  Scenario with_goal_heading(std::optional<double> heading) const;
  /// The same with these moving obstacles instead of its own. Throws like check_movers().
  Scenario with_movers(Movers movers) const;
  /// The same with these people instead of its own. Throws like check_people(), and Error (File)
  /// naming a person whose start or route leaves the bounds, or whose id is that of a mover.
  Scenario with_people(People people) const;
  /// The same with the movers, the people and the goal heading of another one: what static
  /// obstacles, start and goal leave open.
  Scenario with_rest_of(const Scenario& other) const;
  /// The same with this path, or without one (null). Throws like check_published_path().
  Scenario with_published_path(PublishedPathPtr path) const;

 private:
  using Obstacles = std::variant<Primitives, GridMapPtr, PointMapPtr>;
  struct Rest {
    Movers movers;
    People people;
    std::optional<double> goal_heading;
  };
  Scenario(std::string name, Bounds bounds, Obstacles obstacles, mrpt::math::TPose2D start,
           mrpt::math::TPoint2D goal, Rest rest = {});
  Scenario with_rest(Rest rest) const;

  std::string name_;
  Bounds bounds_;
  Obstacles obstacles_;
  mrpt::math::TPose2D start_;
  mrpt::math::TPoint2D goal_;
  Rest rest_;
  std::string hash_;
  PublishedPathPtr published_path_;
};

}  // namespace slalom
