// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/text.h>
#include <slalom/robot/footprint.h>

// Keeps a note about a header of Boost 1.74 that its own geometry includes out of the build.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry/algorithms/convex_hull.hpp>
#include <boost/geometry/algorithms/intersects.hpp>
#include <boost/geometry/geometries/multi_point.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>
#include <boost/geometry/geometries/segment.hpp>
#include <boost/geometry/strategies/strategies.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

constexpr std::size_t kMaxCorners = 64;

double cross(const TPoint2D& a, const TPoint2D& b) {
  return a.x * b.y - a.y * b.x;
}

/// A corner as it was written.
struct Corner {
  TPoint2D point;
  std::size_t number = 0;  // from 1
};

/// The texts "x, y" of "x, y; x, y; ..." or, as ROS has it, of "[[x, y], [x, y], ...]".
std::vector<std::string> corner_texts(const std::string& text) {
  const std::string list = trim(text);
  if (!starts_with(list, "[") || !ends_with(list, "]")) return split(list, ';');
  std::vector<std::string> parts = split(list.substr(1, list.size() - 2), ']');
  if (parts.empty() || !parts.back().empty()) return {""};
  parts.pop_back();
  for (std::string& part : parts) {
    const std::string opening = &part == &parts.front() ? "" : ",";
    const std::size_t bracket = part.find('[');
    if (bracket == std::string::npos || trim(part.substr(0, bracket)) != opening) return {""};
    part.erase(0, bracket + 1);
  }
  return parts;
}

std::vector<Corner> parse_corners(const std::string& text) {
  std::vector<Corner> corners;
  for (const std::string& part : corner_texts(text)) {
    const std::vector<std::string> numbers = split(part, ',');
    Corner corner{{}, corners.size() + 1};
    if (numbers.size() != 2 || !parse_number(numbers[0], corner.point.x) ||
        !parse_number(numbers[1], corner.point.y))
      throw std::invalid_argument("corners x,y in m, separated by ';', or [[x, y], [x, y], ...]");
    corners.push_back(corner);
  }
  if (corners.size() < 3 || corners.size() > kMaxCorners)
    throw std::invalid_argument("3 to " + std::to_string(kMaxCorners) + " corners");
  return corners;
}

/// The sides that meet at corner i.
std::pair<TPoint2D, TPoint2D> sides_at(const std::vector<Corner>& corners, std::size_t i) {
  const std::size_t n = corners.size();
  const TPoint2D& point = corners[i].point;
  return {point - corners[(i + n - 1) % n].point, corners[(i + 1) % n].point - point};
}

/// Whether two sides are one, but for the rounding of the corners: by the distance of the corner
/// from the line through its neighbors, since very long polygons turn by tiny angles.
bool is_straight(const TPoint2D& in, const TPoint2D& out) {
  constexpr double kRounding = 1e-9;  // m
  const double ahead = in.x * out.x + in.y * out.y;
  return ahead > 0 && std::abs(cross(in, out)) <= kRounding * (in + out).norm();
}

/// Drops corners that do not change the shape: those that repeat their predecessor, as the first of
/// a closed polygon does, and those on a straight side.
std::vector<Corner> without_needless(const std::vector<Corner>& corners) {
  std::vector<Corner> distinct, needed;
  for (const Corner& corner : corners)
    if (distinct.empty() || !(corner.point == distinct.back().point)) distinct.push_back(corner);
  while (distinct.size() > 1 && distinct.back().point == distinct.front().point)
    distinct.pop_back();
  for (std::size_t i = 0; i < distinct.size(); ++i) {
    const auto [in, out] = sides_at(distinct, i);
    if (!is_straight(in, out)) needed.push_back(distinct[i]);
  }
  return needed;
}

double signed_area(const std::vector<Corner>& corners) {
  double twice = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    twice += cross(corners[i].point, corners[(i + 1) % corners.size()].point);
  return 0.5 * twice;
}

/// "corner 2, 0,0.1".
std::string name_of(const Corner& corner) {
  return "corner " + std::to_string(corner.number) + ", " + format_number(corner.point.x) + "," +
         format_number(corner.point.y);
}

/// Whether no sides but neighbors have a common point, and these only their corner. Throws
/// std::invalid_argument otherwise.
void check_simple(const std::vector<Corner>& corners) {
  using Point = boost::geometry::model::d2::point_xy<double>;
  using Side = boost::geometry::model::segment<Point>;
  const std::string expected = "a polygon whose sides do not meet (";
  const std::size_t n = corners.size();
  if (n < 3) throw std::invalid_argument(expected + "these are on one line)");
  const auto side = [&](std::size_t i) {
    const TPoint2D &from = corners[i].point, &to = corners[(i + 1) % n].point;
    return Side({from.x, from.y}, {to.x, to.y});
  };
  for (std::size_t i = 0; i < n; ++i) {
    const auto [in, out] = sides_at(corners, i);
    if (is_straight(in, TPoint2D(-out.x, -out.y)))
      throw std::invalid_argument(expected + "it goes back at " + name_of(corners[i]) + ")");
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n && j + 1 < n + i; ++j)
      if (boost::geometry::intersects(side(i), side(j)))
        throw std::invalid_argument(expected + "those from " + name_of(corners[i]) + " and from " +
                                    name_of(corners[j]) + " do)");
}

/// Whether a counter-clockwise polygon turns left at all corners.
bool is_convex(const std::vector<TPoint2D>& corners) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i)
    if (!(cross(corners[i] - corners[(i + n - 1) % n], corners[(i + 1) % n] - corners[i]) > 0))
      return false;
  return true;
}

/// Whether the center is inside, by the sides above it (even-odd rule).
bool contains_center(const std::vector<TPoint2D>& corners) {
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const TPoint2D &a = corners[i], &b = corners[(i + 1) % corners.size()];
    if ((a.x > 0) != (b.x > 0) && (cross(a, b - a) > 0) == (b.x < a.x)) inside = !inside;
  }
  return inside;
}

/// Distance (m) of the center from a side.
double distance_to_side(const TPoint2D& a, const TPoint2D& b) {
  const TPoint2D side = b - a;
  const double along = -(a.x * side.x + a.y * side.y);
  if (along < 0) return a.norm();
  if (along > side.x * side.x + side.y * side.y) return b.norm();
  return std::abs(cross(a, side)) / side.norm();
}

}  // namespace

std::vector<TPoint2D> convex_hull(const std::vector<TPoint2D>& points) {
  using Point = boost::geometry::model::d2::point_xy<double>;
  boost::geometry::model::multi_point<Point> cloud;
  for (const TPoint2D& point : points) cloud.emplace_back(point.x, point.y);
  boost::geometry::model::ring<Point, false, false> ring;  // counter-clockwise, open
  boost::geometry::convex_hull(cloud, ring);
  std::vector<TPoint2D> hull;
  for (const Point& point : ring) hull.emplace_back(point.x(), point.y());
  return hull;
}

Footprint Footprint::disc(double radius) {
  Footprint footprint;
  footprint.inscribed_ = footprint.enclosing_ = radius;
  return footprint;
}

Footprint Footprint::parse(const std::string& text) {
  Footprint footprint;
  std::vector<Corner> written = without_needless(parse_corners(text));
  if (signed_area(written) < 0) std::reverse(written.begin(), written.end());
  check_simple(written);
  auto& corners = footprint.corners_;
  for (const Corner& corner : written) corners.push_back(corner.point);
  footprint.hull_ = is_convex(corners) ? corners : convex_hull(corners);
  footprint.inscribed_ = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const TPoint2D &a = corners[i], &b = corners[(i + 1) % corners.size()];
    footprint.inscribed_ = std::min(footprint.inscribed_, distance_to_side(a, b));
    footprint.enclosing_ = std::max(footprint.enclosing_, a.norm());
  }
  if (!(footprint.inscribed_ > 0) || !contains_center(corners))
    throw std::invalid_argument("a polygon around the robot's center (0, 0)");
  return footprint;
}

Footprint Footprint::parse(const std::string& text, const std::string& where) {
  try {
    return parse(text);
  } catch (const std::invalid_argument& expected) {
    throw usage_error(where, "invalid footprint '" + text + "'", expected.what());
  }
}

double Footprint::half_width() const {
  double width = is_disc() ? enclosing_ : 0;
  for (const TPoint2D& corner : corners_) width = std::max(width, std::abs(corner.y));
  return width;
}

std::vector<TPoint2D> Footprint::corners_at(const TPose2D& pose) const {
  const auto [s, c] = math::sin_cos(pose.phi);
  std::vector<TPoint2D> transformed;
  transformed.reserve(corners_.size());
  for (const TPoint2D& p : corners_)
    transformed.emplace_back(pose.x + c * p.x - s * p.y, pose.y + s * p.x + c * p.y);
  return transformed;
}

double passing_radius(double radius, const std::optional<Footprint>& turning_polygon) {
  return turning_polygon ? turning_polygon->half_width() : radius;
}

}  // namespace slalom
