#include <slalom/campaign/campaign.h>
#include <slalom/core/byte_stream.h>
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

Trial run_trial(const World& world, const TestBench& bench, Method& method) {
  const SimulationResult result =
      simulate(world, bench.setup, run_seed(bench.seed, world.scenario().hash(), bench.repetition),
               method, nullptr);
  Trial trial{result.outcome, result.detail, result.trajectory.hash(),
              waypoints_of(result.trajectory)};
  trial.clearance = bench.setup.sensor.max_range;
  for (const Sample& sample : result.trajectory.samples)
    trial.clearance =
        std::min(trial.clearance, world.distance_field().clearance({sample.pose.x, sample.pose.y}));
  trial.clearance -= bench.setup.robot.shape().enclosing_radius();
  return trial;
}

bool is_same_run(const Trial& a, const Trial& b) {
  return a.outcome == b.outcome && a.trajectory_hash == b.trajectory_hash;
}

std::string to_bytes(const Trial& trial) {
  ByteWriter writer;
  writer.u8(static_cast<std::uint8_t>(trial.outcome))
      .text(trial.detail)
      .text(trial.trajectory_hash);
  writer.f64(trial.clearance).u64(trial.waypoints.size());
  for (const mrpt::math::TPose2D& pose : trial.waypoints)
    writer.f64(pose.x).f64(pose.y).f64(pose.phi);
  return writer.take();
}

Trial trial_from_bytes(const std::string& bytes, const std::string& where) {
  ByteReader reader(bytes, where);
  Trial trial;
  const std::size_t outcome = reader.u8();
  if (outcome >= enum_values<Outcome>().size()) throw reader.broken("unknown outcome");
  trial.outcome = static_cast<Outcome>(outcome);
  trial.detail = reader.text();
  trial.trajectory_hash = reader.text();
  trial.clearance = reader.f64();
  trial.waypoints.resize(reader.count(3 * sizeof(double)));
  for (mrpt::math::TPose2D& pose : trial.waypoints) {
    pose.x = reader.f64();
    pose.y = reader.f64();
    pose.phi = reader.f64();
  }
  reader.expect_end();
  return trial;
}

}  // namespace slalom
