#pragma once

#include <slalom/mrpt_nav/navigator_method.h>
#include <slalom/simulation/simulate.h>

#include <string>

namespace slalom {

inline const char* const kStockConfig =
    "/usr/share/mrpt/config_files/navigation-ptgs/reactive2d_config.ini";

/// The method of a section [method.nav] with these lines.
inline std::unique_ptr<Method> load_navigator(const std::string& keys,
                                              const RobotModel& robot = {}) {
  const IniFile ini =
      IniFile::from_text("[method.nav]\nadapter = mrpt_navigator\n" + keys, "campaign.ini");
  return make_navigator_method({ini, "method.nav", robot, {}});
}

/// A room of 10 m x 10 m.
inline World navigator_room(const Primitives& obstacles = {},
                            const mrpt::math::TPose2D& start = {1, 5, 0},
                            const mrpt::math::TPoint2D& goal = {9, 5}) {
  return {Scenario::continuous("room", {0, 0, 10, 10}, obstacles, start, goal), 0.05};
}

inline World navigator_room_with_discs() {
  Primitives obstacles;
  obstacles.discs = {{{4, 5.2}, 0.5}, {{6.5, 3.8}, 0.4}};
  return navigator_room(obstacles);
}

inline SimulationResult drive(Method& method, const World& world, const RunSetup& setup = {}) {
  return simulate(world, setup, 1, method);
}

}  // namespace slalom
