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

/// A map and a thousand places in its free space, at least 0.2 m from obstacles.
struct Course {
  std::unique_ptr<World> world;
  std::vector<TPose2D> poses;
};

Course make_course(Scenario scenario) {
  Course course;
  course.world = std::make_unique<World>(std::move(scenario), 0.05);
  RandomEngine random(1);
  const Bounds& b = course.world->scenario().bounds();
  while (course.poses.size() < 1000) {
    const TPose2D pose(uniform_real(random, b.x_min, b.x_max),
                       uniform_real(random, b.y_min, b.y_max), uniform_real(random, -M_PI, M_PI));
    if (course.world->distance_field().clearance({pose.x, pose.y}) > 0.2)
      course.poses.push_back(pose);
  }
  return course;
}

/// 20 m x 20 m with 40 discs, as a grid of 400 x 400 cells.
const Course& discs() {
  static const Course course = [] {
    RandomEngine random(7);
    Primitives obstacles;
    for (int i = 0; i < 40; ++i)
      obstacles.discs.push_back({{uniform_real(random, 0, 20), uniform_real(random, 0, 20)},
                                 uniform_real(random, 0.2, 0.8)});
    const Scenario scenario =
        Scenario::continuous("discs", {0, 0, 20, 20}, obstacles, {1, 1, 0}, {19, 19});
    return make_course(convert(scenario, Representation::Grid, 0.05));
  }();
  return course;
}

/// A laser-scanned campus of 1888 x 2738 cells; empty where the data set is not installed.
const Course& campus() {
  static const Course course = [] {
    if (!std::filesystem::exists(kCampus)) return Course{};
    mrpt::io::CFileGZInputStream file(kCampus);
    COccupancyGridMap2D map;
    mrpt::serialization::archiveFrom(file) >> map;
    const double x = 0.5 * (map.getXMin() + map.getXMax());
    const double y = 0.5 * (map.getYMin() + map.getYMax());
    return make_course(Scenario::grid("campus", map, {x, y, 0}, {x, y}));
  }();
  return course;
}

void count_rays(benchmark::State& state) {
  state.counters["rays"] = benchmark::Counter(
      static_cast<double>(state.iterations()) * kGeometry.count, benchmark::Counter::kIsRate);
}

void exact(benchmark::State& state, const Course& (*make)()) {
  const Course& course = make();
  if (!course.world) return state.SkipWithError("data set not installed");
  const RayCaster& caster = course.world->ray_caster();
  std::vector<float> ranges(static_cast<std::size_t>(kGeometry.count));
  std::size_t i = 0;
  for (auto _ : state) {
    caster.cast_scan(course.poses[i++ % course.poses.size()], kGeometry, ranges.data());
    benchmark::DoNotOptimize(ranges.data());
    benchmark::ClobberMemory();
  }
  count_rays(state);
}

/// maxRange bounds MRPT's steps, not the distance: divided by the step it sees all of the 8 m.
void mrpt_approximate(benchmark::State& state, const Course& (*make)()) {
  const Course& course = make();
  if (!course.world) return state.SkipWithError("data set not installed");
  const COccupancyGridMap2D& map = *course.world->scenario().grid_map();
  mrpt::obs::CObservation2DRangeScan scan;
  scan.aperture = static_cast<float>(kGeometry.aperture);
  scan.maxRange = static_cast<float>(kGeometry.max_range /
                                     COccupancyGridMap2D::RAYTRACE_STEP_SIZE_IN_CELL_UNITS);
  std::size_t i = 0;
  for (auto _ : state) {
    map.laserScanSimulator(scan, mrpt::poses::CPose2D(course.poses[i++ % course.poses.size()]),
                           0.5F, static_cast<std::size_t>(kGeometry.count));
    benchmark::DoNotOptimize(scan);
  }
  count_rays(state);
}

void tables(benchmark::State& state, const Course& (*make)()) {
  const Course& course = make();
  if (!course.world) return state.SkipWithError("data set not installed");
  for (auto _ : state) {
    const RayCaster caster(course.world->occupancy());
    benchmark::DoNotOptimize(caster);
  }
}

void distance_field(benchmark::State& state, const Course& (*make)()) {
  const Course& course = make();
  if (!course.world) return state.SkipWithError("data set not installed");
  for (auto _ : state) {
    const DistanceField field(course.world->occupancy());
    benchmark::DoNotOptimize(field);
  }
}

void clearance(benchmark::State& state, const Course& (*make)()) {
  const Course& course = make();
  if (!course.world) return state.SkipWithError("data set not installed");
  const DistanceField& field = course.world->distance_field();
  std::size_t i = 0;
  for (auto _ : state) {
    const TPose2D& pose = course.poses[i++ % course.poses.size()];
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
