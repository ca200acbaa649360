#include <slalom/studio/scene_loader.h>

namespace slalom {
namespace {

constexpr const char* kKey = "scene";

}  // namespace

void SceneLoader::start(const std::string& title, Compute compute) {
  jobs_.start(
      kKey, title,
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
  jobs_.cancel(kKey);
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
