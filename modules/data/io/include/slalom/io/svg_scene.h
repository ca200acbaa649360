// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/references/reference.h>
#include <slalom/scenario/scenario.h>
#include <slalom/trajectory/trajectory.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The color of the method at `index` in the list of methods, in pictures, reports and the window
/// (Okabe-Ito palette, suitable for color-blind readers, and four more).
std::string method_color(std::size_t index);

/// `text` as character data or attribute value of HTML and SVG; control characters become '?'.
std::string html_escape(const std::string& text);

/// A trajectory in a picture.
struct SceneTrajectory {
  std::string label;
  Path path;
  std::optional<Outcome> outcome = Outcome::Success;  ///< none: not a run
  std::string color;  ///< CSS color; empty: by its index in the list
};

/// Contents of a picture of a scenario besides its obstacles, start and goal.
struct SceneOptions {
  int max_pixels = 480;        ///< of the longer side
  double robot_radius = 0.25;  ///< m, drawn at start and goal
  const References* references = nullptr;
  /// SimulationResult::movers of the run; null: the movers of the scenario, and its people, who
  /// stand where they start.
  const Movers* movers = nullptr;
  /// s of the run, at which movers are drawn; none: at time 0 or where they appear later; minus
  /// infinity: only their paths.
  std::optional<double> time = {};
  std::vector<SceneTrajectory> trajectories;
  std::optional<Bounds> view = {};  ///< the part that is drawn; none: the workspace
};

/// The attributes of the line of the shortest path, or of the safest one.
std::string reference_line(bool shortest);

/// The part of the workspace with start, goal and the trajectories, and `margin` (m) around them.
Bounds view_around(const Scenario& scenario, const std::vector<SceneTrajectory>& trajectories,
                   double margin);

/// A scenario to scale as one self-contained `svg` element. Grids become merged rectangles (runs of
/// cells). Movers and people are drawn with their paths, where they are at the time of the picture.
/// Without SceneOptions::movers the path of a person is its route.
std::string render_svg(const Scenario& scenario, const SceneOptions& options);

}  // namespace slalom
