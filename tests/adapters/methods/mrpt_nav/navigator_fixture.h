// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "places.h"

#include <slalom/core/random.h>
#include <slalom/mrpt_nav/navigator_method.h>
#include <slalom/simulation/simulate.h>

#include <string>
#include <vector>

namespace slalom {

/// MRPT's example .ini, as installed by Debian.
inline std::string stock_config() {
  return "/usr/share/mrpt/config_files/navigation-ptgs/reactive2d_config.ini";
}

/// A file of this folder.
inline std::string test_config(const std::string& name) {
  return kSource + "/tests/adapters/methods/mrpt_nav/" + name;
}

/// Creates the method of a section [method.nav] with these lines.
inline std::unique_ptr<Method> load_navigator(const std::string& keys,
                                              const RobotModel& robot = {}) {
  const IniFile ini =
      IniFile::from_text("[method.nav]\nadapter = mrpt_navigator\n" + keys, "campaign.ini");
  return read_navigator_method(ini, "method.nav")(robot, {});
}

inline std::unique_ptr<Method> load_navigator_with(const std::string& config,
                                                   const std::string& keys = "") {
  return load_navigator("config = " + config + "\n" + keys);
}

/// A room of 10 m x 10 m.
inline World navigator_room(const Primitives& obstacles = {}) {
  return {Scenario::continuous("room", {0, 0, 10, 10}, obstacles, {1, 5, 0}, {9, 5}), 0.05};
}

inline World navigator_room_with_discs() {
  Primitives obstacles;
  obstacles.discs = {{{4, 5.2}, 0.5}, {{6.5, 3.8}, 0.4}};
  return navigator_room(obstacles);
}

/// Random discs, not near the start and the goal.
inline World random_navigator_room(std::uint64_t seed) {
  RandomEngine random(seed);
  Primitives obstacles;
  for (int i = 0; i < 8; ++i) {
    const mrpt::math::TPoint2D center{uniform_real(random, 2, 8), uniform_real(random, 0.5, 9.5)};
    obstacles.discs.push_back({center, uniform_real(random, 0.2, 0.5)});
  }
  return navigator_room(obstacles);
}

inline SimulationResult run_navigator(Method& method, const World& world, double max_time = 60,
                                      const RobotModel& robot = {}) {
  RunSetup setup;
  setup.robot = robot;
  setup.simulation.max_time = max_time;
  return simulate(world, setup, 1, method);
}

/// The hashes of `count` successive short runs in different rooms.
inline std::vector<std::string> hashes_of_runs(Method& method, int count, double max_time) {
  std::vector<std::string> hashes;
  for (int i = 0; i < count; ++i)
    hashes.push_back(run_navigator(method, random_navigator_room(i), max_time).trajectory.hash());
  return hashes;
}

}  // namespace slalom
