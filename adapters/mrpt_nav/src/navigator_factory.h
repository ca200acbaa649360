#pragma once

#include <slalom/methods/method.h>
#include <slalom/mrpt_nav/navigator_method.h>
#include <slalom/mrpt_nav/navigator_plugin.h>

#include <mrpt/config/CConfigFileMemory.h>

#include <memory>
#include <string>

namespace slalom {

using NavigatorPtr = std::unique_ptr<mrpt::nav::CAbstractNavigator>;

/// Makes navigators, all alike, for one method. Must outlive them.
class NavigatorFactory {
 public:
  /// Loads what the options name. Throws Error (Usage) for what is not there.
  NavigatorFactory(const MethodContext& context, const NavigatorOptions& options);

  /// A navigator that is ready to drive. Throws Error (Usage) when its .ini does not suit it.
  NavigatorPtr make(mrpt::nav::CRobot2NavInterface& robot);

 private:
  /// Where the keys stand that messages are about.
  struct Places {
    std::string class_name, config, config_set, plugin, modules;
  };

  void* load(const std::string& module, const std::string& place, const std::string& what) const;
  void find_plugin_factory();
  void read_config(const RobotModel& robot);
  NavigatorPtr make_object(mrpt::nav::CRobot2NavInterface& robot) const;
  NavigatorPtr make_built_in(mrpt::nav::CRobot2NavInterface& robot) const;
  void prepare(mrpt::nav::CAbstractNavigator& navigator);

  NavigatorOptions options_;
  Places places_;
  decltype(&slalom_make_navigator_v1) plugin_ = nullptr;
  mrpt::config::CConfigFileMemory config_;
};

}  // namespace slalom
