#pragma once

#include <slalom/studio/jobs.h>
#include <slalom/studio/notices.h>
#include <slalom/studio/scene.h>

namespace slalom {

/// Computes the scene of the current scenario step by step in background jobs. Publishes
/// Change::Scene.
class SceneLoader {
 public:
  SceneLoader(Jobs& jobs, Notices& notices, SceneSettings settings)
      : jobs_(jobs), notices_(notices), settings_(std::move(settings)) {}

  const SceneSettings& settings() const { return settings_; }
  const ScenePtr& scene() const { return scene_; }  ///< null if there is no scenario
  void show(const Scenario& scenario);
  void clear();

 private:
  using Compute = std::function<ScenePtr(Progress&)>;
  void start(const std::string& title, Compute compute);
  void set_scene(const ScenePtr& scene);

  Jobs& jobs_;
  Notices& notices_;
  SceneSettings settings_;
  ScenePtr scene_;
};

}  // namespace slalom
