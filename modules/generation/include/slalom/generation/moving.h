// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>
#include <slalom/core/random.h>
#include <slalom/generation/start_goal.h>
#include <slalom/scenario/scenario.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// Distance (m) that generated movers keep from walls and the border.
constexpr double kWallMargin = 0.05;

/// Options of families with moving obstacles. Each mover's radius and speed are drawn uniformly.
struct MoverOptions {
  int min_movers = 3, max_movers = 8;         ///< number, drawn per scenario
  double min_radius = 0.2, max_radius = 0.4;  ///< m
  double min_speed = 0.4, max_speed = 1.2;    ///< m/s, constant while a mover walks

  void visit(OptionVisitor& v);
};

/// The waypoints of a mover that waits until `begin` (s) and then walks along `path` (m), which has
/// at least two positions, at `speed` (m/s), as set_speed() does.
std::vector<Waypoint> walk_along(const std::vector<mrpt::math::TPoint2D>& path, double speed,
                                 double begin = 0);

/// How one mover of the radius (m) and speed (m/s) walks; no waypoints if it cannot.
using WalkSampler = std::function<std::vector<Waypoint>(double radius, double speed)>;

/// The movers of a scenario: their number, radii and speeds are drawn from the options, each walk
/// by `sample`. When the run begins each is at least clear_radius (m) away from the start. One for
/// which 60 draws do not suffice is left out. Ids are mover_0, mover_1, ... Those that are to
/// become people also start, and unless they vanish end, kWallMargin apart from each other.
Movers sample_movers(RandomEngine& engine, const MoverOptions& options, MoverEnd after,
                     const mrpt::math::TPoint2D& start, double clear_radius,
                     const WalkSampler& sample, bool are_people = false);

/// The scenario with these movers; or with people, person_0, person_1, ..., of their radii and
/// speeds. All set off when the run begins, from where a mover starts to where it ends, by ways of
/// their own; those of a loop walk to and fro between its ends.
Scenario with_moving(const Scenario& scenario, Movers movers, bool are_people);

}  // namespace slalom
