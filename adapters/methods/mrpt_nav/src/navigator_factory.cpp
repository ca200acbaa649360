// SPDX-License-Identifier: BSD-3-Clause
#include "navigator_config.h"
#include "navigator_factory.h"
#include "noted_config.h"
#include "plugin_module.h"
#include "ptg_cache_folder.h"
#include "resettable_navigator.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <mrpt/nav/reactive/CReactiveNavigationSystem.h>
#include <mrpt/nav/reactive/CReactiveNavigationSystem3D.h>
#include <mrpt/nav/registerAllClasses.h>

#include <stdexcept>

namespace slalom {
namespace {

const char* const kSymbol = "slalom_make_navigator_v1";
const char* const kNamespace = "mrpt::nav::";

std::string without_namespace(const std::string& name) {
  const std::string prefix = kNamespace;
  return starts_with(name, prefix) ? name.substr(prefix.size()) : name;
}

/// Log messages of navigators must not appear on the terminal of a campaign.
void disable_console_output(mrpt::system::COutputLogger& logger) {
  logger.logging_enable_console_output = false;
  logger.setMinLoggingLevel(mrpt::system::LVL_ERROR);
}

}  // namespace

NavigatorFactory::NavigatorFactory(const RobotModel& robot, const NavigatorOptions& options,
                                   const OptionLocation& where)
    : options_(options), where_(where) {
  mrpt::nav::registerAllClasses_mrpt_nav();
  if (!options.modules.empty())
    for (const std::string& module : split(options.modules, ','))
      load(module, where_("modules"), "an MRPT plug-in module");
  if (!options.plugin.empty()) find_plugin_factory();
  read_config(robot);
}

void* NavigatorFactory::load(const std::string& module, const std::string& where,
                             const std::string& what) const {
  std::string error;
  void* handle = load_plugin_module(module, error);
  if (handle == nullptr) throw usage_error(where, "cannot be loaded (" + error + ")", what);
  return handle;
}

void NavigatorFactory::find_plugin_factory() {
  void* handle = load(options_.plugin, where_("plugin"), "a library with a navigator");
  plugin_ = reinterpret_cast<decltype(plugin_)>(find_in_module(handle, kSymbol));
  if (plugin_ == nullptr)
    throw usage_error(where_("plugin"),
                      "'" + options_.plugin + "' does not export " + kSymbol + "()",
                      "a function marked with SLALOM_NAVIGATOR_EXPORT");
}

void NavigatorFactory::read_config(const RobotModel& robot) {
  if (options_.config.empty() && plugin_ == nullptr)
    throw usage_error(where_("config"), "missing configuration of the navigator", "an MRPT .ini");
  try {
    if (!options_.config.empty()) config_ = read_navigator_config(options_.config);
  } catch (const Error& e) {
    throw usage_error(where_("config"), e.what());
  } catch (const std::exception& e) {
    throw usage_error(where_("config"), reason_of(e), "an MRPT .ini");
  }
  override_config(config_, options_.config_set, where_("config_set"));
  const std::string section = "CAbstractPTGBasedReactive";
  if (options_.robot == RobotSource::Campaign) write_robot(config_, robot, options_.margin);
  if (options_.obstacle_filter != ObstacleFilter::Config)
    config_.write(section, "enable_obstacle_filtering",
                  options_.obstacle_filter == ObstacleFilter::On);
}

NavigatorPtr NavigatorFactory::make(mrpt::nav::CRobot2NavInterface& robot) {
  try {
    NavigatorPtr navigator = make_navigator(robot);
    prepare(*navigator);
    return navigator;
  } catch (const Error&) {
    throw;
  } catch (const std::exception& e) {
    throw usage_error(where_("config"), "the navigator rejects it (" + reason_of(e) + ")",
                      "an MRPT .ini for this navigator");
  }
}

NavigatorPtr NavigatorFactory::make_navigator(mrpt::nav::CRobot2NavInterface& robot) const {
  if (plugin_ == nullptr) return make_built_in(robot);
  NavigatorPtr navigator(plugin_(robot, options_.class_name.c_str()));
  if (!navigator)
    throw usage_error(where_("class"), "the plug-in has no navigator '" + options_.class_name + "'",
                      "a class of the plug-in");
  return navigator;
}

NavigatorPtr NavigatorFactory::make_built_in(mrpt::nav::CRobot2NavInterface& robot) const {
  using Navigator2d = ResettableNavigator<mrpt::nav::CReactiveNavigationSystem>;
  using Navigator3d = ResettableNavigator<mrpt::nav::CReactiveNavigationSystem3D>;
  const std::string name = without_namespace(options_.class_name);
  if (name.empty() || name == "CReactiveNavigationSystem")
    return std::make_unique<Navigator2d>(robot, config_);
  if (name == "CReactiveNavigationSystem3D") return std::make_unique<Navigator3d>(robot, config_);
  throw usage_error(where_("class"), "unknown navigator class '" + options_.class_name + "'",
                    "CReactiveNavigationSystem, CReactiveNavigationSystem3D, or a plugin");
}

void NavigatorFactory::prepare(mrpt::nav::CAbstractNavigator& navigator) {
  disable_console_output(navigator);
  const NotedConfig config(config_);
  try {
    navigator.loadConfigFile(config);
  } catch (const std::exception& e) {
    throw std::runtime_error(config.last_read() + reason_of(e));
  }
  require_overrides(config, options_.config_set, where_("config_set"));
  const PtgCacheFolder cache(options_.ptg_cache, config_.getContent());
  // There is no .ini key for it.
  if (auto* with_generators = dynamic_cast<mrpt::nav::CAbstractPTGBasedReactive*>(&navigator))
    with_generators->params_abstract_ptg_navigator.ptg_cache_files_directory = cache.path();
  navigator.initialize();
  navigator.m_navProfiler.disable();
  navigator.enableRethrowNavExceptions(true);
}

}  // namespace slalom
