// SPDX-License-Identifier: BSD-3-Clause
#include "cell_parts.h"
#include "contours.h"

#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/text.h>

#include <boost/geometry/algorithms/simplify.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/strategies/strategies.hpp>

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// The other side of an outline segment: free cells, another part of the same obstacle, or the
/// border of the workspace.
enum class Beyond { Free, Part, Wall };

/// A straight segment of an outline that starts at a cell corner, with the part on its left.
struct Segment {
  CellIndex from, direction;
  Beyond beyond;
};

/// A vertex in cells; fixed if it belongs to a cut or to the border of the workspace.
struct Vertex {
  TPoint2D at;
  bool fixed;
};

CellIndex left_of(const CellIndex& direction) {
  return {-direction.cy, direction.cx};
}

/// The outline of one part, counter-clockwise from its first cell's lower left corner.
class OutlineTracer {
 public:
  OutlineTracer(const CellParts& parts, std::int32_t part) : parts_(parts), part_(part) {}

  std::vector<Segment> segments() const {
    std::vector<Segment> all;
    const CellIndex begin = parts_.first_cells()[static_cast<std::size_t>(part_)];
    CellIndex at = begin, direction{1, 0};
    do {
      const Beyond beyond = beyond_of(at, direction);
      if (all.empty() || all.back().beyond != beyond || all.back().direction.cx != direction.cx ||
          all.back().direction.cy != direction.cy)
        all.push_back({at, direction, beyond});
      at = {at.cx + direction.cx, at.cy + direction.cy};
      direction = next_direction(at, direction);
    } while (at.cx != begin.cx || at.cy != begin.cy);
    return all;
  }

 private:
  /// The cell ahead of a corner, to the left (0) or right (1) of a direction.
  static CellIndex ahead(const CellIndex& corner, const CellIndex& direction, bool right) {
    const CellIndex left = left_of(direction);
    const int side = right ? -1 : 1;
    return {corner.cx + (direction.cx + side * left.cx - 1) / 2,
            corner.cy + (direction.cy + side * left.cy - 1) / 2};
  }

  Beyond beyond_of(const CellIndex& corner, const CellIndex& direction) const {
    const CellIndex cell = ahead(corner, direction, true);
    if (!parts_.cells().inside(cell.cx, cell.cy)) return Beyond::Wall;
    return parts_.cells().occupied(cell.cx, cell.cy) ? Beyond::Part : Beyond::Free;
  }

  /// Cells that meet only at a corner are kept separate: turns left where both turns are possible.
  CellIndex next_direction(const CellIndex& corner, const CellIndex& direction) const {
    const CellIndex left = left_of(direction);
    const CellIndex ahead_left = ahead(corner, direction, false);
    if (!parts_.belongs(ahead_left.cx, ahead_left.cy, part_)) return left;
    const CellIndex ahead_right = ahead(corner, direction, true);
    if (parts_.belongs(ahead_right.cx, ahead_right.cy, part_)) return {-left.cx, -left.cy};
    return direction;
  }

  const CellParts& parts_;
  const std::int32_t part_;
};

/// Offset (cells) of a segment to its left: inwards at free cells, across a cut into the next part.
double shift(const Segment& segment) {
  if (segment.beyond == Beyond::Wall) return 0;
  return segment.beyond == Beyond::Free ? kContourInset : -kContourInset;
}

/// The intersection of two segments after each was shifted. Only segments along a row can change
/// the other side without a corner; the step is then on the occupied side.
void add_joint(const Segment& a, const Segment& b, std::vector<Vertex>& vertices) {
  const bool fixed = a.beyond != Beyond::Free || b.beyond != Beyond::Free;
  const CellIndex left_a = left_of(a.direction), left_b = left_of(b.direction);
  TPoint2D corner(b.from.cx, b.from.cy);
  if (a.direction.cx == b.direction.cx && a.direction.cy == b.direction.cy) {
    corner.x += (a.beyond == Beyond::Free ? kContourInset : -kContourInset) * a.direction.cx;
    vertices.push_back({{corner.x, corner.y + shift(a) * left_a.cy}, true});
    vertices.push_back({{corner.x, corner.y + shift(b) * left_b.cy}, true});
    return;
  }
  corner.x += shift(a) * left_a.cx + shift(b) * left_b.cx;
  corner.y += shift(a) * left_a.cy + shift(b) * left_b.cy;
  vertices.push_back({corner, fixed});
}

std::vector<Vertex> outline(const CellParts& parts, std::int32_t part) {
  const std::vector<Segment> segments = OutlineTracer(parts, part).segments();
  std::vector<Vertex> vertices;
  for (std::size_t i = 0; i < segments.size(); ++i)
    add_joint(segments[i], segments[(i + 1) % segments.size()], vertices);
  return vertices;
}

/// Fixes two distant vertices if none is fixed: a closed line is simplified in pieces.
void fix_ends(std::vector<Vertex>& vertices) {
  std::size_t farthest = 0;
  double distance = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (vertices[i].fixed) return;
    const TPoint2D gap = vertices[i].at - vertices[0].at;
    if (math::hypot(gap.x, gap.y) <= distance) continue;
    distance = math::hypot(gap.x, gap.y);
    farthest = i;
  }
  vertices[0].fixed = vertices[farthest].fixed = true;
}

using Line = boost::geometry::model::linestring<boost::geometry::model::d2::point_xy<double>>;

/// The simplified polygon, tolerance in cells. Lines between fixed vertices are simplified
/// separately (Douglas and Peucker), cuts and borders are kept.
Polygon simplified(const std::vector<Vertex>& vertices, double tolerance) {
  Polygon polygon;
  std::size_t begin = 0;
  while (!vertices[begin].fixed) ++begin;
  Line line, simple;
  for (std::size_t i = 0; i <= vertices.size(); ++i) {
    const Vertex& vertex = vertices[(begin + i) % vertices.size()];
    line.emplace_back(vertex.at.x, vertex.at.y);
    if (!vertex.fixed || i == 0) continue;
    simple.clear();
    boost::geometry::simplify(line, simple, tolerance);
    for (std::size_t k = 0; k + 1 < simple.size(); ++k)
      polygon.vertices.emplace_back(simple[k].x(), simple[k].y());
    line.erase(line.begin(), line.end() - 1);
  }
  return polygon;
}

/// Simplification may make an outline intersect itself: the tolerance is then reduced.
Polygon make_polygon(std::vector<Vertex> vertices, double tolerance) {
  Polygon polygon;
  if (tolerance > 0) {
    fix_ends(vertices);
    for (double allowed = tolerance; allowed > tolerance / 32; allowed /= 2)
      if (is_simple(polygon = simplified(vertices, allowed))) return polygon;
  }
  polygon.vertices.clear();
  for (const Vertex& vertex : vertices) polygon.vertices.push_back(vertex.at);
  return polygon;
}

}  // namespace

std::vector<Polygon> trace_contours(const Occupancy& cells, double tolerance) {
  if (!(tolerance >= 0) || !std::isfinite(tolerance))
    throw usage_error("tolerance", format_number(tolerance) + " m", "a length of 0 m or more");
  const double in_cells = tolerance / cells.resolution() - std::sqrt(2.0) * kContourInset;
  const CellParts parts(cells);
  std::vector<Polygon> polygons;
  for (std::size_t i = 0; i < parts.first_cells().size(); ++i) {
    polygons.push_back(make_polygon(outline(parts, static_cast<std::int32_t>(i)), in_cells));
    for (TPoint2D& vertex : polygons.back().vertices) vertex = cells.to_world(vertex.x, vertex.y);
  }
  return polygons;
}

}  // namespace slalom
