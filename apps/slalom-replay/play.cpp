// SPDX-License-Identifier: BSD-3-Clause
#include "play_window.h"
#include "verbs.h"

#include <slalom/app/checks.h>
#include <slalom/app/output_folder.h>
#include <slalom/app/recorded_campaign.h>
#include <slalom/core/error.h>
#include <slalom/core/printable.h>
#include <slalom/io/png_scene.h>
#include <slalom/rawlog/run_scene.h>
#include <slalom/simulation/evaluate_trajectory.h>

#include <cstdio>
#include <iostream>

namespace slalom {
namespace {

struct PlayArguments {
  std::string log, folder, script;
  bool window = false;
  int every = 1, pixels = 640;
};

std::string frame_name(const std::string& folder, std::size_t number) {
  char name[32];
  std::snprintf(name, sizeof name, "/frame_%06zu.png", number);
  return folder + name;
}

void draw_images(const RecordedRun& run, const Scenario& scenario, const CampaignOptions& options,
                 const PlayArguments& arguments) {
  Movers movers = scenario.movers();
  if (!scenario.people().empty())
    movers = movers_along(World(scenario, options.simulation.resolution), options.robot,
                          options.simulation, run.trajectory, options.people);
  make_output_folder(arguments.folder);
  const std::size_t samples = run.trajectory.samples.size();
  std::size_t frames = 0;
  const auto every = static_cast<std::size_t>(arguments.every);
  for (std::size_t i = 0; i < samples; ++i)
    if (i % every == 0 || i + 1 == samples) {
      SceneOptions scene = scene_at(run, i, options.robot, arguments.pixels);
      scene.movers = &movers;
      render_png(scenario, scene, frame_name(arguments.folder, frames++));
    }
  std::cout << frames << " images in " << arguments.folder << ": " << run.manifest.method << " in "
            << printable_line(scenario.name()) << ", " << to_string(run.outcome) << " ("
            << run.detail << ")\n";
}

void play(const PlayArguments& arguments) {
  const RecordedRun run = read_run(arguments.log);
  if (arguments.folder.empty() && !arguments.window)
    throw usage_error("play", "no output selected", "--gui or --png DIR");
  const CampaignOptions options = read_campaign_options(campaign_of(run, arguments.log, "", {}));
  const Scenario scenario = scenario_of(run, arguments.log);
  if (run.trajectory.samples.empty())
    throw job_error(arguments.log, "contains no samples", "a run with at least one sample");
  if (!arguments.folder.empty()) draw_images(run, scenario, options, arguments);
  if (arguments.window) show_run(run, scenario, options, arguments.log, arguments.script);
}

}  // namespace

void define_play(CLI::App& app) {
  static PlayArguments arguments;
  CLI::App* verb = app.add_subcommand(
      "play", "Show a recorded run in a window or as images: scenario, robot, scan, path");
  verb->add_option("log", arguments.log, "The run (.rawlog)")->required();
  CLI::Option* window =
      verb->add_flag("--gui", arguments.window, "Replay it in a window with slider and plots");
  verb->add_option(
          "--script", arguments.script,
          "Execute the user actions of this file in the window, then exit (docs/guide/studio.md)")
      ->needs(window);
  verb->add_option("--png", arguments.folder, "Output folder for frame_000000.png, ...");
  verb->add_option("--every", arguments.every, "Control cycles per image")
      ->check(in_range(1, 1000000))
      ->capture_default_str();
  verb->add_option("--size", arguments.pixels, "Length of the longer side, pixels")
      ->check(in_range(16, 8192))
      ->capture_default_str();
  verb->callback([] { play(arguments); });
}

}  // namespace slalom
