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

ScanGeometry SceneData::scan_geometry() const {
  return {settings.sensor.rays, settings.sensor.aperture(), settings.sensor.max_range};
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
  const std::vector<float>& centers = field.centers();
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
      [this](const std::string& message) { notices_.show_error(message); }, false);
}

void SceneLoader::show(const Scenario& scenario) {
  start("Show " + scenario.name(),
        [scenario, settings = settings_](Progress&) { return prepare_scene(scenario, settings); });
}

void SceneLoader::clear() {
  jobs_.cancel(kSceneKey);
  scene_ = nullptr;
  notices_.publish(Change::Scene);
}

void SceneLoader::set_scene(const ScenePtr& scene) {
  scene_ = scene;
  notices_.publish(Change::Scene);
  if (scene->complete()) return;
  start("Compute paths and clearance of " + scene->scenario().name(),
        [scene](Progress& progress) { return compute_next_step(scene, progress); });
}

}  // namespace slalom
