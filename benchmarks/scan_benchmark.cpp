// SPDX-License-Identifier: BSD-3-Clause
// Scans per second: the exact RayCaster against MRPT's laserScanSimulator, on the same maps and
// poses: 181 rays over 180 degrees, 8 m. Counter `rays` is rays per second.
#include <slalom/core/random.h>
#include <slalom/scenario/world.h>

#include <benchmark/benchmark.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <vector>

namespace slalom {
namespace {

using mrpt::maps::COccupancyGridMap2D;
using mrpt::math::TPose2D;

constexpr const char* kCampus = "/usr/share/mrpt/datasets/2006-MalagaCampus.gridmap.gz";
constexpr ScanGeometry kGeometry{181, M_PI, 8.0};

/// A map and a thousand poses in its free space, at least 0.2 m from obstacles.
struct ScanSetup {
  std::unique_ptr<World> world;
  std::vector<TPose2D> poses;
};

ScanSetup make_setup(Scenario scenario) {
  ScanSetup setup;
  setup.world = std::make_unique<World>(std::move(scenario), 0.05);
  RandomEngine random(1);
  const Bounds& b = setup.world->scenario().bounds();
  while (setup.poses.size() < 1000) {
    const TPose2D pose(uniform_real(random, b.x_min, b.x_max),
                       uniform_real(random, b.y_min, b.y_max), uniform_real(random, -M_PI, M_PI));
    if (setup.world->distance_field().clearance({pose.x, pose.y}) > 0.2)
      setup.poses.push_back(pose);
  }
  return setup;
}

/// 20 m x 20 m with 40 discs, as a grid of 400 x 400 cells.
const ScanSetup& discs() {
  static const ScanSetup setup = [] {
    RandomEngine random(7);
    Primitives obstacles;
    for (int i = 0; i < 40; ++i)
      obstacles.discs.push_back({{uniform_real(random, 0, 20), uniform_real(random, 0, 20)},
                                 uniform_real(random, 0.2, 0.8)});
    const Scenario scenario =
        Scenario::continuous("discs", {0, 0, 20, 20}, obstacles, {1, 1, 0}, {19, 19});
    return make_setup(convert(scenario, Representation::Grid, 0.05));
  }();
  return setup;
}

/// A laser-scanned campus of 1888 x 2738 cells; empty if the data set is not installed.
const ScanSetup& campus() {
  static const ScanSetup setup = [] {
    if (!std::filesystem::exists(kCampus)) return ScanSetup{};
    mrpt::io::CFileGZInputStream file(kCampus);
    COccupancyGridMap2D map;
    mrpt::serialization::archiveFrom(file) >> map;
    const double x = 0.5 * (map.getXMin() + map.getXMax());
    const double y = 0.5 * (map.getYMin() + map.getYMax());
    return make_setup(Scenario::grid("campus", map, {x, y, 0}, {x, y}));
  }();
  return setup;
}

void count_rays(benchmark::State& state) {
  state.counters["rays"] = benchmark::Counter(
      static_cast<double>(state.iterations()) * kGeometry.count, benchmark::Counter::kIsRate);
}

void exact(benchmark::State& state, const ScanSetup& (*make)()) {
  const ScanSetup& setup = make();
  if (!setup.world) return state.SkipWithError("data set not installed");
  const RayCaster& caster = setup.world->ray_caster();
  std::vector<float> ranges(static_cast<std::size_t>(kGeometry.count));
  std::size_t i = 0;
  for (auto _ : state) {
    caster.cast_scan(setup.poses[i++ % setup.poses.size()], kGeometry, ranges.data());
    benchmark::DoNotOptimize(ranges.data());
    benchmark::ClobberMemory();
  }
  count_rays(state);
}

/// maxRange bounds the number of MRPT's steps, not the distance: divided by the step it covers 8 m.
void mrpt_approximate(benchmark::State& state, const ScanSetup& (*make)()) {
  const ScanSetup& setup = make();
  if (!setup.world) return state.SkipWithError("data set not installed");
  const COccupancyGridMap2D& map = *setup.world->scenario().grid_map();
  mrpt::obs::CObservation2DRangeScan scan;
  scan.aperture = static_cast<float>(kGeometry.aperture);
  scan.maxRange = static_cast<float>(kGeometry.max_range /
                                     COccupancyGridMap2D::RAYTRACE_STEP_SIZE_IN_CELL_UNITS);
  std::size_t i = 0;
  for (auto _ : state) {
    map.laserScanSimulator(scan, mrpt::poses::CPose2D(setup.poses[i++ % setup.poses.size()]), 0.5F,
                           static_cast<std::size_t>(kGeometry.count));
    benchmark::DoNotOptimize(scan);
  }
  count_rays(state);
}

void tables(benchmark::State& state, const ScanSetup& (*make)()) {
  const ScanSetup& setup = make();
  if (!setup.world) return state.SkipWithError("data set not installed");
  for (auto _ : state) {
    const RayCaster caster(setup.world->occupancy());
    benchmark::DoNotOptimize(caster);
  }
}

void distance_field(benchmark::State& state, const ScanSetup& (*make)()) {
  const ScanSetup& setup = make();
  if (!setup.world) return state.SkipWithError("data set not installed");
  for (auto _ : state) {
    const DistanceField field(setup.world->occupancy());
    benchmark::DoNotOptimize(field);
  }
}

void clearance(benchmark::State& state, const ScanSetup& (*make)()) {
  const ScanSetup& setup = make();
  if (!setup.world) return state.SkipWithError("data set not installed");
  const DistanceField& field = setup.world->distance_field();
  std::size_t i = 0;
  for (auto _ : state) {
    const TPose2D& pose = setup.poses[i++ % setup.poses.size()];
    benchmark::DoNotOptimize(field.clearance({pose.x, pose.y}));
  }
}

BENCHMARK_CAPTURE(exact, discs, &discs);
BENCHMARK_CAPTURE(mrpt_approximate, discs, &discs);
BENCHMARK_CAPTURE(exact, campus, &campus);
BENCHMARK_CAPTURE(mrpt_approximate, campus, &campus);
BENCHMARK_CAPTURE(tables, discs, &discs)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tables, campus, &campus)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(distance_field, discs, &discs)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(distance_field, campus, &campus)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(clearance, discs, &discs);
BENCHMARK_CAPTURE(clearance, campus, &campus);

}  // namespace
}  // namespace slalom
