// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/mrpt_nav/navigator_method.h>
#include <slalom/mrpt_nav/navigator_plugin.h>

#include <mrpt/config/CConfigFileMemory.h>

#include <memory>
#include <string>

namespace slalom {

using NavigatorPtr = std::unique_ptr<mrpt::nav::CAbstractNavigator>;

/// Creates identical navigators for one method. Must outlive them.
class NavigatorFactory {
 public:
  /// Loads the plug-in, modules and configuration. Throws Error (Usage) if one is missing.
  NavigatorFactory(const RobotModel& robot, const NavigatorOptions& options,
                   const OptionLocation& where);

  /// Returns an initialized navigator. Throws Error (Usage) if it rejects its .ini.
  NavigatorPtr make(mrpt::nav::CRobot2NavInterface& robot);

 private:
  void* load(const std::string& module, const std::string& where, const std::string& what) const;
  void find_plugin_factory();
  void read_config(const RobotModel& robot);
  NavigatorPtr make_navigator(mrpt::nav::CRobot2NavInterface& robot) const;
  NavigatorPtr make_built_in(mrpt::nav::CRobot2NavInterface& robot) const;
  void prepare(mrpt::nav::CAbstractNavigator& navigator);

  NavigatorOptions options_;
  OptionLocation where_;
  decltype(&slalom_make_navigator_v1) plugin_ = nullptr;
  mrpt::config::CConfigFileMemory config_;
};

}  // namespace slalom
