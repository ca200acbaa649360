// SPDX-License-Identifier: BSD-3-Clause
#include "views/shapes.h"
#include "widgets/drawing.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nanovg.h>

namespace slalom::shapes {

using mrpt::math::TPoint2D;

namespace {

/// Robots, starts and goals are drawn with at least this radius (pixels).
constexpr double kMinRadius = 5;

void trace(NVGcontext* ctx, const ViewTransform& view, const std::vector<TPoint2D>& points) {
  nvgBeginPath(ctx);
  TPoint2D last;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const TPoint2D at = view.to_screen(points[i]);
    const bool same_pixel = i > 0 && math::hypot(at.x - last.x, at.y - last.y) < 1;
    if (same_pixel && i + 1 < points.size()) continue;
    (i == 0 ? nvgMoveTo : nvgLineTo)(ctx, static_cast<float>(at.x), static_cast<float>(at.y));
    last = at;
  }
}

void trace_disc(NVGcontext* ctx, const ViewTransform& view, const Disc& disc, double min_radius) {
  const TPoint2D at = view.to_screen(disc.center);
  nvgBeginPath(ctx);
  nvgCircle(ctx, static_cast<float>(at.x), static_cast<float>(at.y),
            static_cast<float>(std::max(disc.radius * view.pixels_per_meter(), min_radius)));
}

void stroke(NVGcontext* ctx, const Color& color, float width) {
  nvgLineJoin(ctx, NVG_ROUND);
  nvgLineCap(ctx, NVG_ROUND);
  draw::stroke_path(ctx, color, width);
}

}  // namespace

void polyline(NVGcontext* ctx, const ViewTransform& view, const std::vector<TPoint2D>& points,
              const Color& color, float width, bool closed) {
  if (points.size() < 2) return;
  trace(ctx, view, points);
  if (closed) nvgClosePath(ctx);
  stroke(ctx, color, width);
}

void fill_polygon(NVGcontext* ctx, const ViewTransform& view, const std::vector<TPoint2D>& vertices,
                  const Color& color) {
  if (vertices.size() < 3) return;
  trace(ctx, view, vertices);
  nvgClosePath(ctx);
  draw::fill_path(ctx, color);
}

void dots(NVGcontext* ctx, const ViewTransform& view, const std::vector<TPoint2D>& points,
          const Color& color, float side) {
  if (points.empty()) return;  // NanoVG would fill the whole window with an empty path
  nvgBeginPath(ctx);
  for (const TPoint2D& point : points) {
    const TPoint2D p = view.to_screen(point);
    nvgRect(ctx, static_cast<float>(p.x) - 0.5F * side, static_cast<float>(p.y) - 0.5F * side, side,
            side);
  }
  draw::fill_path(ctx, color);
}

void fill_disc(NVGcontext* ctx, const ViewTransform& view, const Disc& disc, const Color& color,
               double min_radius) {
  trace_disc(ctx, view, disc, min_radius);
  draw::fill_path(ctx, color);
}

void circle(NVGcontext* ctx, const ViewTransform& view, const Disc& disc, const Color& color,
            float width, double min_radius) {
  trace_disc(ctx, view, disc, min_radius);
  stroke(ctx, color, width);
}

void robot(NVGcontext* ctx, const ViewTransform& view, const Footprint& footprint,
           const mrpt::math::TPose2D& pose, const Color& color) {
  const double radius = footprint.enclosing_radius();
  const bool tiny = radius * view.pixels_per_meter() < kMinRadius;
  if (footprint.is_disc() || tiny) {
    const Disc disc{{pose.x, pose.y}, radius};
    fill_disc(ctx, view, disc, faded(color, 0.3), kMinRadius);
    circle(ctx, view, disc, color, 2, kMinRadius);
  } else {
    const std::vector<TPoint2D> corners = footprint.corners_at(pose);
    fill_polygon(ctx, view, corners, faded(color, 0.3));
    polyline(ctx, view, corners, color, 2, true);
  }
  const double length = 1.6 * std::max(radius, kMinRadius / view.pixels_per_meter());
  polyline(ctx, view,
           {{pose.x, pose.y},
            {pose.x + length * math::cos(pose.phi), pose.y + length * math::sin(pose.phi)}},
           color, 2);
}

namespace {

/// Right of a point, over a light background.
void label(NVGcontext* ctx, const TPoint2D& at, const std::string& text, const Color& color,
           bool bold) {
  constexpr double kHeight = 16, kWidth = 160;
  draw::text(ctx, {at.x, at.y - 0.5 * kHeight, kWidth, kHeight}, text, color, draw::kSmallTextSize,
             draw::Align::Left, bold);
}

void waypoint_times(NVGcontext* ctx, const ViewTransform& view, const Mover& mover) {
  constexpr double kApart = 30, kBeside = 5;  // pixels
  std::vector<TPoint2D> labeled;
  for (const Waypoint& waypoint : mover.waypoints) {
    const TPoint2D at = view.to_screen(waypoint.position);
    const bool crowded = std::any_of(labeled.begin(), labeled.end(), [&at](const TPoint2D& other) {
      return math::hypot(at.x - other.x, at.y - other.y) < kApart;
    });
    if (crowded) continue;
    labeled.push_back(at);
    char text[48];
    std::snprintf(text, sizeof text, "%.3g s", waypoint.t);
    label(ctx, {at.x + kBeside, at.y + 2 * kBeside}, text, palette().mover_path, false);
  }
}

/// Its disc with its id, if it is present.
void moving_disc(NVGcontext* ctx, const ViewTransform& view, const Mover& mover, double time,
                 const Color& color, const Color& edge) {
  constexpr double kMinPixels = 3;
  if (!mover.present(time)) return;
  const Disc disc{mover.position(time), mover.radius};
  fill_disc(ctx, view, disc, faded(color, 0.85), kMinPixels);
  circle(ctx, view, disc, edge, 1.5F, kMinPixels);
  const TPoint2D center = view.to_screen(disc.center);
  const double radius = std::max(kMinPixels, disc.radius * view.pixels_per_meter());
  label(ctx, {center.x + radius + 3, center.y - 6}, mover.id, edge, true);
}

std::vector<TPoint2D> path_of(const Mover& mover) {
  std::vector<TPoint2D> path;
  for (const Waypoint& waypoint : mover.waypoints) path.push_back(waypoint.position);
  return path;
}

}  // namespace

void mover(NVGcontext* ctx, const ViewTransform& view, const Mover& mover, double time,
           const Color& color) {
  const std::vector<TPoint2D> path = path_of(mover);
  polyline(ctx, view, path, faded(palette().mover_path, 0.5), 1.5F);
  moving_disc(ctx, view, mover, time, color, palette().mover_path);
  dots(ctx, view, path, palette().mover_path, 4);
  waypoint_times(ctx, view, mover);
}

void person(NVGcontext* ctx, const ViewTransform& view, const Person& person, const Mover& record,
            double time) {
  const std::vector<TPoint2D> route = stations_of(person);
  const Color& edge = palette().person_path;
  polyline(ctx, view, record.waypoints.size() > 1 ? path_of(record) : route, faded(edge, 0.5),
           1.5F);
  moving_disc(ctx, view, record, time, palette().person, edge);
  if (time < record.waypoints.front().t)
    circle(ctx, view, {person.start, person.radius}, faded(edge, 0.5), 1.5F, 3);
  dots(ctx, view, route, edge, 4);
}

void goal(NVGcontext* ctx, const ViewTransform& view, const TPoint2D& at,
          const std::optional<double>& heading, double radius, const Color& color) {
  circle(ctx, view, {at, radius}, color, 2, kMinRadius);
  const double r = std::max(radius, kMinRadius / view.pixels_per_meter());
  polyline(ctx, view, {{at.x - r, at.y}, {at.x + r, at.y}}, color, 2);
  polyline(ctx, view, {{at.x, at.y - r}, {at.x, at.y + r}}, color, 2);
  if (!heading) return;
  const double tip = 1.6 * r;
  polyline(ctx, view, {at, {at.x + tip * math::cos(*heading), at.y + tip * math::sin(*heading)}},
           color, 2);
}

}  // namespace slalom::shapes
