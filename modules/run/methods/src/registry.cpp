// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/methods/barrier_filter.h>
#include <slalom/methods/registry.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

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

void MethodOptions::visit(OptionVisitor& v) {
  v.option("adapter", adapter, "adapter of this method");
  v.option("inner", inner, "NAME of the section of a method whose parameters this one sets");
}

AdapterReader::AdapterReader(const IniFile& ini, const std::string& section)
    : OptionReader(ini, section) {
  MethodOptions().visit(*this);
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
  std::vector<std::string> sections = method_sections(ini, name);
  MethodFactory make = read_section(ini, sections.back());
  for (sections.pop_back(); !sections.empty(); sections.pop_back()) {
    const std::string& section = sections.back();
    make = ini.get(section, "filter") ? read_barrier_filter(ini, section, std::move(make))
                                      : adaptive_method(read_section(ini, section), std::move(make),
                                                        ini.where(section, "inner"));
  }
  return {name, std::move(make), ini.where("method." + name)};
}

MethodFactory MethodRegistry::read_section(const IniFile& ini, const std::string& section) const {
  const auto adapter = ini.get(section, "adapter");
  if (!adapter)
    throw usage_error(ini.where(section), "missing adapter",
                      "adapter = " + join(adapters(), " | "));
  const auto found = readers_.find(*adapter);
  if (found == readers_.end())
    throw usage_error(ini.where(section, "adapter"), "unknown adapter '" + *adapter + "'",
                      "one of " + join(adapters(), ", "));
  return found->second(ini, section);
}

std::vector<std::string> method_sections(const IniFile& ini, const std::string& name) {
  std::vector<std::string> sections;
  std::string method = name, named_at = ini.name();
  while (true) {
    const std::string section = "method." + method;
    if (!ini.has_section(section))
      throw usage_error(named_at, "no section for method '" + method + "'", "[" + section + "]");
    if (contains(sections, section))
      throw usage_error(named_at, "the method '" + method + "' is around itself",
                        "another method, with an adapter");
    sections.push_back(section);
    const bool filters = ini.get(section, "filter").has_value();
    const std::string key = filters ? "base" : "inner";
    const auto next = ini.get(section, key);
    if (!next && !filters) return sections;
    if (!next || next->empty())
      throw usage_error(ini.where(section, filters ? "filter" : "inner"), "missing " + key,
                        key + " = NAME of another section [method.NAME]");
    method = *next;
    named_at = ini.where(section, key);
  }
}

std::vector<std::string> method_sections(const IniFile& ini,
                                         const std::vector<NamedMethod>& methods) {
  std::vector<std::string> sections;
  for (const NamedMethod& method : methods)
    for (std::string& section : method_sections(ini, method.name))
      sections.push_back(std::move(section));
  return sections;
}

std::string resolve_method_file(const std::string& kind, const std::string& file,
                                const std::string& folder, const std::string& where,
                                const std::vector<std::string>& others) {
  namespace fs = std::filesystem;
  std::vector<std::string> folders = {folder, ""}, tried;
  folders.insert(folders.end(), others.begin(), others.end());
  for (const std::string& searched : folders) {
    const fs::path path = fs::absolute(fs::path(searched) / file).lexically_normal();
    std::error_code ignored;
    if (fs::is_regular_file(path, ignored)) return path.string();
    if (fs::exists(path, ignored)) try {
        require_regular_file(path.string(), "a file of a method");
      } catch (const Error& error) {
        throw usage_error(where, error.what());
      }
    if (!contains(tried, path.string())) tried.push_back(path.string());
  }
  throw usage_error(where, kind + " '" + file + "' not found", "a file at " + join(tried, " or "));
}

const KnownMap& map_of(const NavigationTask& task) {
  if (task.map == nullptr)
    throw MethodError("the method needs the map, which this input does not contain");
  return *task.map;
}

const std::vector<Track>& tracks_of(const Observation& observation) {
  if (observation.tracks == nullptr)
    throw MethodError("the method needs the tracks of movers, which this input does not contain");
  return *observation.tracks;
}

Command limited_command(const Command& command, const RobotModel& robot, double& count) {
  Command limited = {std::clamp(command.v, robot.forward_only ? 0 : -robot.max_v, robot.max_v),
                     std::clamp(command.w, -robot.max_w, robot.max_w),
                     robot.holonomic() ? std::clamp(command.vy, -robot.max_v, robot.max_v) : 0};
  if (const double speed = math::hypot(limited.v, limited.vy); speed > robot.max_v) {
    limited.v *= robot.max_v / speed;
    limited.vy *= robot.max_v / speed;
  }
  for (const double change :
       {limited.v - command.v, limited.w - command.w, limited.vy - command.vy})
    if (std::abs(change) > kTolerance) {
      ++count;
      break;
    }
  return limited;
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
  } else if (!is_within(math::hypot(command.v, command.vy), 0, robot.max_v)) {
    reason = out_of_limits("speed", math::hypot(command.v, command.vy), 0, robot.max_v);
  } else {
    return true;
  }
  return false;
}

}  // namespace slalom
