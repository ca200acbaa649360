// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/generation/generator.h>
#include <slalom/generation/map_window.h>
#include <slalom/generation/start_goal.h>

namespace slalom {

/// Section [generator.crop]: windows of a real map.
struct CropOptions {
  static constexpr char kFamily[] = "crop";
  MapWindowOptions window;
  StartGoalOptions start_goal = {0.4, 5, 0.5};

  void visit(OptionVisitor& v);
};

/// A random window of the map as a grid; start and goal in its free space.
std::unique_ptr<Generator> make_generator(const CropOptions& options,
                                          const GeneratorContext& context = {});

}  // namespace slalom
