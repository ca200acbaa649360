#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/methods/registry.h>

#include <cmath>

namespace slalom {
namespace {

constexpr double kTolerance = 1e-9;

bool is_within(double value, double low, double high) {
  return value >= low - kTolerance && value <= high + kTolerance;
}

std::string out_of_limits(const std::string& name, double value, double low, double high) {
  return name + " = " + format_number(value) + " is outside [" + format_number(low) + ", " +
         format_number(high) + "]";
}

}  // namespace

void MethodRegistry::add(const std::string& adapter, MethodFactory factory) {
  factories_[adapter] = std::move(factory);
}

std::vector<std::string> MethodRegistry::adapters() const {
  std::vector<std::string> names;
  for (const auto& [name, factory] : factories_) names.push_back(name);
  return names;
}

std::unique_ptr<Method> MethodRegistry::create(const std::string& name,
                                               const MethodContext& context) const {
  const IniFile& ini = context.ini;
  if (!ini.has_section(context.section))
    throw usage_error(ini.name(), "no section for method '" + name + "'",
                      "[" + context.section + "]");
  const auto adapter = ini.get(context.section, "adapter");
  if (!adapter)
    throw usage_error(ini.where(context.section), "no adapter named",
                      "adapter = " + join(adapters(), " | "));
  const auto found = factories_.find(*adapter);
  if (found == factories_.end())
    throw usage_error(ini.where(context.section, "adapter"), "unknown adapter '" + *adapter + "'",
                      "one of " + join(adapters(), ", "));
  return found->second(context);
}

bool is_valid_command(const Command& command, const RobotModel& robot, std::string& why) {
  const double low_v = robot.forward_only ? 0.0 : -robot.max_v;
  if (!std::isfinite(command.v) || !std::isfinite(command.w) || !std::isfinite(command.vy)) {
    why = "v, w or vy is not a finite number";
  } else if (!is_within(command.v, low_v, robot.max_v)) {
    why = out_of_limits("v", command.v, low_v, robot.max_v);
  } else if (!is_within(command.w, -robot.max_w, robot.max_w)) {
    why = out_of_limits("w", command.w, -robot.max_w, robot.max_w);
  } else if (!robot.holonomic() && command.vy != 0) {
    why = "vy = " + format_number(command.vy) + " of a differential drive is not 0";
  } else if (!is_within(std::hypot(command.v, command.vy), 0, robot.max_v)) {
    why = out_of_limits("speed", std::hypot(command.v, command.vy), 0, robot.max_v);
  } else {
    return true;
  }
  return false;
}

}  // namespace slalom
