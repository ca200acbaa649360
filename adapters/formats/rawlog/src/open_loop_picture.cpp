// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/distance.h>
#include <slalom/core/math.h>
#include <slalom/core/text.h>
#include <slalom/io/svg_scene.h>
#include <slalom/rawlog/open_loop_picture.h>

#include <optional>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

/// The path of a command that is held for one second.
Path arc_of(TPose2D pose, const Command& command) {
  constexpr int kSteps = 20;
  Path path = {TPoint2D(pose)};
  for (int i = 0; i < kSteps; ++i) {
    const double time = 1.0 / kSteps, heading = pose.phi + 0.5 * command.w * time;
    pose.x += time * (command.v * math::cos(heading) - command.vy * math::sin(heading));
    pose.y += time * (command.v * math::sin(heading) + command.vy * math::cos(heading));
    pose.phi += command.w * time;
    path.push_back(TPoint2D(pose));
  }
  return path;
}

SceneTrajectory drawn(const TPose2D& pose, const OpenLoopAnswer& answer) {
  SceneTrajectory arc;
  const ContactPrediction& contact = answer.prediction;
  arc.label = "t " + format_fixed(answer.time, 2) + " s: v " + format_fixed(answer.command.v, 2) +
              " m/s, w " + format_fixed(answer.command.w, 2) + " rad/s";
  arc.path = arc_of(pose, answer.command);
  arc.color = contact.in_contact || contact.stopping ? "#b8231a"
              : contact.one_second                   ? "#c98a00"
                                                     : "#11703f";
  arc.outcome.reset();
  if (contact.in_contact || contact.stopping) arc.outcome = Outcome::Collision;
  return arc;
}

}  // namespace

std::string open_loop_picture(const LogMap& map, const std::vector<LoggedScan>& scans,
                              const std::vector<OpenLoopAnswer>& answers, double robot_radius) {
  constexpr double kSpacing = 0.25;  // m, between arcs without a contact
  SceneOptions options;
  options.max_pixels = 1200;
  options.robot_radius = robot_radius;
  SceneTrajectory driven;
  driven.label = "driven";
  driven.outcome.reset();
  driven.color = "#5b6472";
  std::vector<SceneTrajectory> arcs;
  std::optional<TPoint2D> last;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    if (!scans[i].odometry) continue;
    const TPose2D& pose = *scans[i].odometry;
    driven.path.push_back(TPoint2D(pose));
    if (!answers[i].problem.empty()) continue;
    SceneTrajectory arc = drawn(pose, answers[i]);
    const bool is_far = !last || distance_between(*last, TPoint2D(pose)) >= kSpacing;
    if (!is_far && arc.outcome != Outcome::Collision) continue;
    last = TPoint2D(pose);
    arcs.push_back(std::move(arc));
  }
  options.trajectories = std::move(arcs);
  options.trajectories.push_back(std::move(driven));  // above the arcs along it
  return render_svg(Scenario::grid("log", map.grid, map.start, map.goal), options);
}

}  // namespace slalom
