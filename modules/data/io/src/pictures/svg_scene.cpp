// SPDX-License-Identifier: BSD-3-Clause
#include "svg_obstacles.h"

#include <slalom/core/math.h>
#include <slalom/core/text.h>
#include <slalom/io/path_simplify.h>
#include <slalom/io/svg_scene.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

std::string dashes(const LineStyle& style) {
  return fmt::format("stroke-width=\"{}\" stroke-dasharray=\"{} {}\"", style.width, style.dash,
                     style.gap);
}

/// The mark of a failure about the current point, one per kind, the same as in the charts of a
/// report (marks.js).
const char* failure_mark(Outcome outcome) {
  switch (outcome) {
    case Outcome::Success:
      break;
    case Outcome::Collision:
      return "m-4.5 -4.5l9 9m0 -9l-9 9";  // cross
    case Outcome::LeftWorkspace:
      return "m-6 0h12m-4.5 -4.5l4.5 4.5l-4.5 4.5";  // arrow
    case Outcome::Timeout:
      return "m-4.5 -4.5h9l-9 9h9z";  // hourglass
    case Outcome::Stuck:
      return "m-3 -6v12m6 0v-12";  // two bars
    case Outcome::MethodCrash:
    case Outcome::MethodDeadline:
    case Outcome::MethodInvalidCommand:
    case Outcome::MethodError:
      return "m0 -6v12m-6 -6h12";  // plus
    case Outcome::UnsolvableScenario:
    case Outcome::InfrastructureError:
      return "m-4.5 -4.5h9v9h-9z";  // square
  }
  return "";
}

class Picture {
 public:
  Picture(const Scenario& scenario, const SceneOptions& options)
      : scenario_(scenario),
        options_(options),
        frame_(options.view.value_or(scenario.bounds()), options.max_pixels) {}

  std::string render() {
    const double width = frame_.width(), height = frame_.height();
    svg_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"scene\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
        "width=\"{0:.0f}\" height=\"{1:.0f}\" role=\"img\"><title>{2}</title>"
        "<rect class=\"workspace\" width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#ffffff\"/>",
        width, height, html_escape(scenario_.name()));
    svg_ += obstacles_svg(scenario_, frame_);
    for (const DrawnMover& drawn : drawn_movers(scenario_, options_)) draw(drawn);
    draw_references();
    for (std::size_t i = 0; i < options_.trajectories.size(); ++i)
      draw(options_.trajectories[i], i);
    draw_start();
    draw_goal();
    const Bounds& all = scenario_.bounds();
    const TPoint2D from = frame_.to_pixels({all.x_min, all.y_max});
    const TPoint2D to = frame_.to_pixels({all.x_max, all.y_min});
    svg_ += fmt::format(
        "<rect class=\"border\" x=\"{:.0f}\" y=\"{:.0f}\" width=\"{:.0f}\" height=\"{:.0f}\" "
        "fill=\"none\" stroke=\"#444\" stroke-width=\"1.5\"/></svg>",
        from.x, from.y, to.x - from.x, to.y - from.y);
    return svg_;
  }

 private:
  /// Its path, and its disc where it is at the time of the picture.
  void draw(const DrawnMover& drawn) {
    const Mover& mover = drawn.mover;
    const double t = instant_shown(mover, options_.time);
    svg_ += line(drawn.path, drawn.css_class(), drawn.line(), drawn.name());
    if (!mover.present(t)) return;
    const std::string title = drawn.name() + " at " + format_number(t) + " s";
    const TPoint2D center = frame_.to_pixels(mover.position(t));
    svg_ += fmt::format(
        "<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\" "
        "stroke=\"{}\"><title>{}</title></circle>",
        drawn.css_class(), center.x, center.y, mover.radius * frame_.scale(), drawn.color(),
        drawn.edge_color(), html_escape(title));
  }

  void draw_references() {
    if (options_.references == nullptr) return;
    if (options_.references->safest)
      svg_ += line(safest_line(options_.references->safest->path), "reference safest", kSafestLine,
                   "safest path");
    if (options_.references->shortest)
      svg_ += line(options_.references->shortest->path, "reference shortest", kShortestLine,
                   "shortest path");
  }

  void draw(const SceneTrajectory& trajectory, std::size_t index) {
    const std::string color = trajectory.color.empty() ? method_color(index) : trajectory.color;
    const auto& outcome = trajectory.outcome;
    const std::string title = trajectory.label + (outcome ? ": " + to_string(*outcome) : "");
    svg_ += line(trajectory.path, "trajectory", color, "stroke-width=\"2\"", title);
    if (trajectory.path.empty()) return;
    const TPoint2D end = frame_.to_pixels(trajectory.path.back());
    if (!outcome || *outcome == Outcome::Success) {
      svg_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"{}\"/>", end.x,
                          end.y, html_escape(color));
    } else {
      svg_ += fmt::format(
          "<path d=\"M{:.1f} {:.1f}{}\" stroke=\"{}\" stroke-width=\"2.5\" "
          "fill=\"none\"><title>{}</title></path>",
          end.x, end.y, failure_mark(*outcome), html_escape(color), html_escape(title));
    }
  }

  std::string line(const Path& path, const std::string& css_class, const LineStyle& style,
                   const std::string& title) const {
    return line(path, css_class, style.color, dashes(style), title);
  }

  std::string line(const Path& path, const std::string& css_class, const std::string& color,
                   const std::string& style, const std::string& title) const {
    if (path.size() < 2) return "";
    const Path drawn = simplify(path, 0.3 / frame_.scale());
    std::string points;
    for (const TPoint2D& p : drawn) {
      const TPoint2D pixel = frame_.to_pixels(p);
      points += fmt::format("{}{:.1f},{:.1f}", points.empty() ? "" : " ", pixel.x, pixel.y);
    }
    return fmt::format(
        "<polyline class=\"{}\" points=\"{}\" fill=\"none\" stroke=\"{}\" {} "
        "stroke-linejoin=\"round\"><title>{}</title></polyline>",
        css_class, points, html_escape(color), style, html_escape(title));
  }

  void draw_start() {
    const auto& start = scenario_.start();
    const TPoint2D center = frame_.to_pixels({start.x, start.y});
    const double radius = std::max(3.0, options_.robot_radius * frame_.scale());
    // The y axis of pixels points down.
    const double tip_x = center.x + radius * math::cos(start.phi);
    const double tip_y = center.y - radius * math::sin(start.phi);
    svg_ += fmt::format(
        "<g class=\"start\" stroke=\"#0b6e4f\" stroke-width=\"1.8\"><title>start</title>"
        "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"{2:.1f}\" fill=\"#0b6e4f\" "
        "fill-opacity=\"0.2\"/>"
        "<path d=\"M{0:.1f} {1:.1f}L{3:.1f} {4:.1f}\"/></g>",
        center.x, center.y, radius, tip_x, tip_y);
  }

  void draw_goal() {
    const TPoint2D center = frame_.to_pixels(scenario_.goal());
    const double radius = std::max(4.0, options_.robot_radius * frame_.scale());
    svg_ += fmt::format(
        "<g class=\"goal\" stroke=\"#b00020\" stroke-width=\"1.8\" "
        "fill=\"none\"><title>goal</title>"
        "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"{2:.1f}\"/>"
        "<path d=\"M{3:.1f} {1:.1f}h{4:.1f}M{0:.1f} {5:.1f}v{4:.1f}\"/></g>",
        center.x, center.y, radius, center.x - radius, 2 * radius, center.y - radius);
    if (const auto& heading = scenario_.goal_heading()) {
      const double tip = 1.6 * radius;
      // The y axis of pixels points down.
      svg_ += fmt::format(
          "<path class=\"goal_heading\" stroke=\"#b00020\" stroke-width=\"1.8\" "
          "d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>",
          center.x, center.y, center.x + tip * math::cos(*heading),
          center.y - tip * math::sin(*heading));
    }
  }

  const Scenario& scenario_;
  const SceneOptions& options_;
  SvgFrame frame_;
  std::string svg_;
};

}  // namespace

Bounds view_around(const Scenario& scenario, const std::vector<SceneTrajectory>& trajectories,
                   double margin) {
  const TPoint2D start(scenario.start()), goal = scenario.goal();
  Bounds view = {std::min(start.x, goal.x), std::min(start.y, goal.y), std::max(start.x, goal.x),
                 std::max(start.y, goal.y)};
  for (const SceneTrajectory& trajectory : trajectories)
    for (const TPoint2D& p : trajectory.path)
      view = {std::min(view.x_min, p.x), std::min(view.y_min, p.y), std::max(view.x_max, p.x),
              std::max(view.y_max, p.y)};
  const Bounds& all = scenario.bounds();
  return {std::max(all.x_min, view.x_min - margin), std::max(all.y_min, view.y_min - margin),
          std::min(all.x_max, view.x_max + margin), std::min(all.y_max, view.y_max + margin)};
}

std::string reference_line(bool shortest) {
  const LineStyle& style = shortest ? kShortestLine : kSafestLine;
  return fmt::format("stroke=\"{}\" {}", style.color, dashes(style));
}

std::string method_color(std::size_t index) {
  static const std::array<const char*, 10> kColors = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                      "#56b4e9", "#e69f00", "#6a51a3", "#8c564b",
                                                      "#9ab01c", "#e31a5c"};
  return kColors[index % kColors.size()];
}

std::string html_escape(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += (byte < 0x20 && c != '\n' && c != '\t') || byte == 0x7F ? '?' : c;
    }
  }
  return escaped;
}

std::string render_svg(const Scenario& scenario, const SceneOptions& options) {
  return Picture(scenario, options).render();
}

}  // namespace slalom
