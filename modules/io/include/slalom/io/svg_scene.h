#pragma once

#include <slalom/references/reference.h>
#include <slalom/scenario/scenario.h>
#include <slalom/trajectory/trajectory.h>

#include <string>
#include <vector>

namespace slalom {

/// One trajectory of a picture.
struct SceneTrajectory {
  std::string label;
  Path path;
  Outcome outcome = Outcome::Success;
  std::string color;  ///< of the line, as in CSS; empty: one by its place in the list
};

/// What a picture of a scenario shows besides its obstacles, start and goal.
struct SceneOptions {
  int max_pixels = 480;        ///< longer side
  double robot_radius = 0.25;  ///< m, drawn at start and goal
  const References* references = nullptr;
  std::vector<SceneTrajectory> trajectories;
};

/// A scenario to scale as one self-contained <svg> element. Grids become merged rectangles (runs of
/// cells).
std::string render_svg(const Scenario& scenario, const SceneOptions& options);

}  // namespace slalom
