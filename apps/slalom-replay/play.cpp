#include "play_window.h"
#include "recorded_campaign.h"
#include "verbs.h"

#include <slalom/app/output_folder.h>
#include <slalom/core/error.h>
#include <slalom/io/png_scene.h>

#include <cmath>
#include <cstdio>
#include <iostream>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

struct PlayArguments {
  std::string log, folder, script;
  bool window = false;
  int every = 1, pixels = 640;
};

constexpr const char* kRayColor = "#f3d9a4";
constexpr const char* kTrailColor = "#1f5fa8";
constexpr const char* kRobotColor = "#0b2e59";

TPoint2D from(const TPose2D& pose, double angle, double distance) {
  return {pose.x + distance * std::cos(pose.phi + angle),
          pose.y + distance * std::sin(pose.phi + angle)};
}

SceneTrajectory line(Path path, const char* color) {
  SceneTrajectory drawn;
  drawn.path = std::move(path);
  drawn.color = color;
  return drawn;
}

/// Closed; of a disc enough corners to look round.
Path outline(const Footprint& shape, const TPose2D& pose) {
  Path corners = shape.corners_at(pose);
  constexpr int kCorners = 32;
  for (int i = 0; shape.is_disc() && i < kCorners; ++i)
    corners.push_back(from(pose, 2 * M_PI * i / kCorners, shape.enclosing_radius()));
  corners.push_back(corners.front());
  return corners;
}

void add_rays(SceneOptions& scene, const mrpt::obs::CObservation2DRangeScan& scan,
              const TPose2D& pose) {
  for (std::size_t i = 0; i < scan.getScanSize(); ++i)
    scene.trajectories.push_back(line(
        {{pose.x, pose.y}, from(pose, scan.getScanAngle(i), scan.getScanRange(i))}, kRayColor));
}

/// What it looked like at one sample of the trajectory; behind the last cycle there is no scan.
SceneOptions scene_at(const RecordedRun& run, std::size_t index, const RobotModel& robot,
                      int pixels) {
  const auto& samples = run.trajectory.samples;
  const TPose2D& pose = samples[index].pose;
  SceneOptions scene;
  scene.max_pixels = pixels;
  scene.robot_radius = robot.radius;
  if (index < run.cycles.size()) add_rays(scene, *run.cycles[index].scan, pose);
  Path trail = run.trajectory.path();
  trail.resize(index + 1);
  scene.trajectories.push_back(line(std::move(trail), kTrailColor));
  const Footprint shape = robot.shape();
  scene.trajectories.push_back(line(outline(shape, pose), kRobotColor));
  scene.trajectories.push_back(
      line({{pose.x, pose.y}, from(pose, 0, shape.inscribed_radius())}, kRobotColor));
  return scene;
}

std::string frame_name(const std::string& folder, std::size_t number) {
  char name[32];
  std::snprintf(name, sizeof name, "/frame_%06zu.png", number);
  return folder + name;
}

void draw_pictures(const RecordedRun& run, const Scenario& scenario, const RobotModel& robot,
                   const PlayArguments& arguments) {
  make_output_folder(arguments.folder);
  const std::size_t samples = run.trajectory.samples.size();
  std::size_t frames = 0;
  const auto every = static_cast<std::size_t>(arguments.every);
  for (std::size_t i = 0; i < samples; ++i)
    if (i % every == 0 || i + 1 == samples)
      render_png(scenario, scene_at(run, i, robot, arguments.pixels),
                 frame_name(arguments.folder, frames++));
  std::cout << frames << " pictures in " << arguments.folder << ": " << run.manifest.method
            << " in " << scenario.name() << ", " << to_string(run.outcome) << " (" << run.detail
            << ")\n";
}

void play(const PlayArguments& arguments) {
  if (arguments.folder.empty() && !arguments.window)
    throw usage_error("slalom-replay play", "does not say where to show the run",
                      "--gui or --png DIR");
  const RecordedRun run = read_run(arguments.log);
  const CampaignOptions options = read_campaign_options(campaign_of(run, arguments.log, "", {}));
  const Scenario scenario = scenario_of(run, arguments.log);
  if (run.trajectory.samples.empty())
    throw job_error(arguments.log, "has no instant to show", "a run that began");
  if (!arguments.folder.empty()) draw_pictures(run, scenario, options.setup.robot, arguments);
  if (arguments.window) show_run(run, scenario, options, arguments.log, arguments.script);
}

}  // namespace

void define_play(CLI::App& app) {
  static PlayArguments arguments;
  CLI::App* verb = app.add_subcommand(
      "play", "Show a recorded run, in a window or as pictures: place, robot, scan, trail");
  verb->add_option("log", arguments.log, "The run (.rawlog)")->required();
  CLI::Option* window =
      verb->add_flag("--gui", arguments.window, "Replay it in a window, with slider and plots");
  verb->add_option(
          "--script", arguments.script,
          "Plays what a user does in the window from this file, then ends (docs/studio.md)")
      ->needs(window);
  verb->add_option("--png", arguments.folder, "Folder for frame_000000.png, ...");
  verb->add_option("--every", arguments.every, "A picture each so many control cycles")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  verb->add_option("--size", arguments.pixels, "Pixels of the longer side")
      ->check(CLI::Range(16, 8192))
      ->capture_default_str();
  verb->callback([] { play(arguments); });
}

}  // namespace slalom
