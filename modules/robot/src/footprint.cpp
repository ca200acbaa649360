#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/robot/footprint.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

constexpr std::size_t kMaxCorners = 64;

double cross(const TPoint2D& a, const TPoint2D& b) {
  return a.x * b.y - a.y * b.x;
}

std::vector<TPoint2D> parse_corners(const std::string& text) {
  std::vector<TPoint2D> corners;
  for (const std::string& part : split(text, ';')) {
    const std::vector<std::string> numbers = split(part, ',');
    TPoint2D corner;
    if (numbers.size() != 2 || !parse_number(numbers[0], corner.x) ||
        !parse_number(numbers[1], corner.y))
      throw std::invalid_argument("corners x,y in m, separated by ';'");
    corners.push_back(corner);
  }
  if (corners.size() < 3 || corners.size() > kMaxCorners)
    throw std::invalid_argument("3 to " + std::to_string(kMaxCorners) + " corners");
  return corners;
}

double signed_area(const std::vector<TPoint2D>& corners) {
  double twice = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    twice += cross(corners[i], corners[(i + 1) % corners.size()]);
  return 0.5 * twice;
}

/// Whether the polygon turns left at every corner, by 2 pi in total.
bool is_convex(const std::vector<TPoint2D>& corners) {
  const std::size_t n = corners.size();
  double total = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const TPoint2D in = corners[(i + 1) % n] - corners[i];
    const TPoint2D out = corners[(i + 2) % n] - corners[(i + 1) % n];
    if (!(cross(in, out) > 0)) return false;
    total += std::atan2(cross(in, out), in.x * out.x + in.y * out.y);
  }
  return total < 7;  // 2 pi, not 4 pi as in a star
}

}  // namespace

Footprint Footprint::disc(double radius) {
  Footprint footprint;
  footprint.inscribed_ = footprint.enclosing_ = radius;
  return footprint;
}

Footprint Footprint::parse(const std::string& text) {
  Footprint footprint;
  footprint.corners_ = parse_corners(text);
  auto& corners = footprint.corners_;
  if (signed_area(corners) < 0) std::reverse(corners.begin(), corners.end());
  if (!is_convex(corners)) throw std::invalid_argument("a convex polygon");
  footprint.inscribed_ = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const TPoint2D& a = corners[i];
    const TPoint2D edge = corners[(i + 1) % corners.size()] - a;
    footprint.inscribed_ = std::min(footprint.inscribed_, cross(a, edge) / edge.norm());
    footprint.enclosing_ = std::max(footprint.enclosing_, a.norm());
  }
  if (!(footprint.inscribed_ > 0))
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

std::vector<TPoint2D> Footprint::corners_at(const TPose2D& pose) const {
  const double c = std::cos(pose.phi), s = std::sin(pose.phi);
  std::vector<TPoint2D> transformed;
  transformed.reserve(corners_.size());
  for (const TPoint2D& p : corners_)
    transformed.emplace_back(pose.x + c * p.x - s * p.y, pose.y + s * p.x + c * p.y);
  return transformed;
}

}  // namespace slalom
