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

std::vector<std::pair<std::string, std::string>> method_parameters(
    const IniFile& ini, const std::string& section, const std::vector<std::string>& adapter_keys) {
  std::vector<std::pair<std::string, std::string>> parameters;
  for (const std::string& key : ini.keys(section))
    if (!contains(adapter_keys, key)) parameters.emplace_back(key, *ini.get(section, key));
  return parameters;
}

void MethodRegistry::add(const std::string& adapter, MethodReader reader) {
  readers_[adapter] = std::move(reader);
}

std::vector<std::string> MethodRegistry::adapters() const {
  std::vector<std::string> names;
  for (const auto& [name, reader] : readers_) names.push_back(name);
  return names;
}

NamedMethod MethodRegistry::read(const IniFile& ini, const std::string& name) const {
  const std::string section = "method." + name;
  if (!ini.has_section(section))
    throw usage_error(ini.name(), "no section for method '" + name + "'", "[" + section + "]");
  const auto adapter = ini.get(section, "adapter");
  if (!adapter)
    throw usage_error(ini.where(section), "missing adapter",
                      "adapter = " + join(adapters(), " | "));
  const auto found = readers_.find(*adapter);
  if (found == readers_.end())
    throw usage_error(ini.where(section, "adapter"), "unknown adapter '" + *adapter + "'",
                      "one of " + join(adapters(), ", "));
  return {name, found->second(ini, section), ini.where(section)};
}

bool is_valid_command(const Command& command, const RobotModel& robot, std::string& reason) {
  const double low_v = robot.forward_only ? 0.0 : -robot.max_v;
  if (!std::isfinite(command.v) || !std::isfinite(command.w) || !std::isfinite(command.vy)) {
    reason = "v, w or vy is not a finite number";
  } else if (!is_within(command.v, low_v, robot.max_v)) {
    reason = out_of_limits("v", command.v, low_v, robot.max_v);
  } else if (!is_within(command.w, -robot.max_w, robot.max_w)) {
    reason = out_of_limits("w", command.w, -robot.max_w, robot.max_w);
  } else if (!robot.holonomic() && command.vy != 0) {
    reason = "vy = " + format_number(command.vy) + " of a differential drive is not 0";
  } else if (!is_within(std::hypot(command.v, command.vy), 0, robot.max_v)) {
    reason = out_of_limits("speed", std::hypot(command.v, command.vy), 0, robot.max_v);
  } else {
    return true;
  }
  return false;
}

}  // namespace slalom
