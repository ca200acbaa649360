#include "cell_parts.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/scenario/contours.h>

#include <boost/geometry/algorithms/simplify.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/strategies/strategies.hpp>

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// What lies beyond a piece of outline: free cells, another part of the same obstacle, or the wall
/// round the workspace.
enum class Beyond { Free, Part, Wall };

/// A straight piece of an outline from a corner of the lattice on, the part to its left.
struct Stretch {
  CellPlace from, direction;
  Beyond beyond;
};

/// A vertex in cells; fixed where it belongs to a cut or to the border of the workspace.
struct Vertex {
  TPoint2D at;
  bool fixed;
};

CellPlace left_of(const CellPlace& direction) {
  return {-direction.cy, direction.cx};
}

/// The outline of one part, counter-clockwise from its first cell's lower left corner.
class OutlineWalk {
 public:
  OutlineWalk(const CellParts& parts, std::int32_t part) : parts_(parts), part_(part) {}

  std::vector<Stretch> stretches() const {
    std::vector<Stretch> all;
    const CellPlace begin = parts_.first_cells()[static_cast<std::size_t>(part_)];
    CellPlace at = begin, direction{1, 0};
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
  static CellPlace ahead(const CellPlace& corner, const CellPlace& direction, bool right) {
    const CellPlace left = left_of(direction);
    const int side = right ? -1 : 1;
    return {corner.cx + (direction.cx + side * left.cx - 1) / 2,
            corner.cy + (direction.cy + side * left.cy - 1) / 2};
  }

  Beyond beyond_of(const CellPlace& corner, const CellPlace& direction) const {
    const CellPlace cell = ahead(corner, direction, true);
    if (!parts_.cells().inside(cell.cx, cell.cy)) return Beyond::Wall;
    return parts_.cells().occupied(cell.cx, cell.cy) ? Beyond::Part : Beyond::Free;
  }

  /// Cells that meet at a corner only are kept apart: where both ways are open, to the left.
  CellPlace next_direction(const CellPlace& corner, const CellPlace& direction) const {
    const CellPlace left = left_of(direction);
    const CellPlace ahead_left = ahead(corner, direction, false);
    if (!parts_.belongs(ahead_left.cx, ahead_left.cy, part_)) return left;
    const CellPlace ahead_right = ahead(corner, direction, true);
    if (parts_.belongs(ahead_right.cx, ahead_right.cy, part_)) return {-left.cx, -left.cy};
    return direction;
  }

  const CellParts& parts_;
  const std::int32_t part_;
};

/// How far a stretch moves to its left: inwards from free cells, over a cut into the next part.
double shift(const Stretch& stretch) {
  if (stretch.beyond == Beyond::Wall) return 0;
  return stretch.beyond == Beyond::Free ? kContourInset : -kContourInset;
}

/// Where two stretches meet after each was shifted. Only one along a row can change what lies
/// beyond it without a corner: there the step stands within the solid side.
void add_joint(const Stretch& a, const Stretch& b, std::vector<Vertex>& vertices) {
  const bool fixed = a.beyond != Beyond::Free || b.beyond != Beyond::Free;
  const CellPlace left_a = left_of(a.direction), left_b = left_of(b.direction);
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
  const std::vector<Stretch> stretches = OutlineWalk(parts, part).stretches();
  std::vector<Vertex> vertices;
  for (std::size_t i = 0; i < stretches.size(); ++i)
    add_joint(stretches[i], stretches[(i + 1) % stretches.size()], vertices);
  return vertices;
}

/// Fixes two vertices far apart where none is: a closed line is simplified piece by piece.
void fix_ends(std::vector<Vertex>& vertices) {
  std::size_t farthest = 0;
  double distance = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (vertices[i].fixed) return;
    const TPoint2D gap = vertices[i].at - vertices[0].at;
    if (std::hypot(gap.x, gap.y) <= distance) continue;
    distance = std::hypot(gap.x, gap.y);
    farthest = i;
  }
  vertices[0].fixed = vertices[farthest].fixed = true;
}

using Line = boost::geometry::model::linestring<boost::geometry::model::d2::point_xy<double>>;

/// The vertices that remain, tolerance in cells. The lines between fixed vertices are simplified
/// each for itself (Douglas and Peucker), cuts and borders not at all.
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

/// Simplifying may let an outline cross itself: then less of it is asked for.
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
