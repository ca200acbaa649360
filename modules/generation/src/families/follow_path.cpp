// SPDX-License-Identifier: BSD-3-Clause
#include "straight_path_family.h"

#include <slalom/generation/follow_path.h>

#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr double kMaxHeading = 80;  // deg, so that x increases along the corridor

double dot(const TPoint2D& a, const TPoint2D& b) {
  return a.x * b.x + a.y * b.y;
}

/// The normal to the left of a unit vector.
TPoint2D left_of(const TPoint2D& u) {
  return {-u.y, u.x};
}

struct CenterLine {
  std::vector<TPoint2D> vertices;
  std::vector<TPoint2D> directions;  ///< of the segments, unit vectors
};

/// Headings (deg) of segments, the first along x.
std::vector<double> sample_headings(RandomEngine& engine, const FollowPathOptions& o) {
  std::vector<double> headings = {0};
  const int count = uniform_int(engine, o.min_segments, o.max_segments);
  while (static_cast<int>(headings.size()) < count) {
    const double side = sample_side(engine);
    const double turn = side * uniform_real(engine, o.min_turn_deg, o.max_turn_deg);
    const double turned = headings.back() + turn;
    headings.push_back(std::abs(turned) > kMaxHeading ? headings.back() - turn : turned);
  }
  return headings;
}

/// The least length (m) of a segment from `begin` along `u` whose end is `distance` (m) from `from`
/// as well as all beyond it.
double length_to_reach(const TPoint2D& begin, const TPoint2D& u, const TPoint2D& from,
                       double distance) {
  const TPoint2D before = begin - from;
  const double along = dot(before, u);
  const double square = along * along - dot(before, before) + distance * distance;
  return square > 0 ? std::sqrt(square) - along : 0;
}

CenterLine sample_center_line(RandomEngine& engine, const FollowPathOptions& o) {
  CenterLine line;
  line.vertices = {{0, 0}};
  const std::vector<double> headings = sample_headings(engine, o);
  for (std::size_t i = 0; i < headings.size(); ++i) {
    const auto [s, c] = math::sin_cos(mrpt::DEG2RAD(headings[i]));
    const TPoint2D u{c, s};
    double length = uniform_real(engine, o.min_segment_length, o.max_segment_length);
    if (i + 1 == headings.size()) {
      const double margin = o.start_goal.margin;
      const double reach = length_to_reach(line.vertices.back(), u, {margin, 0},
                                           o.start_goal.min_distance + kRounding);
      length = std::max(length, reach + margin);
    }
    line.directions.push_back(u);
    line.vertices.push_back(line.vertices.back() + u * length);
  }
  return line;
}

/// The line at this distance (m) to the left of the center line, with mitered corners.
std::vector<TPoint2D> beside(const CenterLine& line, double distance) {
  std::vector<TPoint2D> vertices;
  const std::size_t last = line.directions.size();
  for (std::size_t i = 0; i <= last; ++i) {
    const TPoint2D before = left_of(line.directions[i == 0 ? 0 : i - 1]),
                   after = left_of(line.directions[i == last ? last - 1 : i]);
    vertices.push_back(line.vertices[i] + (before + after) * (distance / (1 + dot(before, after))));
  }
  return vertices;
}

/// The polygon between two lines beside the center line.
Polygon strip(const CenterLine& line, double right, double left) {
  Polygon polygon{beside(line, right)};
  const std::vector<TPoint2D> other = beside(line, left);
  polygon.vertices.insert(polygon.vertices.end(), other.rbegin(), other.rend());
  return polygon;
}

/// The walls at both sides and ends of the corridor.
std::vector<Polygon> walls_of(const CenterLine& line, double width, double wall) {
  const double inner = width / 2, outer = inner + wall;
  const TPoint2D first = line.directions.front(), last = line.directions.back();
  const CenterLine before{{line.vertices.front() - first * wall, line.vertices.front()}, {first}};
  const CenterLine behind{{line.vertices.back(), line.vertices.back() + last * wall}, {last}};
  return {strip(line, inner, outer), strip(line, -outer, -inner), strip(before, -outer, outer),
          strip(behind, -outer, outer)};
}

/// The least rectangle around polygons.
Bounds bounds_around(const std::vector<Polygon>& polygons) {
  const TPoint2D& any = polygons.front().vertices.front();
  Bounds bounds = {any.x, any.y, any.x, any.y};
  for (const Polygon& polygon : polygons)
    for (const TPoint2D& v : polygon.vertices)
      bounds = {std::min(bounds.x_min, v.x), std::min(bounds.y_min, v.y),
                std::max(bounds.x_max, v.x), std::max(bounds.y_max, v.y)};
  return bounds;
}

class FollowPathGenerator : public Generator {
 public:
  explicit FollowPathGenerator(const FollowPathOptions& options) : options_(options) {}

  std::string name() const override { return FollowPathOptions::kFamily; }

  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    const FollowPathOptions& o = options_;
    const CenterLine line = sample_center_line(engine, o);
    const double width = uniform_real(engine, o.min_width, o.max_width);
    const double angle = sample_angle(engine, o.angle);
    Primitives walls;
    walls.polygons = walls_of(line, width, o.wall);
    const Bounds around = bounds_around(walls.polygons);
    // The walls are anywhere relative to the cells of grids.
    const double right = uniform_real(engine, 0, o.wall), up = uniform_real(engine, 0, o.wall);
    const TPoint2D shift{right - around.x_min, up - around.y_min};
    for (Polygon& polygon : walls.polygons)
      for (TPoint2D& v : polygon.vertices) v = v + shift;
    const double margin = o.start_goal.margin;
    const TPoint2D start = line.vertices.front() + line.directions.front() * margin + shift;
    const TPoint2D goal = line.vertices.back() - line.directions.back() * margin + shift;
    return Scenario::continuous(scenario_name,
                                {0, 0, around.width() + o.wall, around.height() + o.wall},
                                std::move(walls), {start.x, start.y, angle}, goal);
  }

 private:
  FollowPathOptions options_;
};

}  // namespace

void FollowPathOptions::visit(OptionVisitor& v) {
  v.option("min_segments", min_segments, "-", "minimum number of straight segments",
           Range::between(1, 1000));
  v.option("max_segments", max_segments, "-", "maximum number of straight segments",
           Range::between(1, 1000));
  v.option("min_segment_length", min_segment_length, "m", "minimum length of a segment",
           Range::positive());
  v.option("max_segment_length", max_segment_length, "m", "maximum length of a segment",
           Range::positive());
  v.option("min_turn_deg", min_turn_deg, "deg", "minimum angle between consecutive segments",
           Range::between(0, kMaxHeading));
  v.option("max_turn_deg", max_turn_deg, "deg", "maximum angle between consecutive segments",
           Range::between(0, kMaxHeading));
  v.option("min_width", min_width, "m", "minimum clear width of the corridor", Range::positive());
  v.option("max_width", max_width, "m", "maximum clear width of the corridor", Range::positive());
  v.option("wall", wall, "m", "thickness of the walls", Range::positive());
  angle.visit(v);
  start_goal.visit(v);
}

std::unique_ptr<Generator> make_generator(const FollowPathOptions& given,
                                          const GeneratorContext& context) {
  const FamilyChecks checks(FollowPathOptions::kFamily, context);
  const auto o = checks.scaled(given);
  checks.expect_order("min_segments", o.min_segments, "max_segments", o.max_segments);
  checks.expect_order("min_segment_length", o.min_segment_length, "max_segment_length",
                      o.max_segment_length);
  checks.expect_order("min_turn_deg", o.min_turn_deg, "max_turn_deg", o.max_turn_deg);
  checks.expect_order("min_width", o.min_width, "max_width", o.max_width);
  expect_valid(checks, o.angle);
  // On the inner side of two equal turns a segment is shorter. As long as none vanishes, all lines
  // beside the center line have the headings of the segments, and x increases along them.
  const auto [s, c] = math::sin_cos(mrpt::DEG2RAD(o.max_turn_deg) / 2);
  const double shortest = (o.max_width + 2 * o.wall) * s / c;
  checks.expect(o.min_segment_length > shortest, "min_segment_length",
                "leaves no wall between two turns", "more than " + format_number(shortest));
  checks.expect(2 * o.start_goal.margin < o.min_segment_length, "margin",
                "places start and goal outside the first and last segment",
                "less than half of min_segment_length");
  const double longest = o.max_segments * o.max_segment_length - 2 * o.start_goal.margin;
  checks.expect(o.start_goal.min_distance <= longest, "min_distance",
                "start and goal cannot be min_distance apart in the longest corridor",
                "at most " + format_number(longest));
  checks.expect(o.start_goal.clear_radius <= std::min(o.min_width / 2, o.start_goal.margin),
                "clear_radius", "reaches the walls", "at most margin and half of min_width");
  return std::make_unique<FollowPathGenerator>(o);
}

}  // namespace slalom
