// SPDX-License-Identifier: BSD-3-Clause
#include "play_window.h"

#include <slalom/app/recorded_campaign.h>
#include <slalom/core/read_file.h>
#include <slalom/gui/panel_window.h>
#include <slalom/gui/replay_window.h>
#include <slalom/metrics/metric.h>
#include <slalom/rawlog/run_scene.h>

#include <algorithm>
#include <filesystem>

namespace slalom {
namespace {

/// The metrics that depend only on the trajectory; the others need reference paths.
std::map<std::string, VersionedValue> trajectory_metrics(const RecordedRun& run) {
  const bool success = run.outcome == Outcome::Success;
  const Value time = success ? Value::of(run.trajectory.duration())
                             : Value::na("outcome: " + to_string(run.outcome));
  return {
      {"path_length", {metric("path_length").info.version, Value::of(run.trajectory.traveled())}},
      {"time_to_goal", {metric("time_to_goal").info.version, time}}};
}

ReplayContent content_of(const RecordedRun& run, const CampaignOptions& options,
                         const std::string& log) {
  ReplayContent content;
  content.title = "slalom-replay: " + std::filesystem::path(log).filename().string();
  content.scene.robot = options.robot;
  content.scene.sensor = options.sensor;
  content.scene.resolution = options.simulation.resolution;
  content.scene.gap = options.reference_gap;
  content.source.path = log;
  content.source.campaign = options.name;
  content.source.methods = {run.manifest.method};
  content.source.robot = options.robot;
  content.source.simulation = options.simulation;
  content.source.people = options.people;
  OverlayRun shown;
  shown.record = record_of(run);
  shown.record.metrics = trajectory_metrics(run);
  shown.trajectory = std::make_shared<const Trajectory>(run.trajectory);
  const std::size_t scans = std::min(run.cycles.size(), run.trajectory.samples.size());
  for (std::size_t i = 0; i < scans; ++i)
    shown.scans.push_back(std::make_shared<const Path>(scan_ends(run, i)));
  content.runs.push_back(std::move(shown));
  return content;
}

}  // namespace

void show_run(const RecordedRun& run, const Scenario& scenario, const CampaignOptions& options,
              const std::string& log, const std::string& script) {
  std::vector<ScriptCommand> commands;
  if (!script.empty())
    commands = parse_studio_script(read_text(script, "a script", kMaxConfigSize), script);
  with_display("slalom-replay play --gui",
               "images by 'slalom-replay play " + log + " --png DIR', or xvfb-run -a", [&] {
                 ReplayWindow window(scenario, content_of(run, options, log), script.empty());
                 script.empty() ? window.run() : window.run(commands, script);
               });
}

}  // namespace slalom
