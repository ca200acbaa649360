#pragma once

#include <slalom/gui/view_transform.h>
#include <slalom/robot/footprint.h>
#include <slalom/scenario/geometry.h>

#include <nanogui/nanogui.h>
#include <vector>

namespace slalom::shapes {

/// Strokes `points` (m); those that fall on the pixel of the one before are left out.
void polyline(NVGcontext* ctx, const ViewTransform& view,
              const std::vector<mrpt::math::TPoint2D>& points, const nanogui::Color& color,
              float width, bool closed = false);
void fill_polygon(NVGcontext* ctx, const ViewTransform& view,
                  const std::vector<mrpt::math::TPoint2D>& vertices, const nanogui::Color& color);
/// Small squares of so many pixels.
void dots(NVGcontext* ctx, const ViewTransform& view,
          const std::vector<mrpt::math::TPoint2D>& points, const nanogui::Color& color, float side);
/// At least `least` pixels in radius, so that it is found from afar.
void fill_disc(NVGcontext* ctx, const ViewTransform& view, const Disc& disc,
               const nanogui::Color& color, double least = 0);
void circle(NVGcontext* ctx, const ViewTransform& view, const Disc& disc,
            const nanogui::Color& color, float width, double least = 0);
/// The outline at a pose with a line to where it looks.
void robot(NVGcontext* ctx, const ViewTransform& view, const Footprint& footprint,
           const mrpt::math::TPose2D& pose, const nanogui::Color& color);
/// A ring with a cross of a robot's size.
void goal(NVGcontext* ctx, const ViewTransform& view, const mrpt::math::TPoint2D& at, double radius,
          const nanogui::Color& color);
nanogui::Color faded(const nanogui::Color& color, float opacity);

}  // namespace slalom::shapes
