#include "navigation_log.h"
#include "navigator_factory.h"
#include "simulated_robot.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/mrpt_nav/navigator_method.h>

#include <optional>

namespace slalom {
namespace {

using mrpt::nav::CAbstractNavigator;
using mrpt::nav::CAbstractPTGBasedReactive;

/// The section's name without "method.".
std::string method_name(const std::string& section) {
  return section.substr(section.find('.') + 1);
}

CAbstractNavigator::TNavigationParams navigation_to(const Task& task) {
  CAbstractNavigator::TNavigationParams parameters;
  parameters.target.target_coords = {task.goal.x, task.goal.y, 0};
  parameters.target.targetAllowedDistance = static_cast<float>(task.goal_tolerance);
  return parameters;
}

/// What went wrong, of a log message of MRPT's that quotes an exception; "" of any other.
std::string quoted_exception(const std::string& message) {
  const std::size_t word = message.find("xception:");
  if (word == std::string::npos) return "";
  const std::size_t begin = message.find_first_not_of("\n ", word + 9);
  if (begin == std::string::npos) return trim(message);
  return reason_of(std::runtime_error(message.substr(begin)));
}

/// A navigator in the place of the robot's own, one navigation per run.
class NavigatorMethod : public Method {
 public:
  NavigatorMethod(const MethodContext& context, const NavigatorOptions& options)
      : robot_(context.robot, options.obstacle_height),
        factory_(context, options),
        navigator_(factory_.make(robot_)) {
    listen();
    if (!options.record_navlog.empty())
      log_.emplace(options.record_navlog, method_name(context.section));
  }

  void prepare_log(const std::string& where) const {
    try {
      if (log_) log_->prepare();
    } catch (const std::exception& e) {
      throw usage_error(where, reason_of(e), "a folder that can be written");
    }
    if (log_ && with_generators() == nullptr)
      throw usage_error(where, "this navigator keeps no such log",
                        "a navigator with trajectory generators");
  }

  void reset(const Task& task) override {
    robot_.start_run(task.control_period);
    if (!is_used_ || !forget()) renew();
    is_used_ = true;
    if (log_) log_->start_run(task, *with_generators());
    const auto parameters = navigation_to(task);
    navigator_->navigate(&parameters);
  }

  Command step(const Observation& observation) override {
    robot_.observe(observation);
    navigate();
    return robot_.command();
  }

 private:
  CAbstractPTGBasedReactive* with_generators() const {
    return dynamic_cast<CAbstractPTGBasedReactive*>(navigator_.get());
  }

  /// Whether the navigator is as new.
  bool forget() {
    auto* reusable = dynamic_cast<ReusableNavigator*>(navigator_.get());
    if (has_failed_ || reusable == nullptr) return false;
    navigator_->cancel();
    navigator_->navigationStep();  // it notices that it is idle, and begins anew next time
    return reusable->forget_last_run();
  }

  void renew() {
    robot_.restart_timer();
    if (is_used_) navigator_ = factory_.make(robot_);
    listen();
    has_failed_ = false;
  }

  /// MRPT's navigators catch their own exceptions and only log them.
  void listen() {
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
    tell_failure();
  }

  /// A navigator that gives up its target stands still, which is for the judge to see. One that
  /// broke down is an error.
  void tell_failure() {
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

  SimulatedRobot robot_;
  NavigatorFactory factory_;
  NavigatorPtr navigator_;
  std::optional<NavigationLog> log_;
  std::string failure_;  ///< what the navigator logged of an exception
  bool is_used_ = false;
  bool has_failed_ = false;
};

}  // namespace

void NavigatorOptions::visit(OptionVisitor& v) {
  std::string adapter = "mrpt_navigator";
  v.option("adapter", adapter, "the adapter that this method comes in by", {"mrpt_navigator"});
  v.option("class", class_name,
           "CReactiveNavigationSystem (default), CReactiveNavigationSystem3D, or for the plug-in");
  v.option("config", config, "the navigator's own MRPT .ini");
  v.option("plugin", plugin, "library with a navigator of one's own");
  v.option("modules", modules, "MRPT plug-in modules to load first, separated by commas");
  v.option("robot", robot, "whose shape and limits the navigator is told", {"campaign", "config"});
  v.option("margin", margin, "m", "by which the campaign's shape is enlarged", Range::at_least(0));
  v.option("obstacle_height", obstacle_height, "m", "at which the navigator is told obstacles");
  v.option("config_set", config_set, "SECTION.KEY=VALUE; ... in place of what the file says");
  v.option("obstacle_filter", obstacle_filter, "point-cloud filter", {"config", "on", "off"});
  v.option("ptg_cache", ptg_cache, "folder that keeps collision grids; none: a temporary one");
  v.option("record_navlog", record_navlog, "folder for a .reactivenavlog of each run");
}

std::unique_ptr<Method> make_navigator_method(const MethodContext& context) {
  const auto options = read_options<NavigatorOptions>(context.ini, context.section);
  auto method = std::make_unique<NavigatorMethod>(context, options);
  method->prepare_log(context.ini.where(context.section, "record_navlog"));
  return method;
}

}  // namespace slalom
