// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/generation/generator.h>
#include <slalom/generation/straight_path.h>

namespace slalom {

/// Section [generator.sudden_obstacle]: a mover steps from behind a wall onto the straight path of
/// the robot, and stops there.
struct SuddenObstacleOptions : StraightPathOptions {
  static constexpr char kFamily[] = "sudden_obstacle";
  double min_radius = 0.2, max_radius = 0.4;        ///< m, of the mover
  double min_speed = 0.5, max_speed = 1.5;          ///< m/s, of the mover
  double min_appearance = 0.8, max_appearance = 2;  ///< m, of the robot from the mover's place
  double robot_speed = 1;                           ///< m/s, on which the time is based
  double lane = 0.3;                                ///< m, half of the swept width
  double wall_distance = 0.6;                       ///< m, of the wall from the straight path
  double wall = 0.15;                               ///< m, thickness

  SuddenObstacleOptions();
  void visit(OptionVisitor& v);
};

/// The mover reaches the lane when a robot that drives straight at robot_speed from the beginning
/// is `appearance` before the place, which is on the path right behind the wall's end.
std::unique_ptr<Generator> make_generator(const SuddenObstacleOptions& options,
                                          const GeneratorContext& context = {});

}  // namespace slalom
