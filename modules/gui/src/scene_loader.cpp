#include <slalom/gui/scene_loader.h>

namespace slalom {
namespace {

constexpr const char* kKey = "scene";

}  // namespace

void SceneLoader::show(const Scenario& scenario) {
  jobs_.start(
      kKey, "Show " + scenario.name(),
      [this, scenario](Progress&) -> Jobs::Delivery {
        return [this, scene = prepare_scene(scenario, settings_)] { arrived(scene); };
      },
      [this](const std::string& message) { failed(message); }, false);
}

void SceneLoader::clear() {
  jobs_.cancel(kKey);
  if (on_scene) on_scene(nullptr);
}

void SceneLoader::arrived(const ScenePtr& scene) {
  if (on_scene) on_scene(scene);
  if (scene->complete()) return;
  jobs_.start(
      kKey, "Paths and clearance of " + scene->scenario().name(),
      [this, scene](Progress& progress) -> Jobs::Delivery {
        return [this, next = next_step(scene, progress)] { arrived(next); };
      },
      [this](const std::string& message) { failed(message); }, false);
}

void SceneLoader::failed(const std::string& message) {
  if (on_error) on_error(message);
}

}  // namespace slalom
