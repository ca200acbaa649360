// SPDX-License-Identifier: BSD-3-Clause
// Closed-loop control steps per second on one core, in a grid of 400 x 400 cells of 0.05 m with
// random discs: 181 rays over 180 degrees up to 8 m, ten motion steps of 0.01 s per control step.
// `slalom` is simulate() with all features: sensing, a cheap method, motion, collision checking,
// recording. `mrpt` is its peer, laserScanSimulator with a CVehicleSimul_DiffDriven and the same
// method: sensing and motion only. `without_scan` is simulate() with two rays, the cost apart from
// the scan; nearly blind, it soon collides, so the cost of starting a run weighs more.
// `with_20_movers` is `slalom` among 20 moving discs, with which it collides; `with_20_people`
// among 20 people who notice the robot. Counter `steps` is control steps per second.
#include <slalom/core/random.h>
#include <slalom/generation/sample_people.h>
#include <slalom/people/run_alone.h>
#include <slalom/simulation/simulate.h>

#include <benchmark/benchmark.h>
#include <mrpt/kinematics/CVehicleSimul_DiffDriven.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <cmath>
#include <deque>

namespace slalom {
namespace {

using mrpt::maps::COccupancyGridMap2D;
using mrpt::math::TPose2D;
using mrpt::obs::CObservation2DRangeScan;

constexpr double kSize = 20, kResolution = 0.05;  // m
constexpr int kStarts = 16;

Scenario random_discs() {
  RandomEngine random(7);
  Primitives obstacles;
  for (int i = 0; i < 40; ++i)
    obstacles.discs.push_back({{uniform_real(random, 0, kSize), uniform_real(random, 0, kSize)},
                               uniform_real(random, 0.2, 0.8)});
  const Scenario discs =
      Scenario::continuous("discs", {0, 0, kSize, kSize}, obstacles, {1, 1, 0}, {0.01, 0.01});
  return convert(discs, Representation::Grid, kResolution);
}

/// Discs that walk back and forth at 0.4 to 1.2 m/s.
Movers random_movers(int count) {
  RandomEngine random(13);
  Movers movers;
  for (int i = 0; i < count; ++i) {
    const mrpt::math::TPoint2D a(uniform_real(random, 0, kSize), uniform_real(random, 0, kSize));
    const double direction = uniform_real(random, -M_PI, M_PI),
                 speed = uniform_real(random, 0.4, 1.2);
    const mrpt::math::TPoint2D b(a.x + 4 * std::cos(direction), a.y + 4 * std::sin(direction));
    movers.push_back(
        {std::to_string(i), 0.3, {{0, a}, {4 / speed, b}, {8 / speed, a}}, MoverEnd::Loop});
  }
  return movers;
}

/// The scenario with different starts, with precomputed tables.
std::deque<World> make_worlds(const Scenario& scenario) {
  std::deque<World> made;
  const World world(scenario, kResolution);
  RandomEngine random(11);
  while (made.size() < kStarts) {
    const TPose2D start(uniform_real(random, 0, kSize), uniform_real(random, 0, kSize),
                        uniform_real(random, -M_PI, M_PI));
    if (world.distance_field().clearance({start.x, start.y}) < 0.6) continue;
    made.emplace_back(scenario.with_start_goal(start, scenario.goal()), kResolution);
    made.back().distance_field();
    made.back().ray_caster();
  }
  return made;
}

const std::deque<World>& worlds_by_start() {
  static const std::deque<World> worlds = make_worlds(random_discs());
  return worlds;
}

/// Moves forward until an obstacle is near, then rotates in place; evaluates every tenth ray.
Command wander(const CObservation2DRangeScan& scan) {
  const std::size_t count = scan.getScanSize();
  float nearest = scan.maxRange;
  for (std::size_t i = count / 6; i < count - count / 6; i += 10)
    nearest = std::min(nearest, scan.getScanRange(i));
  return nearest < 0.9F ? Command{0, 1} : Command{0.8, 0.05};
}

class Wanderer : public Method {
 public:
  void reset(const NavigationTask&) override {}
  Command step(const Observation& observation) override { return wander(*observation.scan); }
};

SimulationOptions wandering_options() {
  SimulationOptions options;
  options.goal_tolerance = 1e-6;  // the goal is in a wall: runs end by timeout
  options.stuck_time = 1e6;
  return options;
}

void count_steps(benchmark::State& state, std::size_t steps) {
  state.counters["steps"] =
      benchmark::Counter(static_cast<double>(steps), benchmark::Counter::kIsRate);
}

void simulate_rays(benchmark::State& state, int rays, const std::deque<World>& worlds) {
  RunSetup setup;
  setup.simulation = wandering_options();
  setup.sensor.rays = rays;
  Wanderer wanderer;
  std::size_t steps = 0, i = 0;
  for (auto _ : state) {
    const SimulationResult result = simulate(worlds[i++ % worlds.size()], setup, 0, wanderer);
    steps += result.cycle_seconds.size();
    benchmark::DoNotOptimize(result);
  }
  count_steps(state, steps);
}

void slalom(benchmark::State& state) {
  simulate_rays(state, 181, worlds_by_start());
}

void without_scan(benchmark::State& state) {
  simulate_rays(state, 2, worlds_by_start());
}

void with_20_movers(benchmark::State& state) {
  static const std::deque<World> worlds =
      make_worlds(random_discs().with_movers(random_movers(20)));
  simulate_rays(state, 181, worlds);
}

/// Their ways, and their motion without the robot, are computed before.
void with_20_people(benchmark::State& state) {
  RunSetup setup;
  setup.simulation = wandering_options();
  RandomEngine random(17);
  PeopleOptions people;
  people.count = 20;
  const Scenario discs = random_discs();
  const std::deque<World> worlds = make_worlds(discs.with_people(
      sample_people(World(discs, kResolution), setup.robot.radius, people, random)));
  const World& world = worlds[0];
  PeopleAlone alone(world, setup.people);
  Wanderer wanderer;
  std::size_t steps = 0;
  for (auto _ : state) {
    const SimulationResult result = simulate(world, setup, 0, wanderer, nullptr, &alone);
    steps += result.cycle_seconds.size();
    benchmark::DoNotOptimize(result);
  }
  count_steps(state, steps);
}

/// MRPT's vehicle, integrated with Slalom's step instead of 0.5 ms.
class MrptVehicle : public mrpt::kinematics::CVehicleSimul_DiffDriven {
 public:
  explicit MrptVehicle(const TPose2D& start) {
    m_firmware_control_period = SimulationOptions().step;
    resetTime();
    resetStatus();
    setCurrentGTPose(start);
    setCurrentOdometricPose(start);
  }
};

/// maxRange bounds the number of MRPT's steps, not the distance: divided by the step it covers 8 m.
CObservation2DRangeScan mrpt_scan() {
  CObservation2DRangeScan scan;
  const SensorModel sensor;
  scan.aperture = static_cast<float>(sensor.aperture());
  scan.maxRange =
      static_cast<float>(sensor.max_range / COccupancyGridMap2D::RAYTRACE_STEP_SIZE_IN_CELL_UNITS);
  return scan;
}

void mrpt(benchmark::State& state) {
  const std::deque<World>& worlds = worlds_by_start();
  const SimulationOptions options = wandering_options();
  const int cycles = static_cast<int>(options.time_limit() / options.control_period);
  CObservation2DRangeScan scan = mrpt_scan();
  std::size_t steps = 0, i = 0;
  for (auto _ : state) {
    const Scenario& scenario = worlds[i++ % worlds.size()].scenario();
    MrptVehicle vehicle(scenario.start());
    for (int cycle = 0; cycle < cycles; ++cycle) {
      const mrpt::poses::CPose2D pose(vehicle.getCurrentGTPose());
      scenario.grid_map()->laserScanSimulator(scan, pose, 0.5F, 181);
      const Command command = wander(scan);
      vehicle.movementCommand(command.v, command.w);
      vehicle.simulateOneTimeStep(options.control_period);
    }
    steps += static_cast<std::size_t>(cycles);
    benchmark::DoNotOptimize(vehicle.getCurrentGTPose());
  }
  count_steps(state, steps);
}

BENCHMARK(slalom)->Unit(benchmark::kMillisecond);
BENCHMARK(mrpt)->Unit(benchmark::kMillisecond);
BENCHMARK(without_scan)->Unit(benchmark::kMillisecond);
BENCHMARK(with_20_people)->Unit(benchmark::kMillisecond);
BENCHMARK(with_20_movers)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace slalom
