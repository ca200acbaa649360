#include <slalom/generation/ends.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr double kPi = 3.14159265358979323846;
constexpr int kPairs = 1000, kPlaces = 200;

TPoint2D draw_place(RandomEngine& engine, const Bounds& bounds, double margin) {
  const double x = uniform_real(engine, bounds.x_min + margin, bounds.x_max - margin);
  return {x, uniform_real(engine, bounds.y_min + margin, bounds.y_max - margin)};
}

std::optional<TPoint2D> draw_good_place(RandomEngine& engine, const Bounds& bounds, double margin,
                                        const PlaceTest& is_good) {
  for (int i = 0; i < kPlaces; ++i) {
    const TPoint2D place = draw_place(engine, bounds, margin);
    if (!is_good || is_good(place)) return place;
  }
  return std::nullopt;
}

}  // namespace

Ends draw_ends(RandomEngine& engine, const Bounds& bounds, const EndsOptions& options,
               const PlaceTest& is_good) {
  return draw_ends(engine, bounds, bounds, options, is_good);
}

Ends draw_ends(RandomEngine& engine, const Bounds& starts, const Bounds& goals,
               const EndsOptions& options, const PlaceTest& is_good) {
  const double m = options.margin;
  for (int i = 0; i < kPairs; ++i) {
    const auto start = draw_good_place(engine, starts, m, is_good);
    if (!start) break;
    const auto goal = draw_good_place(engine, goals, m, is_good);
    if (!goal) break;
    if (std::hypot(goal->x - start->x, goal->y - start->y) >= options.min_distance)
      return {*start, *goal};
  }
  return {{starts.x_min + m, starts.y_min + m}, {goals.x_max - m, goals.y_max - m}};
}

PlaceTest clear_of(const Primitives& obstacles, double radius) {
  return [&obstacles, radius](const TPoint2D& place) {
    const auto keeps_clear = [&](const auto& o) { return distance(place, o) >= radius; };
    return std::all_of(obstacles.discs.begin(), obstacles.discs.end(), keeps_clear) &&
           std::all_of(obstacles.polygons.begin(), obstacles.polygons.end(), keeps_clear);
  };
}

PlaceTest clear_of(const DistanceField& field, double radius) {
  return [&field, radius](const TPoint2D& place) { return field.clearance(place) >= radius; };
}

mrpt::math::TPose2D start_pose(RandomEngine& engine, const Ends& ends) {
  const double bearing = std::atan2(ends.goal.y - ends.start.y, ends.goal.x - ends.start.x);
  const double heading = bearing + uniform_real(engine, -kPi / 4, kPi / 4);
  return {ends.start.x, ends.start.y, wrap_angle(heading)};
}

double wrap_angle(double angle) {
  if (angle > kPi) return angle - 2 * kPi;
  if (angle <= -kPi) return angle + 2 * kPi;
  return angle;
}

void EndsOptions::visit(OptionVisitor& v) {
  v.option("clear_radius", clear_radius, "m", "kept free about start and goal", Range::at_least(0));
  v.option("min_distance", min_distance, "m", "straight distance from start to goal",
           Range::at_least(0));
  v.option("margin", margin, "m", "of start and goal from the border", Range::at_least(0));
}

}  // namespace slalom
