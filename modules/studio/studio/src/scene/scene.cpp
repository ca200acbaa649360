// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/math.h>
#include <slalom/references/voronoi_diagram.h>
#include <slalom/studio/scene.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

namespace slalom {
namespace {

CellPyramid mask_pyramid(const Occupancy& cells, std::vector<std::uint8_t> mask) {
  for (std::uint8_t& value : mask) value = value != 0 ? 255 : 0;
  return {cells, std::move(mask), CellPyramid::Merge::Emphasize};
}

void add_clearance(SceneData& scene) {
  const World& world = *scene.world;
  const Occupancy& cells = world.occupancy();
  const DistanceField& field = world.distance_field();
  scene.clearance = std::make_shared<CellPyramid>(clearance_pyramid(cells, field));
  scene.max_clearance = *std::max_element(field.centers().begin(), field.centers().end());
  // Below two cells the ridges are artifacts of cell corners.
  const double min_clearance = std::max(scene.settings.robot.radius, 2 * cells.resolution());
  scene.voronoi =
      std::make_shared<CellPyramid>(mask_pyramid(cells, voronoi_diagram(world, min_clearance)));
  scene.ray_caster = &world.ray_caster();
  scene.distance_field = &field;
}

void add_paths(SceneData& scene) {
  const auto& start = scene.scenario().start();
  const PlanningProblem problem{*scene.world,
                                scene.settings.robot.radius,
                                {start.x, start.y},
                                scene.scenario().goal(),
                                start.phi};
  constexpr std::uint64_t kUnusedSeed = 0;
  scene.references = std::make_shared<References>(
      compute_references(problem, nullptr, scene.settings.gap, kUnusedSeed));
}

/// Runs `compute` on a copy of the scene; an exception becomes its `problem`.
template <typename Compute>
ScenePtr compute_step(const SceneData& scene, SceneData::Step step, Compute compute) {
  auto next = std::make_shared<SceneData>(scene);
  try {
    compute(*next);
    next->known = step;
  } catch (const std::exception& e) {
    next = std::make_shared<SceneData>(scene);
    next->problem = e.what();
  }
  return next;
}

constexpr const char* kSceneKey = "scene";

}  // namespace

CellPyramid::CellPyramid(const Occupancy& cells, std::vector<std::uint8_t> values, Merge merge)
    : resolution_(cells.resolution()), bounds_(cells.bounds()) {
  levels_.push_back({cells.size_x(), cells.size_y(), std::move(values)});
  while (std::max(levels_.back().size_x, levels_.back().size_y) > kTileSize)
    levels_.push_back(downsample(levels_.back(), merge));
}

/// The last cells of a row or column of odd length are merged with themselves.
CellPyramid::Level CellPyramid::downsample(const Level& fine, Merge merge) {
  Level result{(fine.size_x + 1) / 2, (fine.size_y + 1) / 2, {}};
  const auto across = static_cast<std::size_t>(fine.size_x);
  result.values.reserve(static_cast<std::size_t>(result.size_x) *
                        static_cast<std::size_t>(result.size_y));
  for (int y = 0; y < fine.size_y; y += 2) {
    const std::uint8_t* low = &fine.values[static_cast<std::size_t>(y) * across];
    const std::uint8_t* high = y + 1 < fine.size_y ? low + across : low;
    for (int x = 0; x < fine.size_x; x += 2) {
      const int right = std::min(x + 1, fine.size_x - 1);
      const int mean = (low[x] + low[right] + high[x] + high[right] + 2) / 4;
      const int max = std::max({low[x], low[right], high[x], high[right]});
      result.values.push_back(
          static_cast<std::uint8_t>(merge == Merge::Mean ? mean : (mean + max + 1) / 2));
    }
  }
  return result;
}

int CellPyramid::level_for(double pixels_per_meter) const {
  const double cell = resolution_ * pixels_per_meter;
  if (!(cell < 1)) return 0;
  // Minus 1e-6, so that rounding errors do not select the next level for exactly half a pixel.
  const int level = static_cast<int>(std::ceil(math::log2(1 / cell) - 1e-6));
  return std::min(level, levels() - 1);
}

std::vector<CellTile> CellPyramid::tiles_in(int level, const Bounds& visible) const {
  const double side = kTileSize * resolution_ * std::ldexp(1.0, level);
  const auto range = [side](double from, double to, double origin, int cells) {
    const int last = (cells - 1) / kTileSize;
    const double first_visible = std::floor((from - origin) / side);
    const double last_visible = std::floor((to - origin) / side);
    return std::pair(static_cast<int>(std::clamp(first_visible, 0.0, last + 1.0)),
                     static_cast<int>(std::clamp(last_visible, -1.0, static_cast<double>(last))));
  };
  const auto [left, right] = range(visible.x_min, visible.x_max, bounds_.x_min, size_x(level));
  const auto [low, high] = range(visible.y_min, visible.y_max, bounds_.y_min, size_y(level));
  std::vector<CellTile> tiles;
  for (int y = low; y <= high; ++y)
    for (int x = left; x <= right; ++x) tiles.push_back({level, x, y});
  return tiles;
}

int CellPyramid::tile_size_x(const CellTile& tile) const {
  return std::min(kTileSize, size_x(tile.level) - tile.x * kTileSize);
}

int CellPyramid::tile_size_y(const CellTile& tile) const {
  return std::min(kTileSize, size_y(tile.level) - tile.y * kTileSize);
}

Bounds CellPyramid::bounds_of(const CellTile& tile) const {
  const double cell = resolution_ * std::ldexp(1.0, tile.level);
  const double left = bounds_.x_min + tile.x * kTileSize * cell;
  const double low = bounds_.y_min + tile.y * kTileSize * cell;
  return {left, low, left + tile_size_x(tile) * cell, low + tile_size_y(tile) * cell};
}

ScenePtr prepare_scene(Scenario scenario, const SceneSettings& settings) {
  SceneData scene;
  scene.settings = settings;
  scene.world = std::make_shared<World>(std::move(scenario), settings.resolution);
  return compute_step(scene, SceneData::Step::Obstacles, [](SceneData& next) {
    const Occupancy& cells = next.world->occupancy();
    next.obstacles = std::make_shared<CellPyramid>(mask_pyramid(cells, cells.cells()));
  });
}

ScenePtr compute_next_step(const ScenePtr& scene, Progress& progress) {
  if (scene->complete()) return scene;
  const bool paths = scene->known == SceneData::Step::Clearance;
  progress.start(paths ? "reference paths" : "clearance", 1);
  ScenePtr next = paths ? compute_step(*scene, SceneData::Step::Paths, add_paths)
                        : compute_step(*scene, SceneData::Step::Clearance, add_clearance);
  progress.advance(1);
  progress.finish();
  return next;
}

CellPyramid clearance_pyramid(const Occupancy& cells, const DistanceField& field) {
  const SharedArray<float>& centers = field.centers();
  const float max = *std::max_element(centers.begin(), centers.end());
  std::vector<std::uint8_t> values;
  values.reserve(centers.size());
  for (const float d : centers)
    values.push_back(max > 0 ? static_cast<std::uint8_t>(std::lround(255 * d / max)) : 0);
  return {cells, std::move(values), CellPyramid::Merge::Mean};
}

void SceneLoader::start(const std::string& title, Compute compute) {
  jobs_.start(
      kSceneKey, title,
      [this, compute = std::move(compute)](Progress& progress) -> Jobs::Delivery {
        return [this, scene = compute(progress)] { set_scene(scene); };
      },
      [this](const std::string& message) { events_.show_error(message); }, false);
}

void SceneLoader::show(const Scenario& scenario) {
  start("Show " + scenario.name(),
        [scenario, settings = settings_](Progress&) { return prepare_scene(scenario, settings); });
}

void SceneLoader::clear() {
  jobs_.cancel(kSceneKey);
  scene_ = nullptr;
  events_.publish(Change::Scene);
}

void SceneLoader::set_scene(const ScenePtr& scene) {
  scene_ = scene;
  events_.publish(Change::Scene);
  if (scene->complete()) return;
  start("Compute paths and clearance of " + scene->scenario().name(),
        [scene](Progress& progress) { return compute_next_step(scene, progress); });
}

}  // namespace slalom
