#pragma once

#include <slalom/core/progress.h>
#include <slalom/gui/cell_pyramid.h>
#include <slalom/references/reference.h>
#include <slalom/robot/robot_model.h>
#include <slalom/scenario/world.h>

#include <memory>
#include <string>

namespace slalom {

/// For whom a scenario is looked at.
struct SceneSettings {
  RobotModel robot;
  SensorModel sensor;
  double resolution = 0.05;  ///< m, of cells made from primitives or points
  double gap = 0.01;         ///< relative, of the certificate of the shortest path
};

/// Snapshot of a scenario and what was computed about it so far: what the layers of the view draw.
/// It is computed in steps, the quick ones first, each of which gives a new snapshot.
struct SceneData {
  enum class Step { Obstacles, Clearance, Paths };

  SceneSettings settings;
  Step known = Step::Obstacles;  ///< the last step that is done, or failed

  std::shared_ptr<const World> world;            ///< never null
  std::shared_ptr<const CellPyramid> obstacles;  ///< occupied 255, free 0; null: see `problem`
  /// From step Clearance; null before. Values are clearances, 255 the largest in the scenario.
  std::shared_ptr<const CellPyramid> clearance;
  double largest_clearance = 0;                   ///< m
  std::shared_ptr<const CellPyramid> voronoi;     ///< 255 on the diagram where the robot fits
  const DistanceField* distance_field = nullptr;  ///< of `world`
  const RayCaster* ray_caster = nullptr;          ///< of `world`
  std::shared_ptr<const References> references;   ///< from step Paths; null before

  std::string problem;  ///< why the step after `known` cannot be done; empty: it can or is done

  const Scenario& scenario() const { return world->scenario(); }
  bool complete() const { return known == Step::Paths || !problem.empty(); }
  ScanGeometry scan_geometry() const;
  /// Why there are no paths yet, or never.
  std::string missing_paths() const;
};

using ScenePtr = std::shared_ptr<const SceneData>;

/// The first step: obstacles as they are drawn. Any thread may call this and the next.
ScenePtr prepare_scene(Scenario scenario, const SceneSettings& settings);
/// The scene with the next step; the scene itself when it is complete. A step that cannot be done,
/// for instance for want of memory, leaves its reason in `problem`.
ScenePtr next_step(const ScenePtr& scene, Progress& progress);

/// The picture of clearances: at_center() of every cell in parts of 255 of the largest.
CellPyramid clearance_pyramid(const Occupancy& cells, const DistanceField& field);

}  // namespace slalom
