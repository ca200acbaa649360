// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/progress.h>
#include <slalom/references/reference.h>
#include <slalom/robot/robot_model.h>
#include <slalom/scenario/geometry.h>
#include <slalom/scenario/occupancy.h>
#include <slalom/scenario/world.h>
#include <slalom/studio/jobs.h>
#include <slalom/studio/studio_events.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace slalom {

/// A square tile of one level of a pyramid.
struct CellTile {
  int level = 0, x = 0, y = 0;  ///< column from the left, row from below
  bool operator<(const CellTile& o) const {
    return level != o.level ? level < o.level : y != o.y ? y < o.y : x < o.x;
  }
  bool operator==(const CellTile& o) const { return level == o.level && x == o.x && y == o.y; }
};

/// A grid of values (0 to 255) and coarser copies of it, each of half the resolution, for drawing
/// grids of any size at any zoom in tiles, with about as many cells as pixels.
class CellPyramid {
 public:
  static constexpr int kTileSize = 256;  ///< width and height of a tile, cells

  /// How four cells are merged into one.
  enum class Merge {
    Mean,
    Emphasize,  ///< average of mean and maximum: thin walls stay visible when zoomed out
  };

  /// `values` are row-major from the lower left corner, as in `cells`.
  CellPyramid(const Occupancy& cells, std::vector<std::uint8_t> values, Merge merge);

  int levels() const { return static_cast<int>(levels_.size()); }
  int size_x(int level) const { return levels_[static_cast<std::size_t>(level)].size_x; }
  int size_y(int level) const { return levels_[static_cast<std::size_t>(level)].size_y; }
  /// The values of a row of cells, from the left.
  const std::uint8_t* row(int level, int cy) const {
    const Level& at = levels_[static_cast<std::size_t>(level)];
    return &at.values[static_cast<std::size_t>(cy) * static_cast<std::size_t>(at.size_x)];
  }
  std::uint8_t value(int level, int cx, int cy) const { return row(level, cy)[cx]; }

  /// The finest level whose cells are at least one pixel wide; the coarsest if there is none.
  int level_for(double pixels_per_meter) const;
  /// The visible tiles of a level, row by row.
  std::vector<CellTile> tiles_in(int level, const Bounds& visible) const;
  /// The extent of a tile (m); tiles at the upper and right border are cut off at the grid's end.
  Bounds bounds_of(const CellTile& tile) const;
  int tile_size_x(const CellTile& tile) const;
  int tile_size_y(const CellTile& tile) const;

 private:
  struct Level {
    int size_x = 0, size_y = 0;
    std::vector<std::uint8_t> values;
  };
  static Level downsample(const Level& fine, Merge merge);

  double resolution_;
  Bounds bounds_;
  std::vector<Level> levels_;
};

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
  SceneLoader(Jobs& jobs, StudioEvents& events, SceneSettings settings)
      : jobs_(jobs), events_(events), settings_(std::move(settings)) {}

  const SceneSettings& settings() const { return settings_; }
  const ScenePtr& scene() const { return scene_; }  ///< null if there is no scenario
  void show(const Scenario& scenario);
  void clear();

 private:
  using Compute = std::function<ScenePtr(Progress&)>;
  void start(const std::string& title, Compute compute);
  void set_scene(const ScenePtr& scene);

  Jobs& jobs_;
  StudioEvents& events_;
  SceneSettings settings_;
  ScenePtr scene_;
};

}  // namespace slalom
