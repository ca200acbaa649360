// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/campaign/campaign.h>
#include <slalom/campaign/measure.h>
#include <slalom/core/distance.h>
#include <slalom/falsification/trial.h>

#include <algorithm>

namespace slalom {
namespace {

std::vector<mrpt::math::TPose2D> waypoints_of(const Trajectory& trajectory) {
  std::vector<mrpt::math::TPose2D> poses;
  const std::vector<Sample>& samples = trajectory.samples;
  const std::size_t count = std::min(kWaypoints, samples.size());
  for (std::size_t i = 0; i < count; ++i)
    poses.push_back(samples[count < 2 ? 0 : i * (samples.size() - 1) / (count - 1)].pose);
  return poses;
}

}  // namespace

std::vector<std::size_t> FalsificationSetup::witnesses_in(const Scenario& scenario) const {
  std::vector<std::size_t> indexes;
  for (std::size_t i = 1; i <= witnesses.size(); ++i) indexes.push_back(i);
  if (unnoticed_witness && run.people.notices > 0 && !scenario.people().empty())
    indexes.push_back(unnoticed_index());
  return indexes;
}

bool FalsificationSetup::has_witness() const {
  return !witnesses.empty() || (unnoticed_witness && run.people.notices > 0 && people.count > 0);
}

std::string FalsificationSetup::witness_name(std::size_t index) const {
  const bool is_unnoticed = index == unnoticed_index();
  return method_at(index).name + (is_unnoticed ? " among people who do not notice it" : "");
}

Trial run_trial(const World& world, const FalsificationSetup& setup, Method& method) {
  RunSetup run = setup.run;
  if (!run.simulation.max_time)
    run.simulation.max_time = time_limit(run, find_earliest(run, world));
  const SimulationResult result = simulate(
      world, run, run_seed(setup.seed, world.scenario().hash(), setup.repetition), method, nullptr);
  Trial trial{result.outcome, result.detail, result.trajectory.hash(),
              waypoints_of(result.trajectory)};
  trial.clearance = setup.run.sensor.max_range;
  for (const Sample& sample : result.trajectory.samples) {
    const mrpt::math::TPoint2D position(sample.pose);
    trial.clearance = std::min(trial.clearance, world.distance_field().clearance(position));
    for (const Mover& mover : result.movers)
      if (mover.present(sample.t))
        trial.clearance = std::min(
            trial.clearance, distance_between(mover.position(sample.t), position) - mover.radius);
  }
  trial.clearance -= setup.run.robot.shape().enclosing_radius();
  return trial;
}

bool is_same_run(const Trial& a, const Trial& b) {
  return a.outcome == b.outcome && a.trajectory_hash == b.trajectory_hash;
}

}  // namespace slalom
