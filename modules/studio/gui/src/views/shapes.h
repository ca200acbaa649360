// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "views/view_layout.h"

#include <slalom/robot/footprint.h>
#include <slalom/scenario/geometry.h>
#include <slalom/scenario/mover.h>
#include <slalom/scenario/person.h>
#include <slalom/studio/palette.h>

#include <nanogui/nanogui.h>
#include <optional>
#include <vector>

namespace slalom::shapes {

/// Strokes `points` (m), skipping those on the same pixel as the previous one.
void polyline(NVGcontext* ctx, const ViewTransform& view,
              const std::vector<mrpt::math::TPoint2D>& points, const Color& color, float width,
              bool closed = false);
void fill_polygon(NVGcontext* ctx, const ViewTransform& view,
                  const std::vector<mrpt::math::TPoint2D>& vertices, const Color& color);
/// Small squares of `side` pixels.
void dots(NVGcontext* ctx, const ViewTransform& view,
          const std::vector<mrpt::math::TPoint2D>& points, const Color& color, float side);
/// The radius is at least `min_radius` pixels, so that it is visible at any zoom.
void fill_disc(NVGcontext* ctx, const ViewTransform& view, const Disc& disc, const Color& color,
               double min_radius = 0);
void circle(NVGcontext* ctx, const ViewTransform& view, const Disc& disc, const Color& color,
            float width, double min_radius = 0);
/// The footprint at a pose with a line in the direction of its heading.
void robot(NVGcontext* ctx, const ViewTransform& view, const Footprint& footprint,
           const mrpt::math::TPose2D& pose, const Color& color);
/// The path of a mover with the times of its waypoints (s), where they are far enough apart to be
/// read, and, if it is present at `time` (s of a run), its disc there with its id.
void mover(NVGcontext* ctx, const ViewTransform& view, const Mover& mover, double time,
           const Color& color);
/// The way of a person, its route unless `record` has more than its start; and its disc with its id
/// if `record` has it at `time` (s of a run), or a circle at its start before that.
void person(NVGcontext* ctx, const ViewTransform& view, const Person& person, const Mover& record,
            double time);
/// A circle with a cross, of `radius` (m).
/// With a line in the direction of the heading, if there is one.
void goal(NVGcontext* ctx, const ViewTransform& view, const mrpt::math::TPoint2D& at,
          const std::optional<double>& heading, double radius, const Color& color);

}  // namespace slalom::shapes
