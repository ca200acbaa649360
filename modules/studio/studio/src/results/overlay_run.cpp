// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/io/result_file.h>
#include <slalom/metrics/metric.h>
#include <slalom/simulation/evaluate_trajectory.h>
#include <slalom/studio/results_overlay.h>

#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

/// Reads robot, simulation and people of the campaign. A file of another program may contain no
/// .ini, or one that this version cannot read: then its runs are drawn without a robot.
void read_setup(const Manifest& manifest, OverlaySource& source) {
  const auto text = manifest.find("campaign.ini");
  if (text == manifest.end()) return;
  try {
    const IniFile ini = IniFile::from_text(text->second, source.path + ": campaign.ini");
    source.simulation = read_options<SimulationOptions>(ini, "simulation");
    source.people = read_options<PeopleSettings>(ini, "people");
    source.robot = read_robot_model(ini);
  } catch (const Error&) {
    source.robot.reset();
  }
}

double clearance_at(const World& world, const std::optional<Footprint>& footprint,
                    const mrpt::math::TPose2D& pose) {
  return footprint ? footprint_clearance(world, *footprint, pose)
                   : world.distance_field().clearance({pose.x, pose.y});
}

OverlayRun read_run(const ResultFile& file, const RunRecord& record) {
  OverlayRun run;
  run.record = record;
  try {
    auto trajectory = std::make_shared<Trajectory>(file.read_trajectory(record));
    if (trajectory->samples.empty())
      run.problem = "no trajectory recorded";
    else
      run.trajectory = std::move(trajectory);
  } catch (const Error& error) {
    run.problem = error.what();
  }
  return run;
}

}  // namespace

OverlaySource open_overlay_source(const std::string& path) {
  const ResultFile file = ResultFile::open(path);
  const Manifest manifest = file.read_manifest();
  OverlaySource source;
  source.path = path;
  source.methods = file.read_methods();
  const auto name = manifest.find("campaign");
  if (name != manifest.end()) source.campaign = name->second;
  read_setup(manifest, source);
  return source;
}

void fill_series(OverlayRun& run, const World& world, const std::optional<RobotModel>& robot) {
  run.times.clear();
  run.clearances.clear();
  run.speeds.clear();
  if (!run.trajectory) return;
  std::optional<Footprint> footprint;
  if (robot) footprint = robot->shape();
  for (const Sample& sample : run.trajectory->samples) {
    run.times.push_back(sample.t - run.trajectory->samples.front().t);
    run.clearances.push_back(clearance_at(world, footprint, sample.pose));
    run.speeds.push_back(sample.vy == 0 ? sample.v : math::hypot(sample.v, sample.vy));
  }
}

void fill_people(OverlayRun& run, const World& world, const OverlaySource& source) {
  const Scenario& scenario = world.scenario();
  run.people.clear();
  if (scenario.people().empty() || !source.robot || !run.trajectory) return;
  const Movers movers =
      movers_along(world, *source.robot, source.simulation, *run.trajectory, source.people);
  run.people.assign(movers.end() - static_cast<std::ptrdiff_t>(scenario.people().size()),
                    movers.end());
  for (Mover& person : run.people)
    for (Waypoint& waypoint : person.waypoints) waypoint.t += run.trajectory->samples.front().t;
}

std::vector<OverlayRun> read_overlay_runs(const OverlaySource& source,
                                          const std::string& scenario_hash) {
  const ResultFile file = ResultFile::open(source.path);
  std::vector<OverlayRun> runs;
  for (const RunRecord& record : file.read_runs(scenario_hash))
    runs.push_back(read_run(file, record));
  if (runs.empty()) return runs;
  const World world(file.read_scenario(scenario_hash), source.simulation.resolution);
  for (OverlayRun& run : runs) {
    fill_series(run, world, source.robot);
    fill_people(run, world, source);
  }
  return runs;
}

std::string overlay_label(const RunRecord& run) {
  return run.method + " " + std::to_string(run.repetition);
}

std::size_t sample_at(const Trajectory& trajectory, double time) {
  const auto& samples = trajectory.samples;
  const double t = samples.front().t + time;
  const auto next = std::upper_bound(samples.begin(), samples.end(), t,
                                     [](double at, const Sample& sample) { return at < sample.t; });
  return next == samples.begin() ? 0 : static_cast<std::size_t>(next - samples.begin()) - 1;
}

mrpt::math::TPose2D pose_at(const Trajectory& trajectory, double time) {
  const auto& samples = trajectory.samples;
  const std::size_t index = sample_at(trajectory, time);
  const Sample& a = samples[index];
  const double elapsed = samples.front().t + time - a.t;
  if (index + 1 == samples.size() || elapsed <= 0) return a.pose;
  const Sample& b = samples[index + 1];
  const double fraction = std::min(elapsed / (b.t - a.t), 1.0);
  const double turn = mrpt::math::wrapToPi(b.pose.phi - a.pose.phi);
  return {a.pose.x + fraction * (b.pose.x - a.pose.x), a.pose.y + fraction * (b.pose.y - a.pose.y),
          mrpt::math::wrapToPi(a.pose.phi + fraction * turn)};
}

}  // namespace slalom
