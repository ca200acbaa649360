// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/expect_text.h>
#include <slalom/core/geometry.h>
#include <slalom/core/hash.h>
#include <slalom/scenario/grid_map.h>
#include <slalom/scenario/scenario.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <utility>

namespace slalom {
namespace {

using mrpt::maps::COccupancyGridMap2D;
using mrpt::maps::CSimplePointsMap;
using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

std::string text(const TPoint2D& p) {
  std::ostringstream out;
  out << '(' << p.x << ", " << p.y << ')';
  return out.str();
}

void check_bounds(const std::string& name, const Bounds& b) {
  const bool good = is_finite({b.x_min, b.y_min}) && is_finite({b.x_max, b.y_max}) &&
                    b.width() > 0 && b.height() > 0;
  if (!good)
    throw file_error(name,
                     "bounds from " + text({b.x_min, b.y_min}) + " to " + text({b.x_max, b.y_max}),
                     "a finite rectangle of positive width and height");
}

void check_position(const std::string& name, const Bounds& b, const char* what, const TPoint2D& p) {
  // MRPT stores the limits of maps in single precision: positions on the border may be off by that.
  const double slack = 1e-6 * std::max(b.width(), b.height());
  const bool good = p.x >= b.x_min - slack && p.x <= b.x_max + slack && p.y >= b.y_min - slack &&
                    p.y <= b.y_max + slack;
  if (!good)
    throw file_error(
        name, std::string(what) + " at " + text(p),
        "a position within " + text({b.x_min, b.y_min}) + " to " + text({b.x_max, b.y_max}));
}

void check_task(const std::string& name, const Bounds& bounds, const TPose2D& start,
                const TPoint2D& goal) {
  check_position(name, bounds, "start", TPoint2D(start.x, start.y));
  check_position(name, bounds, "goal", goal);
  if (!std::isfinite(start.phi))
    throw file_error(name, "start heading is not finite", "a finite angle");
}

/// Also that ids are not those of movers, since contacts and tracks are of both.
void check_people_among(const std::string& name, const Bounds& bounds, const Movers& movers,
                        const People& people) {
  check_people(name, people);
  for (const Person& person : people) {
    const std::string where = name + ": person '" + person.id + "'";
    if (std::any_of(movers.begin(), movers.end(),
                    [&](const Mover& mover) { return mover.id == person.id; }))
      throw file_error(where, "has the id of a moving obstacle", "unique ids");
    check_position(where, bounds, "start", person.start);
    for (std::size_t i = 0; i < person.route.size(); ++i)
      check_position(where, bounds, ("point " + std::to_string(i) + " of the route").c_str(),
                     person.route[i]);
  }
}

void check_primitives(const std::string& name, const Primitives& obstacles) {
  for (std::size_t i = 0; i < obstacles.discs.size(); ++i) {
    const Disc& disc = obstacles.discs[i];
    if (!is_finite(disc.center) || !std::isfinite(disc.radius) || !(disc.radius > 0))
      throw file_error(name, "disc " + std::to_string(i) + " is degenerate",
                       "a finite center and a radius above 0");
  }
  for (std::size_t i = 0; i < obstacles.polygons.size(); ++i) {
    bool good = true;
    for (const TPoint2D& vertex : obstacles.polygons[i].vertices) good = good && is_finite(vertex);
    if (!good || !is_simple(obstacles.polygons[i]))
      throw file_error(name, "polygon " + std::to_string(i) + " is degenerate",
                       "at least 3 finite vertices, positive area and no edges that cross");
  }
}

Bounds bounds_of(const COccupancyGridMap2D& map) {
  const double resolution = map.getResolution();
  Bounds bounds;
  bounds.x_min = map.getXMin();
  bounds.y_min = map.getYMin();
  bounds.x_max = bounds.x_min + map.getSizeX() * resolution;
  bounds.y_max = bounds.y_min + map.getSizeY() * resolution;
  return bounds;
}

/// A copy of the map whose cells are exactly free (1) or occupied (0).
GridMapPtr binarized(const COccupancyGridMap2D& map) {
  auto result = std::make_shared<COccupancyGridMap2D>(one_cell_map());
  result->copyMapContentFrom(map);
  const auto free = COccupancyGridMap2D::p2l(1.0f), occupied = COccupancyGridMap2D::p2l(0.0f);
  const auto unknown = COccupancyGridMap2D::p2l(0.5f);
  for (unsigned cy = 0; cy < result->getSizeY(); ++cy) {
    auto* row = result->getRow(static_cast<int>(cy));
    for (unsigned cx = 0; cx < result->getSizeX(); ++cx)
      row[cx] = row[cx] > unknown ? free : occupied;
  }
  return result;
}

void add_content(Hasher& hasher, const Primitives& obstacles) {
  hasher.add(static_cast<std::uint64_t>(obstacles.discs.size()));
  for (const Disc& disc : obstacles.discs)
    hasher.add(disc.center.x).add(disc.center.y).add(disc.radius);
  hasher.add(static_cast<std::uint64_t>(obstacles.polygons.size()));
  for (const Polygon& polygon : obstacles.polygons) {
    hasher.add(static_cast<std::uint64_t>(polygon.vertices.size()));
    for (const TPoint2D& vertex : polygon.vertices) hasher.add(vertex.x).add(vertex.y);
  }
}

void add_content(Hasher& hasher, const GridMapPtr& map) {
  hasher.add(static_cast<std::uint64_t>(map->getSizeX()));
  hasher.add(static_cast<std::uint64_t>(map->getSizeY()));
  hasher.add(static_cast<double>(map->getResolution()));
  for (unsigned cy = 0; cy < map->getSizeY(); ++cy)
    hasher.add_bytes(map->getRow(static_cast<int>(cy)), map->getSizeX());
}

void add_content(Hasher& hasher, const PointMapPtr& map) {
  const auto &x = map->getPointsBufferRef_x(), &y = map->getPointsBufferRef_y();
  hasher.add(static_cast<std::uint64_t>(x.size()));
  for (std::size_t i = 0; i < x.size(); ++i)
    hasher.add(static_cast<double>(x[i])).add(static_cast<double>(y[i]));
}

void check_points(const std::string& name, const CSimplePointsMap& map) {
  const auto &x = map.getPointsBufferRef_x(), &y = map.getPointsBufferRef_y();
  for (std::size_t i = 0; i < x.size(); ++i)
    if (!std::isfinite(x[i]) || !std::isfinite(y[i]))
      throw file_error(name, "point " + std::to_string(i) + " is not finite", "finite coordinates");
}

}  // namespace

Scenario::Scenario(std::string name, Bounds bounds, Obstacles obstacles, TPose2D start,
                   TPoint2D goal, Rest rest)
    : name_(std::move(name)),
      bounds_(bounds),
      obstacles_(std::move(obstacles)),
      start_(start),
      goal_(goal),
      rest_(std::move(rest)) {
  expect_name(name_, "a scenario");
  check_task(name_, bounds_, start_, goal_);
  check_movers(name_, rest_.movers);
  check_people_among(name_, bounds_, rest_.movers, rest_.people);
  if (rest_.goal_heading && !std::isfinite(*rest_.goal_heading))
    throw file_error(name_, "goal heading is not finite", "a finite angle");
  Hasher hasher;
  hasher.add(to_string(representation()));
  hasher.add(bounds_.x_min).add(bounds_.y_min).add(bounds_.x_max).add(bounds_.y_max);
  std::visit([&](const auto& content) { add_content(hasher, content); }, obstacles_);
  hasher.add(start_.x).add(start_.y).add(start_.phi).add(goal_.x).add(goal_.y);
  if (!rest_.movers.empty()) add_content(hasher, rest_.movers);
  if (!rest_.people.empty()) add_content(hasher, rest_.people);
  if (rest_.goal_heading) hasher.add(std::string("goal_heading")).add(*rest_.goal_heading);
  hash_ = hasher.hex();
}

Scenario Scenario::continuous(std::string name, Bounds bounds, Primitives obstacles, TPose2D start,
                              TPoint2D goal) {
  check_bounds(name, bounds);
  check_primitives(name, obstacles);
  return {std::move(name), bounds, std::move(obstacles), start, goal};
}

Scenario Scenario::grid(std::string name, const COccupancyGridMap2D& map, TPose2D start,
                        TPoint2D goal) {
  const Bounds bounds = bounds_of(map);
  check_bounds(name, bounds);
  return {std::move(name), bounds, binarized(map), start, goal};
}

Scenario Scenario::points(std::string name, Bounds bounds, const CSimplePointsMap& map,
                          TPose2D start, TPoint2D goal) {
  check_bounds(name, bounds);
  check_points(name, map);
  return {std::move(name), bounds, std::make_shared<const CSimplePointsMap>(map), start, goal};
}

Representation Scenario::representation() const {
  return static_cast<Representation>(obstacles_.index());
}

const Primitives& Scenario::primitives() const {
  return std::get<Primitives>(obstacles_);
}
const GridMapPtr& Scenario::grid_map() const {
  return std::get<GridMapPtr>(obstacles_);
}
const PointMapPtr& Scenario::point_map() const {
  return std::get<PointMapPtr>(obstacles_);
}

Scenario Scenario::renamed(std::string name) const {
  Scenario copy = *this;
  expect_name(name, "a scenario");
  copy.name_ = std::move(name);
  return copy;
}

Scenario Scenario::with_start_goal(TPose2D start, TPoint2D goal) const {
  return {name_, bounds_, obstacles_, start, goal, rest_};
}

/// With the published path, which belongs to the static obstacles, start and goal.
Scenario Scenario::with_rest(Rest rest) const {
  Scenario copy(name_, bounds_, obstacles_, start_, goal_, std::move(rest));
  copy.published_path_ = published_path_;
  return copy;
}

Scenario Scenario::with_movers(Movers movers) const {
  if (movers.empty() && rest_.movers.empty()) return *this;
  return with_rest({std::move(movers), rest_.people, rest_.goal_heading});
}

Scenario Scenario::with_people(People people) const {
  if (people.empty() && rest_.people.empty()) return *this;
  return with_rest({rest_.movers, std::move(people), rest_.goal_heading});
}

Scenario Scenario::with_goal_heading(std::optional<double> heading) const {
  if (heading == rest_.goal_heading) return *this;
  return with_rest({rest_.movers, rest_.people, heading});
}

Scenario Scenario::with_rest_of(const Scenario& other) const {
  return with_movers(other.movers())
      .with_people(other.people())
      .with_goal_heading(other.goal_heading());
}

Scenario Scenario::with_published_path(PublishedPathPtr path) const {
  if (path) check_published_path(name_, *path);
  Scenario copy = *this;
  copy.published_path_ = std::move(path);
  return copy;
}

}  // namespace slalom
