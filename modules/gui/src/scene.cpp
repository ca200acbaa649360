#include <slalom/gui/scene.h>
#include <slalom/references/voronoi_diagram.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

namespace slalom {
namespace {

CellPyramid mask_pyramid(const Occupancy& cells, std::vector<std::uint8_t> mask) {
  for (std::uint8_t& value : mask) value = value != 0 ? 255 : 0;
  return {cells, std::move(mask), CellPyramid::Merge::Emphasise};
}

void add_clearance(SceneData& scene) {
  const World& world = *scene.world;
  const Occupancy& cells = world.occupancy();
  const DistanceField& field = world.distance_field();
  scene.clearance = std::make_shared<CellPyramid>(clearance_pyramid(cells, field));
  scene.largest_clearance = *std::max_element(field.centers().begin(), field.centers().end());
  // Nearer than two cells the ridge shows the corners of cells, not the place.
  const double least = std::max(scene.settings.robot.radius, 2 * cells.resolution());
  scene.voronoi = std::make_shared<CellPyramid>(mask_pyramid(cells, voronoi_diagram(world, least)));
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
  constexpr std::uint64_t kNoPlanner = 0;
  scene.references = std::make_shared<References>(
      compute_references(problem, nullptr, scene.settings.gap, kNoPlanner));
}

/// `compute` on a copy of the scene; what it throws about the scenario becomes the problem.
template <typename Compute>
ScenePtr with_step(const SceneData& scene, SceneData::Step step, Compute compute) {
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

}  // namespace

ScanGeometry SceneData::scan_geometry() const {
  return {settings.sensor.rays, settings.sensor.aperture(), settings.sensor.max_range};
}

std::string SceneData::missing_paths() const {
  if (references) return "";
  return problem.empty() ? "being computed" : problem;
}

ScenePtr prepare_scene(Scenario scenario, const SceneSettings& settings) {
  SceneData scene;
  scene.settings = settings;
  scene.world = std::make_shared<World>(std::move(scenario), settings.resolution);
  return with_step(scene, SceneData::Step::Obstacles, [](SceneData& next) {
    const Occupancy& cells = next.world->occupancy();
    next.obstacles = std::make_shared<CellPyramid>(mask_pyramid(cells, cells.cells()));
  });
}

ScenePtr next_step(const ScenePtr& scene, Progress& progress) {
  if (scene->complete()) return scene;
  const bool paths = scene->known == SceneData::Step::Clearance;
  progress.start(paths ? "reference paths" : "clearance", 1);
  ScenePtr next = paths ? with_step(*scene, SceneData::Step::Paths, add_paths)
                        : with_step(*scene, SceneData::Step::Clearance, add_clearance);
  progress.advance(1);
  progress.finish();
  return next;
}

CellPyramid clearance_pyramid(const Occupancy& cells, const DistanceField& field) {
  const std::vector<float>& centers = field.centers();
  const float most = *std::max_element(centers.begin(), centers.end());
  std::vector<std::uint8_t> values;
  values.reserve(centers.size());
  for (const float d : centers)
    values.push_back(most > 0 ? static_cast<std::uint8_t>(std::lround(255 * d / most)) : 0);
  return {cells, std::move(values), CellPyramid::Merge::Mean};
}

}  // namespace slalom
