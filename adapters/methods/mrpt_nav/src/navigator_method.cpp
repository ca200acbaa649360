// SPDX-License-Identifier: BSD-3-Clause
#include "navigation_log.h"
#include "navigator_config.h"
#include "navigator_factory.h"
#include "simulated_robot.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/methods/goal_turn.h>
#include <slalom/methods/registry.h>
#include <slalom/mrpt_nav/navigator_method.h>

#include <optional>

namespace slalom {
namespace {

using mrpt::nav::CAbstractNavigator;
using mrpt::nav::CAbstractPTGBasedReactive;

CAbstractNavigator::TNavigationParams navigation_to(const NavigationTask& task) {
  CAbstractNavigator::TNavigationParams parameters;
  parameters.target.target_coords = {task.goal.x, task.goal.y, task.goal_heading.value_or(0)};
  parameters.target.targetAllowedDistance = static_cast<float>(task.goal_tolerance);
  return parameters;
}

/// Returns the reason in a log message of MRPT that quotes an exception, "" for other messages.
std::string quoted_exception(const std::string& message) {
  const std::size_t word = message.find("xception:");
  if (word == std::string::npos) return "";
  const std::size_t begin = message.find_first_not_of("\n ", word + 9);
  if (begin == std::string::npos) return trim(message);
  return reason_of(std::runtime_error(message.substr(begin)));
}

/// A navigator as a method; each run is one navigation.
class NavigatorMethod : public Method {
 public:
  NavigatorMethod(const RobotModel& robot, const NavigatorOptions& options,
                  const OptionLocation& where)
      : model_(robot),
        robot_(robot, options.obstacle_height),
        factory_(robot, options, where),
        navigator_(factory_.make(robot_)) {
    register_log_callback();
    if (!options.record_navlog.empty()) log_.emplace(options.record_navlog, options.name);
  }

  void prepare_log(const std::string& where) const {
    try {
      if (log_) log_->prepare();
    } catch (const std::exception& e) {
      throw usage_error(where, reason_of(e), "a writable folder");
    }
    if (log_ && with_generators() == nullptr)
      throw usage_error(where, "this navigator writes no such log",
                        "a navigator with trajectory generators");
  }

  void reset(const NavigationTask& task) override {
    task_ = task;
    robot_.start_run(task.control_period);
    if (!is_used_ || !reset_navigator()) create_navigator();
    is_used_ = true;
    if (log_) log_->start_run(task, *with_generators());
    const auto parameters = navigation_to(task);
    navigator_->navigate(&parameters);
  }

  Command step(const Observation& observation) override {
    if (const auto turn = turn_at_goal(task_, observation, model_)) return *turn;
    robot_.observe(observation);
    navigate();
    return robot_.command();
  }

 private:
  CAbstractPTGBasedReactive* with_generators() const {
    return dynamic_cast<CAbstractPTGBasedReactive*>(navigator_.get());
  }

  /// Resets the navigator to its initial state. Returns false if this is not possible.
  bool reset_navigator() {
    auto* reusable = dynamic_cast<ReusableNavigator*>(navigator_.get());
    if (has_failed_ || reusable == nullptr) return false;
    navigator_->cancel();
    navigator_->navigationStep();  // it becomes idle, so the next navigation starts from scratch
    return reusable->reset_for_next_run();
  }

  void create_navigator() {
    robot_.restart_timer();
    if (is_used_) navigator_ = factory_.make(robot_);
    register_log_callback();
    has_failed_ = false;
  }

  /// MRPT's navigators catch their exceptions and only log them.
  void register_log_callback() {
    failure_.clear();
    navigator_->logRegisterCallback([this](std::string_view message, mrpt::system::VerbosityLevel,
                                           std::string_view, mrpt::system::TTimeStamp) {
      if (failure_.empty()) failure_ = quoted_exception(std::string(message));
    });
  }

  void navigate() {
    try {
      navigator_->navigationStep();
    } catch (...) {
      has_failed_ = true;
      throw;
    }
    if (log_) log_->add(*with_generators());
    check_failure();
  }

  /// A navigator that gives up its target stops, which is not an error: the run will be stuck.
  /// Other failures are errors.
  void check_failure() {
    if (!failure_.empty()) {
      has_failed_ = true;
      throw MethodError(failure_);
    }
    if (navigator_->getCurrentState() != CAbstractNavigator::NAV_ERROR) return;
    has_failed_ = true;
    const auto& reason = navigator_->getErrorReason();
    if (reason.error_code != CAbstractNavigator::ERR_CANNOT_REACH_TARGET)
      throw MethodError(reason_of(std::runtime_error(reason.error_msg)));
  }

  RobotModel model_;
  NavigationTask task_;
  SimulatedRobot robot_;
  NavigatorFactory factory_;
  NavigatorPtr navigator_;
  std::optional<NavigationLog> log_;
  std::string failure_;  ///< exception text logged by the navigator
  bool is_used_ = false;
  bool has_failed_ = false;
};

MethodFactory make_factory(const NavigatorOptions& options, const OptionLocation& where) {
  return [options, where](const RobotModel& robot, const SensorModel&) {
    auto method = std::make_unique<NavigatorMethod>(robot, options, where);
    method->prepare_log(where("record_navlog"));
    return method;
  };
}

}  // namespace

void NavigatorOptions::visit(OptionVisitor& v) {
  v.option("class", class_name,
           "CReactiveNavigationSystem (default), CReactiveNavigationSystem3D, or a plug-in class");
  v.option("config", config, External::File, "MRPT .ini of the navigator");
  v.option("plugin", plugin, External::Library, "library with a custom navigator");
  v.option("modules", modules, External::Modules,
           "MRPT plug-in modules to load first, separated by commas");
  v.option("robot", robot, "source of the robot's shape and limits");
  v.option("margin", margin, "m", "added to the robot's shape", Range::at_least(0));
  v.option("obstacle_height", obstacle_height, "m", "z coordinate of the obstacle points");
  v.option("config_set", config_set, "SECTION.KEY=VALUE; ... overrides of the file");
  v.option("obstacle_filter", obstacle_filter, "point-cloud filter");
  v.option("ptg_cache", ptg_cache, External::Folder,
           "folder for collision grids; none: a temporary one");
  v.option("record_navlog", record_navlog, External::Folder,
           "folder for a .reactivenavlog of each run");
}

MethodFactory mrpt_navigator(const NavigatorOptions& options) {
  check_options(options, location_of("mrpt_navigator"));
  return make_factory(options, location_of("mrpt_navigator"));
}

std::optional<std::string> navigator_config_value(const IniFile& ini, const std::string& section,
                                                  const std::string& name) {
  const auto options = read_mrpt_options<NavigatorOptions>(ini, section);
  mrpt::config::CConfigFileMemory config;
  if (!options.config.empty()) config = read_navigator_config(options.config);
  return value_of_key(config, options.config_set, name, ini.where(section, "config_set"));
}

MethodFactory read_navigator_method(const IniFile& ini, const std::string& section) {
  auto options = read_mrpt_options<NavigatorOptions>(ini, section);
  options.name = section.substr(section.find('.') + 1);
  return make_factory(options, location_in(ini, section));
}

}  // namespace slalom
