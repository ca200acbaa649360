#pragma once

#include <slalom/methods/method.h>

#include <memory>
#include <string>

namespace slalom {

/// Section [method.NAME] with adapter = mrpt_navigator.
struct NavigatorOptions {
  std::string class_name;          ///< "": CReactiveNavigationSystem, or what the plug-in makes
  std::string config;              ///< the navigator's own MRPT .ini; a plug-in may do without
  std::string plugin;              ///< a library with slalom_make_navigator_v1()
  std::string modules;             ///< MRPT plug-in modules to load first: PTGs, holonomic methods
  std::string robot = "campaign";  ///< whose shape and limits: campaign or config
  double margin = 0.05;            ///< m by which the shape is enlarged that the navigator is told
  double obstacle_height = 0.1;    ///< m at which the navigator is told obstacles
  std::string config_set;          ///< "SECTION.KEY=VALUE; ..." in place of the file's
  std::string obstacle_filter = "config";  ///< point-cloud filter: config, on or off
  std::string ptg_cache;      ///< folder that keeps collision grids; "": a temporary one
  std::string record_navlog;  ///< folder for a .reactivenavlog of each run; "": none

  void visit(OptionVisitor& v);
};

/// Any navigator derived from mrpt::nav::CAbstractNavigator, built in or from a plug-in, as a
/// method. It is built once and forgets between runs. mrpt::Clock must be simulated while it runs,
/// as it is in simulate(). Throws Error (Usage), one line, for a class, library, symbol or file
/// that is not there and for an .ini that the navigator refuses.
std::unique_ptr<Method> make_navigator_method(const MethodContext& context);

}  // namespace slalom
