// SPDX-License-Identifier: BSD-3-Clause
#include "calls.h"
#include "own_methods.h"

#include <slalom/app/adapters.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/methods/barrier_filter.h>
#include <slalom/methods/c_types.h>

#include <limits>
#include <map>
#include <memory>
#include <vector>

namespace slalom {
namespace {

class OwnMethod : public Method {
 public:
  OwnMethod(const slalom_own_methods& own, std::uint64_t method, const nlohmann::json& description)
      : own_(own),
        method_(method),
        uses_tracks_(description.at("uses_tracks")),
        uses_map_(description.at("uses_map")) {
    for (const nlohmann::json& one : description.at("tunable"))
      tunable_.push_back({one.at("name"), one.at("default"), one.at("low"), one.at("high"),
                          one.at("log"), one.at("integer")});
  }
  ~OwnMethod() override { own_.destroy(method_); }
  OwnMethod(const OwnMethod&) = delete;
  OwnMethod& operator=(const OwnMethod&) = delete;

  bool uses_tracks() const override { return uses_tracks_; }
  bool uses_map() const override { return uses_map_; }
  std::vector<TunableParameter> tunable_parameters() const override { return tunable_; }

  void reset(const NavigationTask& task) override {
    const slalom_task converted = to_c(task);
    const double heading[] = {task.goal_heading.value_or(0), task.goal_heading_tolerance};
    const slalom_map map = uses_map_ ? to_c(map_of(task)) : slalom_map{};
    check(own_.reset(method_, &converted, task.goal_heading ? heading : nullptr,
                     uses_map_ ? &map : nullptr));
  }

  Command step(const Observation& observation) override {
    observation_ = to_c(observation, ranges_);
    const auto tracks = tracks_for(observation);
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    command_ = {kNone, kNone, 0};
    check(own_.step(method_, &observation_, tracks.data(), tracks.size(), &command_));
    return {command_.v, command_.w, command_.vy};
  }

  bool adapts() const override { return own_.adapt != nullptr; }
  std::map<std::string, std::string> adapt(const Observation& observation) override {
    observation_ = to_c(observation, ranges_);
    const auto tracks = tracks_for(observation);
    check(own_.adapt(method_, &observation_, tracks.data(), tracks.size()));
    try {
      return nlohmann::json::parse(take_reply());
    } catch (const nlohmann::json::exception& error) {
      throw MethodError(std::string("adapt() gave no object of texts (") + error.what() + ")");
    }
  }
  void set_parameter(const std::string& name, const std::string& value) override {
    if (own_.set_parameter == nullptr) return Method::set_parameter(name, value);
    check(own_.set_parameter(method_, name.c_str(), value.c_str()));
  }

  void finish(const std::string& outcome) override { check(own_.finish(method_, outcome.c_str())); }

 private:
  std::vector<slalom_track> tracks_for(const Observation& observation) const {
    return uses_tracks_ ? to_c(tracks_of(observation)) : std::vector<slalom_track>();
  }

  static void check(int failed) {
    if (failed != 0) throw MethodError(take_reply());
  }

  slalom_own_methods own_;
  std::uint64_t method_;
  bool uses_tracks_, uses_map_;
  std::vector<TunableParameter> tunable_;
  slalom_observation observation_ = {};
  slalom_command command_ = {};
  std::vector<float> ranges_;
};

/// `around` are the names of the methods that are around it: filters, and such as set parameters.
MethodFactory read_method(const nlohmann::json& methods, const nlohmann::json& given,
                          const slalom_own_methods* own, std::vector<std::string> around = {}) {
  const std::string name = given.at("name");
  const std::string where = "method '" + name + "'", section = "method." + name;
  const auto named = [&](const std::string& key, const std::string& other) {
    around.push_back(name);
    for (const nlohmann::json& one : methods)
      if (one.at("name") == other && !contains(around, other))
        return read_method(methods, one, own, around);
    throw usage_error(where, key + " '" + other + "' is not another method", "one of methods");
  };
  const auto within = [&](MethodFactory made, const std::string& inner) {
    return inner.empty() ? made : adaptive_method(std::move(made), named("inner", inner), where);
  };
  if (given.contains("type")) {
    const bool complete = own != nullptr && own->create != nullptr && own->reset != nullptr &&
                          own->step != nullptr && own->finish != nullptr && own->destroy != nullptr;
    if (!complete) throw usage_error(where, "has a type", "all functions of slalom_own_methods");
    return within(own_method(*own, given.at("type"), name, nlohmann::json::object()),
                  given.value("inner", ""));
  }
  const IniFile ini = to_ini({{section, given.at("keys")}});
  if (ini.get(section, "filter"))
    return read_barrier_filter(ini, section, named("base", ini.get(section, "base").value_or("")));
  return all_adapters().read(ini, name).make;
}

}  // namespace

MethodFactory own_method(const slalom_own_methods& own, std::uint64_t type, const std::string& name,
                         const nlohmann::json& options) {
  return [own, type, name, options = options.dump()](const RobotModel& robot,
                                                     const SensorModel& sensor) {
    const std::string where = "method '" + name + "'";
    std::vector<double> corners;
    const slalom_robot converted = to_c(robot, sensor, corners);
    const std::uint64_t method = own.create(type, options.c_str(), &converted);
    const std::string said = take_reply();
    if (method == 0) throw usage_error(where, said);
    try {
      return std::unique_ptr<Method>(
          std::make_unique<OwnMethod>(own, method, nlohmann::json::parse(said)));
    } catch (const nlohmann::json::exception&) {
      own.destroy(method);
      throw usage_error(where, "is described by '" + said + "'", "see slalom_own_methods");
    }
  };
}

Methods read_methods(const nlohmann::json& given, const slalom_own_methods* own) {
  Methods methods;
  for (const nlohmann::json& one : given) methods.add(one.at("name"), read_method(given, one, own));
  return methods;
}

}  // namespace slalom
