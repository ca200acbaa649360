#pragma once

#include <slalom/core/options.h>
#include <slalom/core/random.h>
#include <slalom/scenario/distance_field.h>
#include <slalom/scenario/geometry.h>

#include <functional>

namespace slalom {

/// Where start and goal may lie: options that all families share.
struct EndsOptions {
  double clear_radius = 0.6;  ///< m, free about start and goal
  double min_distance = 8;    ///< m, straight distance from start to goal
  double margin = 0.7;        ///< m, of start and goal from the border

  void visit(OptionVisitor& v);
};

/// Start and goal of a scenario.
struct Ends {
  mrpt::math::TPoint2D start, goal;
};

/// Whether a start or goal may stand at a point.
using PlaceTest = std::function<bool(const mrpt::math::TPoint2D& place)>;

/// A start and a goal, evenly spread over the places within the margin that `is_good` accepts
/// (without it all are good), at least min_distance apart; opposite corners when such a pair is not
/// found soon.
Ends draw_ends(RandomEngine& engine, const Bounds& bounds, const EndsOptions& options,
               const PlaceTest& is_good = {});

/// The same with the start in one rectangle and the goal in another, margins within each.
Ends draw_ends(RandomEngine& engine, const Bounds& starts, const Bounds& goals,
               const EndsOptions& options, const PlaceTest& is_good = {});

/// Places that keep `radius` (m) from these obstacles. They must outlive the test.
PlaceTest clear_of(const Primitives& obstacles, double radius);
PlaceTest clear_of(const DistanceField& field, double radius);

/// The start's pose: the robot faces the goal within 45 degrees. The heading is in (-pi, pi].
mrpt::math::TPose2D start_pose(RandomEngine& engine, const Ends& ends);

/// `angle` (rad, in (-3 pi, 3 pi)) as one in (-pi, pi]; angles that are there already stay as they
/// are to the bit.
double wrap_angle(double angle);

}  // namespace slalom
