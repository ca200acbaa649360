// SPDX-License-Identifier: BSD-3-Clause
#include "svg_obstacles.h"

#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/temporary_file.h>
#include <slalom/io/png_scene.h>
#include <slalom/scenario/occupancy.h>

#include <mrpt/img/CImage.h>

#include <cmath>

namespace slalom {
namespace {

using mrpt::img::CImage;
using mrpt::img::TColor;
using mrpt::math::TPoint2D;

const TColor kObstacle(0x8a, 0x8f, 0x98), kStart(0x0b, 0x6e, 0x4f), kGoal(0xb0, 0x00, 0x20);

/// The color "#RRGGBB".
TColor color_of(const std::string& text) {
  const unsigned long value = std::strtoul(text.substr(1).c_str(), nullptr, 16);
  return {static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>(value >> 8),
          static_cast<std::uint8_t>(value)};
}

TColor color_of(const SceneTrajectory& trajectory, std::size_t index) {
  return color_of(trajectory.color.empty() ? method_color(index) : trajectory.color);
}

class Canvas {
 public:
  Canvas(const Scenario& scenario, int max_pixels)
      : frame_(scenario.bounds(), max_pixels),
        image_(static_cast<unsigned>(std::ceil(frame_.width())),
               static_cast<unsigned>(std::ceil(frame_.height())), mrpt::img::CH_RGB) {
    image_.filledRectangle(0, 0, static_cast<int>(image_.getWidth()) - 1,
                           static_cast<int>(image_.getHeight()) - 1, TColor::white());
  }

  double scale() const { return frame_.scale(); }

  /// Fills all pixels that overlap occupied cells.
  void obstacles(const Occupancy& cells) {
    for (int cy = 0; cy < cells.size_y(); ++cy)
      for (int cx = 0; cx < cells.size_x(); ++cx) {
        if (!cells.occupied(cx, cy)) continue;
        const TPoint2D low = frame_.to_pixels(cells.to_world(cx, cy + 1));
        const TPoint2D high = frame_.to_pixels(cells.to_world(cx + 1, cy));
        image_.filledRectangle(static_cast<int>(low.x), static_cast<int>(low.y),
                               static_cast<int>(std::ceil(high.x)) - 1,
                               static_cast<int>(std::ceil(high.y)) - 1, kObstacle);
      }
  }

  void path(const Path& path, const TColor& color, unsigned width) {
    for (std::size_t i = 1; i < path.size(); ++i) line(path[i - 1], path[i], color, width);
  }

  /// Dashes and gaps continue around corners, as in SVG.
  void path(const Path& path, const LineStyle& style) {
    const auto width = static_cast<unsigned>(style.width);  // ends of wider lines fill the gaps
    const double period = style.dash + style.gap;
    double before = 0;  // pixels along the path
    for (std::size_t i = 1; i < path.size(); ++i) {
      const TPoint2D from = frame_.to_pixels(path[i - 1]), to = frame_.to_pixels(path[i]);
      const double length = (to - from).norm();
      if (length == 0) continue;
      for (double dash = period * std::floor(before / period); dash < before + length;
           dash += period) {
        const double begin = std::max(dash, before) - before;
        const double end = std::min(dash + style.dash, before + length) - before;
        if (begin >= end) continue;
        const TPoint2D a = from + (to - from) * (begin / length);
        const TPoint2D b = from + (to - from) * (end / length);
        image_.line(round(a.x), round(a.y), round(b.x), round(b.y), color_of(style.color), width);
      }
      before += length;
    }
  }

  /// The end of a trajectory: a disc, or a cross for one that failed.
  void end(const SceneTrajectory& trajectory, const TColor& color) {
    if (trajectory.path.empty()) return;
    const TPoint2D& at = trajectory.path.back();
    const bool failed = trajectory.outcome && *trajectory.outcome != Outcome::Success;
    const double r = (failed ? 4.5 : 3.5) / frame_.scale();
    if (!failed) return disc(at, r, color);
    line({at.x - r, at.y - r}, {at.x + r, at.y + r}, color, 3);
    line({at.x - r, at.y + r}, {at.x + r, at.y - r}, color, 3);
  }

  void line(const TPoint2D& a, const TPoint2D& b, const TColor& color, unsigned width) {
    const TPoint2D from = frame_.to_pixels(a), to = frame_.to_pixels(b);
    image_.line(round(from.x), round(from.y), round(to.x), round(to.y), color, width);
  }

  void circle(const TPoint2D& center, double radius, const TColor& color, unsigned width) {
    const TPoint2D at = frame_.to_pixels(center);
    image_.drawCircle(round(at.x), round(at.y), round(radius * frame_.scale()), color, width);
  }

  void disc(const TPoint2D& center, double radius, const TColor& color) {
    const TPoint2D at = frame_.to_pixels(center);
    const int x = round(at.x), y = round(at.y), r = round(radius * frame_.scale());
    for (int dy = -r; dy <= r; ++dy) {
      const int half = static_cast<int>(std::sqrt(static_cast<double>(r) * r - dy * dy));
      image_.line(x - half, y + dy, x + half, y + dy, color);
    }
  }

  void save(const std::string& path) const { write_png(image_, path); }

 private:
  static int round(double x) { return static_cast<int>(std::lround(x)); }

  SvgFrame frame_;
  CImage image_;
};

void draw_mover(Canvas& canvas, const DrawnMover& drawn, const std::optional<double>& time) {
  const Mover& mover = drawn.mover;
  canvas.path(drawn.path, drawn.line());
  const double t = instant_shown(mover, time);
  if (!mover.present(t)) return;
  canvas.disc(mover.position(t), mover.radius, color_of(drawn.color()));
  canvas.circle(mover.position(t), mover.radius, color_of(drawn.edge_color()), 1);
}

}  // namespace

void write_png(const CImage& image, const std::string& path) {
  TemporaryFile temporary(path, ".png");
  if (!image.saveToFile(temporary.name()))
    throw job_error(path, "cannot be written", "a .png file in a writable folder");
  temporary.publish();
}

void render_png(const Scenario& scenario, const SceneOptions& options, const std::string& path) {
  Canvas canvas(scenario, options.max_pixels);
  canvas.obstacles(make_occupancy(scenario, 1 / canvas.scale()));
  for (const DrawnMover& drawn : drawn_movers(scenario, options))
    draw_mover(canvas, drawn, options.time);
  if (options.references != nullptr) {
    if (const auto& safest = options.references->safest)
      canvas.path(safest_line(safest->path), kSafestLine);
    if (const auto& shortest = options.references->shortest)
      canvas.path(shortest->path, kShortestLine);
  }
  for (std::size_t i = 0; i < options.trajectories.size(); ++i) {
    const TColor color = color_of(options.trajectories[i], i);
    canvas.path(options.trajectories[i].path, color, 2);
    canvas.end(options.trajectories[i], color);
  }
  const auto& start = scenario.start();
  const TPoint2D at(start.x, start.y);
  const double r = options.robot_radius;
  canvas.circle(at, r, kStart, 2);
  canvas.line(at, {at.x + r * math::cos(start.phi), at.y + r * math::sin(start.phi)}, kStart, 2);
  const TPoint2D goal = scenario.goal();
  canvas.circle(goal, r, kGoal, 2);
  canvas.line({goal.x - r, goal.y}, {goal.x + r, goal.y}, kGoal, 2);
  canvas.line({goal.x, goal.y - r}, {goal.x, goal.y + r}, kGoal, 2);
  if (const auto& heading = scenario.goal_heading()) {
    const double tip = 1.6 * r;
    canvas.line(goal, {goal.x + tip * math::cos(*heading), goal.y + tip * math::sin(*heading)},
                kGoal, 2);
  }
  canvas.save(path);
}

}  // namespace slalom
