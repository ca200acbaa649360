#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <nanovg.h>

namespace slalom::shapes {

using mrpt::math::TPoint2D;

namespace {

/// From afar robots, starts and goals are still drawn with this radius (pixels).
constexpr double kLeastRadius = 5;

void trace(NVGcontext* ctx, const ViewTransform& view, const std::vector<TPoint2D>& points) {
  nvgBeginPath(ctx);
  TPoint2D last;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const TPoint2D at = view.to_screen(points[i]);
    const bool near = i > 0 && std::hypot(at.x - last.x, at.y - last.y) < 1;
    if (near && i + 1 < points.size()) continue;
    (i == 0 ? nvgMoveTo : nvgLineTo)(ctx, static_cast<float>(at.x), static_cast<float>(at.y));
    last = at;
  }
}

void trace_disc(NVGcontext* ctx, const ViewTransform& view, const Disc& disc, double least) {
  const TPoint2D at = view.to_screen(disc.center);
  nvgBeginPath(ctx);
  nvgCircle(ctx, static_cast<float>(at.x), static_cast<float>(at.y),
            static_cast<float>(std::max(disc.radius * view.pixels_per_metre(), least)));
}

void stroke(NVGcontext* ctx, const nanogui::Color& color, float width) {
  nvgStrokeColor(ctx, color);
  nvgStrokeWidth(ctx, width);
  nvgLineJoin(ctx, NVG_ROUND);
  nvgLineCap(ctx, NVG_ROUND);
  nvgStroke(ctx);
}

}  // namespace

void polyline(NVGcontext* ctx, const ViewTransform& view, const std::vector<TPoint2D>& points,
              const nanogui::Color& color, float width, bool closed) {
  if (points.size() < 2) return;
  trace(ctx, view, points);
  if (closed) nvgClosePath(ctx);
  stroke(ctx, color, width);
}

void fill_polygon(NVGcontext* ctx, const ViewTransform& view, const std::vector<TPoint2D>& vertices,
                  const nanogui::Color& color) {
  if (vertices.size() < 3) return;
  trace(ctx, view, vertices);
  nvgClosePath(ctx);
  nvgFillColor(ctx, color);
  nvgFill(ctx);
}

void dots(NVGcontext* ctx, const ViewTransform& view, const std::vector<TPoint2D>& points,
          const nanogui::Color& color, float side) {
  if (points.empty()) return;  // NanoVG would fill the whole window with nothing
  nvgBeginPath(ctx);
  for (const TPoint2D& point : points) {
    const TPoint2D p = view.to_screen(point);
    nvgRect(ctx, static_cast<float>(p.x) - 0.5F * side, static_cast<float>(p.y) - 0.5F * side, side,
            side);
  }
  nvgFillColor(ctx, color);
  nvgFill(ctx);
}

void fill_disc(NVGcontext* ctx, const ViewTransform& view, const Disc& disc,
               const nanogui::Color& color, double least) {
  trace_disc(ctx, view, disc, least);
  nvgFillColor(ctx, color);
  nvgFill(ctx);
}

void circle(NVGcontext* ctx, const ViewTransform& view, const Disc& disc,
            const nanogui::Color& color, float width, double least) {
  trace_disc(ctx, view, disc, least);
  stroke(ctx, color, width);
}

void robot(NVGcontext* ctx, const ViewTransform& view, const Footprint& footprint,
           const mrpt::math::TPose2D& pose, const nanogui::Color& color) {
  const double radius = footprint.enclosing_radius();
  const bool tiny = radius * view.pixels_per_metre() < kLeastRadius;
  if (footprint.is_disc() || tiny) {
    const Disc disc{{pose.x, pose.y}, radius};
    fill_disc(ctx, view, disc, faded(color, 0.3F), kLeastRadius);
    circle(ctx, view, disc, color, 2, kLeastRadius);
  } else {
    const std::vector<TPoint2D> corners = footprint.corners_at(pose);
    fill_polygon(ctx, view, corners, faded(color, 0.3F));
    polyline(ctx, view, corners, color, 2, true);
  }
  const double reach = 1.6 * std::max(radius, kLeastRadius / view.pixels_per_metre());
  polyline(ctx, view,
           {{pose.x, pose.y},
            {pose.x + reach * std::cos(pose.phi), pose.y + reach * std::sin(pose.phi)}},
           color, 2);
}

void goal(NVGcontext* ctx, const ViewTransform& view, const TPoint2D& at, double radius,
          const nanogui::Color& color) {
  circle(ctx, view, {at, radius}, color, 2, kLeastRadius);
  const double r = std::max(radius, kLeastRadius / view.pixels_per_metre());
  polyline(ctx, view, {{at.x - r, at.y}, {at.x + r, at.y}}, color, 2);
  polyline(ctx, view, {{at.x, at.y - r}, {at.x, at.y + r}}, color, 2);
}

nanogui::Color faded(const nanogui::Color& color, float opacity) {
  nanogui::Color result = color;
  result.w() = opacity;
  return result;
}

}  // namespace slalom::shapes
