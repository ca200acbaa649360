#pragma once

#include <slalom/core/progress.h>
#include <slalom/references/reference.h>
#include <slalom/robot/robot_model.h>
#include <slalom/scenario/world.h>
#include <slalom/studio/cell_pyramid.h>
#include <slalom/studio/jobs.h>
#include <slalom/studio/notices.h>

#include <memory>
#include <string>

namespace slalom {

/// The robot and the resolution for which a scenario is displayed.
struct SceneSettings {
  RobotModel robot;
  SensorModel sensor;
  double resolution = 0.05;  ///< m, of the cells that primitives or points are converted to
  double gap = 0.01;         ///< relative optimality gap of the shortest path
};

/// Snapshot of a scenario and the data computed of it so far, as drawn by the layers of the view.
/// It is computed in steps, the fast ones first; each step returns a new snapshot.
struct SceneData {
  enum class Step { Obstacles, Clearance, Paths };

  SceneSettings settings;
  Step known = Step::Obstacles;  ///< the last completed step

  std::shared_ptr<const World> world;            ///< never null
  std::shared_ptr<const CellPyramid> obstacles;  ///< occupied 255, free 0; null: see `problem`
  /// Available from step Clearance, null before. Clearance scaled so that 255 is max_clearance.
  std::shared_ptr<const CellPyramid> clearance;
  double max_clearance = 0;                       ///< m
  std::shared_ptr<const CellPyramid> voronoi;     ///< 255 on the diagram, where the robot fits
  const DistanceField* distance_field = nullptr;  ///< of `world`
  const RayCaster* ray_caster = nullptr;          ///< of `world`
  std::shared_ptr<const References> references;   ///< available from step Paths, null before

  std::string problem;  ///< why the step after `known` failed; empty if it did not

  const Scenario& scenario() const { return world->scenario(); }
  bool complete() const { return known == Step::Paths || !problem.empty(); }
  ScanGeometry scan_geometry() const;
  /// Why what is still missing is not there (yet).
  std::string pending_reason() const { return problem.empty() ? "being computed" : problem; }
};

using ScenePtr = std::shared_ptr<const SceneData>;

/// The first step: the obstacles. Thread-safe, as is compute_next_step().
ScenePtr prepare_scene(Scenario scenario, const SceneSettings& settings);
/// The scene after the next step; the same scene if it is complete. If a step fails, e.g. for lack
/// of memory, `problem` contains the reason.
ScenePtr compute_next_step(const ScenePtr& scene, Progress& progress);

/// An image of the clearances: at_center() of each cell, scaled so that the maximum is 255.
CellPyramid clearance_pyramid(const Occupancy& cells, const DistanceField& field);

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
