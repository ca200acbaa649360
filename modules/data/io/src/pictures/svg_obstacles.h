// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/io/path_simplify.h>
#include <slalom/io/svg_scene.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Maps world coordinates (m) to pixels, y downwards.
class SvgFrame {
 public:
  SvgFrame(const Bounds& bounds, int max_pixels)
      : bounds_(bounds), scale_(max_pixels / std::max(bounds.width(), bounds.height())) {}

  double scale() const { return scale_; }  ///< pixels per meter
  double width() const { return bounds_.width() * scale_; }
  double height() const { return bounds_.height() * scale_; }
  mrpt::math::TPoint2D to_pixels(const mrpt::math::TPoint2D& p) const {
    return {(p.x - bounds_.x_min) * scale_, (bounds_.y_max - p.y) * scale_};
  }

 private:
  Bounds bounds_;
  double scale_;
};

/// The obstacles of a scenario: primitives as they are, cells merged into rectangles. Cells smaller
/// than a pixel are grouped into blocks, occupied if any of their cells is.
std::string obstacles_svg(const Scenario& scenario, const SvgFrame& frame);

/// How a line is drawn, in pixels; drawn in full without a gap.
struct LineStyle {
  const char* color;
  double width, dash = 1, gap = 0;
};
constexpr LineStyle kShortestLine = {"#111111", 1.2, 7, 3}, kSafestLine = {"#555555", 1.5, 2, 3};

/// The safest path follows cells: simplified to about one.
inline Path safest_line(const Path& path) {
  return simplify(path, 0.05);
}

/// A moving obstacle or a person in a picture.
struct DrawnMover {
  bool is_person = false;
  Mover mover;
  Path path;  ///< of the waypoints; of a person without a record its route

  std::string css_class() const { return is_person ? "person" : "mover"; }
  std::string name() const { return (is_person ? "person " : "moving obstacle ") + mover.id; }
  const char* color() const { return is_person ? "#a78bda" : "#e0a030"; }
  const char* edge_color() const { return is_person ? "#4b2e83" : "#8a5a00"; }
  LineStyle line() const { return {edge_color(), 1, 4, 2}; }  ///< of its path
};

/// A person without a record is at its start, or absent if the picture has a time.
std::vector<DrawnMover> drawn_movers(const Scenario& scenario, const SceneOptions& options);

/// The time (s) for which a picture shows the mover: that of the picture, or that at which it is
/// first present during the run.
inline double instant_shown(const Mover& mover, const std::optional<double>& time) {
  return time.value_or(std::max(0.0, mover.waypoints.front().t));
}

}  // namespace slalom
