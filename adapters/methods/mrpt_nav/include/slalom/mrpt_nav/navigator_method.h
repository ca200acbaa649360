// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>
#include <slalom/methods/method_factory.h>

#include <optional>
#include <string>

namespace slalom {

enum class RobotSource { Campaign, Config };
constexpr auto enum_names(RobotSource) {
  return std::array{"campaign", "config"};
}

/// Whether the navigator filters the point cloud of obstacles.
enum class ObstacleFilter { Config, On, Off };
constexpr auto enum_names(ObstacleFilter) {
  return std::array{"config", "on", "off"};
}

/// A method of the adapter mrpt_navigator.
struct NavigatorOptions {
  std::string class_name;  ///< "": CReactiveNavigationSystem, or the plug-in's default
  std::string config;      ///< MRPT .ini of the navigator; optional with a plug-in
  std::string plugin;      ///< a library with slalom_make_navigator_v1()
  std::string modules;     ///< MRPT plug-in modules to load first: PTGs, holonomic methods
  RobotSource robot = RobotSource::Campaign;  ///< of shape and limits
  double margin = 0.05;                       ///< m added to the shape that the navigator uses
  double obstacle_height = 0.1;               ///< z coordinate of the obstacle points, m
  std::string config_set;                     ///< "SECTION.KEY=VALUE; ..." overriding the file
  ObstacleFilter obstacle_filter = ObstacleFilter::Config;
  std::string ptg_cache;           ///< folder for collision grids; "": a temporary one
  std::string record_navlog;       ///< folder for a .reactivenavlog of each run; "": none
  std::string name = "navigator";  ///< of these logs; in an .ini the name of the method

  void visit(OptionVisitor& v);
};

/// A method from a navigator derived from mrpt::nav::CAbstractNavigator, built in or from a
/// plug-in. The navigator is created once and reset between runs. mrpt::Clock must be simulated
/// while it runs, as in simulate(). The factory throws Error (Usage), one line, for a missing
/// class, library, symbol or file and for an .ini that the navigator rejects.
MethodFactory mrpt_navigator(const NavigatorOptions& options);

/// The same with options from an .ini; a MethodReader.
MethodFactory read_navigator_method(const IniFile& ini, const std::string& section);

/// The value of "SECTION.KEY" in the configuration of a method of an .ini, before that of the robot
/// is written; none if there is no such key. Throws Error (Usage, File) for what cannot be read.
std::optional<std::string> navigator_config_value(const IniFile& ini, const std::string& section,
                                                  const std::string& name);

}  // namespace slalom
