// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/generation/generator.h>
#include <slalom/generation/start_goal.h>

namespace slalom {

/// Options of the people of [generator.circle_crossing] and [generator.square_crossing]. The number
/// is drawn per scenario, radius and speed are drawn per person. The defaults are CrowdNav's.
struct CrossingPeopleOptions {
  int min_people = 5, max_people = 5;
  double min_radius = 0.3, max_radius = 0.3;  ///< m
  double min_speed = 1, max_speed = 1;        ///< m/s, the preferred one
  double gap = 0.2;                           ///< m, between people where they start and end

  void visit(OptionVisitor& v);
};

/// Section [generator.circle_crossing]: the robot and people on a circle, each bound for the
/// opposite point. After the circle crossing of CrowdNav (Chen et al. 2019).
struct CircleCrossingOptions {
  static constexpr char kFamily[] = "circle_crossing";
  double min_circle = 4, max_circle = 4;  ///< m, radius of the circle, drawn per scenario
  double noise = 0.5;  ///< m, greatest shift of a person's start off the circle, along x and y
  CrossingPeopleOptions people;
  StartGoalOptions start_goal = {0.5, 8, 2};

  void visit(OptionVisitor& v);
};

/// Section [generator.square_crossing]: people who cross the middle of a square, along which the
/// robot goes. After the square crossing of CrowdNav.
struct SquareCrossingOptions {
  static constexpr char kFamily[] = "square_crossing";
  double side = 10;  ///< m, of the square in which people start and end
  CrossingPeopleOptions people;
  StartGoalOptions start_goal = {0.5, 8, 2};

  void visit(OptionVisitor& v);
};

/// People start anywhere on the circle, shifted by up to `noise`, and end at the point opposite to
/// their start. In both families start and goal of a person keep `gap` from those of all others,
/// and clear_radius from start and goal of the robot. People set off when the run begins and stay
/// at their goals. generate() throws Error (Job) if no such places are found.
std::unique_ptr<Generator> make_generator(const CircleCrossingOptions& options,
                                          const GeneratorContext& context = {});
/// Each person starts anywhere in one half of the square and ends anywhere in the other. The robot
/// goes along the line between the halves, from min_distance to `side` far.
std::unique_ptr<Generator> make_generator(const SquareCrossingOptions& options,
                                          const GeneratorContext& context = {});

}  // namespace slalom
