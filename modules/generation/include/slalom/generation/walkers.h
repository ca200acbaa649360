// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/random.h>
#include <slalom/scenario/mover.h>
#include <slalom/scenario/world.h>

namespace slalom {

/// Moving discs that walk back and forth among the static obstacles of a scenario.
struct WalkerOptions {
  int count = 0;
  double min_radius = 0.2, max_radius = 0.4;  ///< m
  double min_speed = 0.3, max_speed = 1.0;    ///< m/s, constant for each walker
};

/// `options.count` walkers for the scenario of `world`. Each goes from a random position over up to
/// six random ones in a straight line each, and back along the same path, again and again, whatever
/// the robot does. It keeps at least 0.05 m from obstacles and the border along its path, and when
/// the run begins it is at least 1 m away from a disc of `robot_radius` (m) at the start. Walkers
/// do not avoid each other. Walker i depends only on the world, the options, the state of `engine`
/// and the walkers before it. Throws Error (Job) if no path is found for a walker.
Movers sample_walkers(const World& world, double robot_radius, const WalkerOptions& options,
                      RandomEngine& engine);

/// The scenario of `world` with these walkers in addition to its movers.
Scenario with_walkers(const World& world, double robot_radius, const WalkerOptions& options,
                      RandomEngine& engine);

}  // namespace slalom
