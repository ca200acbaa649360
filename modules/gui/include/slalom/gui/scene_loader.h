#pragma once

#include <slalom/gui/jobs.h>
#include <slalom/gui/scene.h>

#include <functional>
#include <string>

namespace slalom {

/// Brings what is seen of the scenario that is shown, step by step, without making the window wait.
class SceneLoader {
 public:
  SceneLoader(Jobs& jobs, SceneSettings settings) : jobs_(jobs), settings_(std::move(settings)) {}

  std::function<void(ScenePtr)> on_scene;  ///< null when nothing is shown
  std::function<void(const std::string& message)> on_error;

  const SceneSettings& settings() const { return settings_; }
  void show(const Scenario& scenario);
  void clear();

 private:
  void arrived(const ScenePtr& scene);
  void failed(const std::string& message);

  Jobs& jobs_;
  SceneSettings settings_;
};

}  // namespace slalom
