// SPDX-License-Identifier: BSD-3-Clause
#include "svg_obstacles.h"

#include <slalom/io/svg_animation.h>

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace slalom {
namespace {

constexpr double kPause = 1;  // s, at the end of each repetition

/// The values of an animated attribute over time, as SMIL expects them.
struct Keys {
  std::string times, positions, headings;
};

void append(std::string& list, const std::string& value) {
  list += (list.empty() ? "" : ";") + value;
}

Keys keys_of(const Trajectory& trajectory, const SvgFrame& frame, double duration) {
  Keys keys;
  const double start = trajectory.samples.front().t;
  double heading = trajectory.samples.front().pose.phi;
  for (const Sample& sample : trajectory.samples) {
    heading += std::remainder(sample.pose.phi - heading, 2 * M_PI);  // without jumps by a turn
    const auto pixel = frame.to_pixels({sample.pose.x, sample.pose.y});
    append(keys.times, fmt::format("{:.6f}", (sample.t - start) / duration));
    append(keys.positions, fmt::format("{:.1f} {:.1f}", pixel.x, pixel.y));
    append(keys.headings, fmt::format("{:.1f}", -heading * 180 / M_PI));  // y points down
  }
  append(keys.times, "1");
  const auto repeat_last = [](std::string& list) {
    append(list, list.substr(list.rfind(';') + 1));
  };
  repeat_last(keys.positions);
  repeat_last(keys.headings);
  return keys;
}

std::string animation(const char* type, const std::string& values, const std::string& times,
                      double duration) {
  return fmt::format(
      "<animateTransform attributeName=\"transform\" type=\"{}\" values=\"{}\" keyTimes=\"{}\" "
      "dur=\"{:.3f}s\" repeatCount=\"indefinite\"/>",
      type, values, times, duration);
}

/// The disc of a mover, which moves straight between the samples of the robot, while it is present.
std::string moving_disc(const DrawnMover& drawn, const Trajectory& trajectory,
                        const SvgFrame& frame, const std::string& times, double duration) {
  const Mover& mover = drawn.mover;
  std::string positions, visibility;
  const auto add = [&](double t) {
    const auto pixel = frame.to_pixels(mover.position(t));
    append(positions, fmt::format("{:.1f} {:.1f}", pixel.x, pixel.y));
    append(visibility, mover.present(t) ? "visible" : "hidden");
  };
  const double start = trajectory.samples.front().t;
  for (const Sample& sample : trajectory.samples) add(sample.t - start);
  add(trajectory.duration());  // at rest in the pause, like the robot
  return fmt::format(
      "<circle class=\"moving\" r=\"{:.1f}\" fill=\"{}\" stroke=\"{}\"><title>{}</title>{}"
      "<animate attributeName=\"visibility\" calcMode=\"discrete\" values=\"{}\" keyTimes=\"{}\" "
      "dur=\"{:.3f}s\" repeatCount=\"indefinite\"/></circle>",
      mover.radius * frame.scale(), drawn.color(), drawn.edge_color(), html_escape(drawn.name()),
      animation("translate", positions, times, duration), visibility, times, duration);
}

}  // namespace

std::string render_animated_svg(const Scenario& scenario, const SceneOptions& options,
                                const Trajectory& trajectory) {
  if (trajectory.samples.size() < 2) return render_svg(scenario, options);
  SceneOptions still = options;
  still.time = -std::numeric_limits<double>::infinity();  // the discs of movers are animated
  std::string svg = render_svg(scenario, still);
  const SvgFrame frame(scenario.bounds(), options.max_pixels);
  const double duration = trajectory.duration() + kPause;
  const Keys keys = keys_of(trajectory, frame, duration);
  std::string moving;
  for (const DrawnMover& drawn : drawn_movers(scenario, options))
    moving += moving_disc(drawn, trajectory, frame, keys.times, duration);
  const double radius = std::max(3.0, options.robot_radius * frame.scale());
  const std::string robot = fmt::format(
      "<g class=\"robot\">{}<g>{}<circle r=\"{:.1f}\" fill=\"#e69f00\" fill-opacity=\"0.8\" "
      "stroke=\"#111\"/><path d=\"M0 0h{:.1f}\" stroke=\"#111\" stroke-width=\"1.8\"/></g></g>",
      animation("translate", keys.positions, keys.times, duration),
      animation("rotate", keys.headings, keys.times, duration), radius, radius);
  return svg.insert(svg.rfind("</svg>"), moving + robot);
}

}  // namespace slalom
