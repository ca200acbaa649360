// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/generation/generator.h>
#include <slalom/generation/obstacles.h>
#include <slalom/generation/start_goal.h>

namespace slalom {

/// Section [generator.random]: discs and polygons in a rectangular workspace.
struct RandomGeneratorOptions {
  static constexpr char kFamily[] = "random";
  double width = 12, height = 12;  ///< m
  ObstacleOptions obstacles;
  StartGoalOptions start_goal;

  void visit(OptionVisitor& v);
};

/// Random discs and polygons, uniformly distributed; start and goal anywhere, at least min_distance
/// apart.
std::unique_ptr<Generator> make_generator(const RandomGeneratorOptions& options,
                                          const GeneratorContext& context = {});

}  // namespace slalom
