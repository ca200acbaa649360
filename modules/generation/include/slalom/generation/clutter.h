// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/generation/generator.h>
#include <slalom/generation/map_window.h>
#include <slalom/generation/obstacles.h>
#include <slalom/generation/start_goal.h>

namespace slalom {

/// Section [generator.clutter]: a real map with additional random obstacles.
struct ClutterOptions {
  static constexpr char kFamily[] = "clutter";
  MapWindowOptions window;
  ObstacleOptions obstacles = {3, 15, {0.08, 0.35}, 0.5, 0.3};
  StartGoalOptions start_goal = {0.5, 5, 0.5};

  void visit(OptionVisitor& v);
};

/// A random window of the map as a grid, with random discs and polygons centered at free points;
/// start and goal in free space.
std::unique_ptr<Generator> make_generator(const ClutterOptions& options,
                                          const GeneratorContext& context = {});

}  // namespace slalom
