// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/library/library_method.h>
#include <slalom/library/shared_library.h>
#include <slalom/methods/c_types.h>
#include <slalom/methods/registry.h>

#include <vector>

namespace slalom {
namespace {

constexpr char kSymbol[] = "slalom_method_get_api";
constexpr char kTracksSymbol[] = "slalom_method_get_tracks_api";
constexpr char kMapSymbol[] = "slalom_method_get_map_api";
constexpr char kGoalHeadingSymbol[] = "slalom_method_get_goal_heading_api";
constexpr char kSpaceSymbol[] = "slalom_method_get_space_api";
constexpr char kParametersSymbol[] = "slalom_method_get_parameters_api";

/// The functions that a library exports; null for those that it does not.
struct LibraryApi {
  const slalom_method_api* method;
  const slalom_tracks_api* tracks;
  const slalom_map_api* map;
  const slalom_goal_heading_api* goal_heading;
  const slalom_space_api* space;
  const slalom_parameters_api* parameters;
};

/// The expected names in place of a parameter that the method does not declare; empty for others.
std::string expected_parameter(const slalom_method_api& api, const std::string& key) {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < api.parameter_count; ++i) known.emplace_back(api.parameters[i].key);
  if (contains(known, key)) return "";
  return expected_name(key, known, known.empty() ? "no keys except adapter and plugin" : "");
}

/// A method called through the C function table; keeps the library loaded.
class LibraryMethod : public Method {
 public:
  LibraryMethod(std::unique_ptr<SharedLibrary> library, const LibraryApi& api, void* method)
      : library_(std::move(library)),
        api_(*api.method),
        tracks_api_(api.tracks),
        map_api_(api.map),
        goal_heading_api_(api.goal_heading),
        space_api_(api.space),
        parameters_api_(api.parameters),
        method_(method) {}
  ~LibraryMethod() override { api_.destroy(method_); }
  LibraryMethod(const LibraryMethod&) = delete;
  LibraryMethod& operator=(const LibraryMethod&) = delete;

  bool uses_tracks() const override { return tracks_api_ != nullptr; }
  bool uses_map() const override { return map_api_ != nullptr && map_api_->uses_map(method_) != 0; }

  std::vector<TunableParameter> tunable_parameters() const override {
    std::vector<TunableParameter> tunable;
    for (std::size_t i = 0; space_api_ != nullptr && i < space_api_->range_count; ++i) {
      const slalom_range& range = space_api_->ranges[i];
      tunable.push_back({range.key, default_of(range.key), range.low, range.high,
                         range.logarithmic != 0, range.integer != 0});
    }
    return tunable;
  }

  void reset(const NavigationTask& task) override {
    const slalom_task t = to_c(task);
    check_result("reset", api_.reset(method_, &t));
    if (goal_heading_api_ != nullptr && task.goal_heading)
      check_result("set_goal_heading",
                   goal_heading_api_->set_goal_heading(method_, *task.goal_heading,
                                                       task.goal_heading_tolerance));
    if (!uses_map()) return;
    const slalom_map map = to_c(map_of(task));
    check_result("set_map", map_api_->set_map(method_, &map));
  }

  Command step(const Observation& observation) override {
    const slalom_observation o = to_c(observation, ranges_);
    if (tracks_api_ != nullptr) {
      const std::vector<slalom_track> tracks = to_c(tracks_of(observation));
      check_result("set_tracks", tracks_api_->set_tracks(method_, tracks.data(), tracks.size()));
    }
    slalom_command command = {};
    check_result("step", api_.step(method_, &o, &command));
    return {command.v, command.w, command.vy};
  }

  void set_parameter(const std::string& name, const std::string& value) override {
    if (parameters_api_ == nullptr) return Method::set_parameter(name, value);
    if (const std::string expected = expected_parameter(api_, name); !expected.empty())
      throw MethodError("unknown parameter of " + std::string(api_.name) + ": '" + name +
                        "'; expected " + expected);
    if (parameters_api_->set_parameter(method_, name.c_str(), value.c_str()) != 0)
      throw MethodError(std::string(api_.name) + " does not take " + name + " = " + value +
                        " during a run");
  }

 private:
  double default_of(const std::string& key) const {
    for (std::size_t i = 0; i < api_.parameter_count; ++i) {
      double value = 0;
      if (api_.parameters[i].key == key && parse_number(api_.parameters[i].default_value, value))
        return value;
    }
    throw usage_error(std::string(api_.name) + " " + key,
                      "has a range for tuning, but no numeric default",
                      "a parameter of the method");
  }

  void check_result(const std::string& call, int code) const {
    if (code != 0)
      throw MethodError(std::string(api_.name) + ": " + call + " returned error " +
                        std::to_string(code));
  }

  std::unique_ptr<SharedLibrary> library_;
  const slalom_method_api& api_;
  const slalom_tracks_api* tracks_api_;
  const slalom_map_api* map_api_;
  const slalom_goal_heading_api* goal_heading_api_;
  const slalom_space_api* space_api_;
  const slalom_parameters_api* parameters_api_;
  void* method_;
  std::vector<float> ranges_;
};

/// Loads the library of a method; each step has its own error message.
class LibraryLoader {
 public:
  LibraryLoader(const LibraryOptions& options, const OptionLocation& where)
      : options_(options), where_(where), where_plugin_(where("plugin")) {}

  std::unique_ptr<Method> load(const RobotModel& robot, const SensorModel& sensor) {
    if (options_.plugin.empty())
      throw usage_error(where_(""), "missing library", "plugin = PATH of a shared library");
    path_ = resolve_plugin_path(options_.plugin, options_.folder, where_plugin_);
    std::string error;
    std::unique_ptr<SharedLibrary> library = load_shared_library(path_, error);
    if (!library)
      throw usage_error(where_plugin_, path_ + " cannot be loaded (" + error + ")",
                        "a shared library");
    const LibraryApi api = {&find_api(*library),      find_tracks_api(*library),
                            find_map_api(*library),   find_goal_heading_api(*library),
                            find_space_api(*library), find_parameters_api(*library)};
    void* method = create(*api.method, robot, sensor);
    return std::make_unique<LibraryMethod>(std::move(library), api, method);
  }

 private:
  const slalom_method_api& find_api(const SharedLibrary& library) const {
    using GetApi = const slalom_method_api* (*)();
    const auto get_api = reinterpret_cast<GetApi>(library.find(kSymbol));
    if (get_api == nullptr)
      throw usage_error(where_plugin_, path_ + " does not export " + kSymbol + "()",
                        "a library with that function, marked SLALOM_METHOD_EXPORT against hidden "
                        "visibility");
    const slalom_method_api* api = get_api();
    if (api == nullptr) throw usage_error(where_plugin_, path_ + " returned a null function table");
    if (api->abi_version != SLALOM_METHOD_ABI_VERSION)
      throw usage_error(
          where_plugin_,
          path_ + " was built for version " + std::to_string(api->abi_version) +
              " of the method prototype",
          "version " + std::to_string(SLALOM_METHOD_ABI_VERSION) + " (rebuild the library)");
    const bool complete = api->create != nullptr && api->reset != nullptr && api->step != nullptr &&
                          api->destroy != nullptr && api->name != nullptr &&
                          (api->parameter_count == 0 || api->parameters != nullptr);
    if (!complete)
      throw usage_error(where_plugin_, path_ + " has null entries in its function table",
                        "create, reset, step, destroy and name");
    return *api;
  }

  /// Null for a library that does not export them.
  const slalom_tracks_api* find_tracks_api(const SharedLibrary& library) const {
    return find_optional<slalom_tracks_api>(
        library, kTracksSymbol, SLALOM_TRACKS_ABI_VERSION, "set_tracks",
        [](const slalom_tracks_api& api) { return api.set_tracks != nullptr; });
  }
  const slalom_map_api* find_map_api(const SharedLibrary& library) const {
    return find_optional<slalom_map_api>(library, kMapSymbol, SLALOM_MAP_ABI_VERSION,
                                         "uses_map and set_map", [](const slalom_map_api& api) {
                                           return api.uses_map != nullptr && api.set_map != nullptr;
                                         });
  }

  const slalom_goal_heading_api* find_goal_heading_api(const SharedLibrary& library) const {
    return find_optional<slalom_goal_heading_api>(
        library, kGoalHeadingSymbol, SLALOM_GOAL_HEADING_ABI_VERSION, "set_goal_heading",
        [](const slalom_goal_heading_api& api) { return api.set_goal_heading != nullptr; });
  }

  const slalom_space_api* find_space_api(const SharedLibrary& library) const {
    return find_optional<slalom_space_api>(library, kSpaceSymbol, SLALOM_SPACE_ABI_VERSION,
                                           "ranges with keys", [](const slalom_space_api& api) {
                                             for (std::size_t i = 0;
                                                  api.ranges != nullptr && i < api.range_count; ++i)
                                               if (api.ranges[i].key == nullptr) return false;
                                             return api.ranges != nullptr || api.range_count == 0;
                                           });
  }

  const slalom_parameters_api* find_parameters_api(const SharedLibrary& library) const {
    return find_optional<slalom_parameters_api>(
        library, kParametersSymbol, SLALOM_PARAMETERS_ABI_VERSION, "set_parameter",
        [](const slalom_parameters_api& api) { return api.set_parameter != nullptr; });
  }

  template <typename Api, typename IsComplete>
  const Api* find_optional(const SharedLibrary& library, const char* symbol, unsigned version,
                           const std::string& entries, IsComplete is_complete) const {
    const auto get_api = reinterpret_cast<const Api* (*)()>(library.find(symbol));
    if (get_api == nullptr) return nullptr;
    const Api* api = get_api();
    if (api == nullptr || api->abi_version != version || !is_complete(*api))
      throw usage_error(where_plugin_, path_ + " returned an invalid table of " + symbol + "()",
                        "version " + std::to_string(version) + " with " + entries);
    return api;
  }

  /// Throws for a parameter that the method does not declare.
  void check_parameters(const slalom_method_api& api) const {
    for (const auto& parameter : options_.parameters)
      if (const std::string expected = expected_parameter(api, parameter.first); !expected.empty())
        throw usage_error(where_(parameter.first), "unknown parameter of " + std::string(api.name),
                          expected);
  }

  void* create(const slalom_method_api& api, const RobotModel& robot_model,
               const SensorModel& sensor) const {
    check_parameters(api);
    std::vector<slalom_setting> settings;
    for (const auto& [key, value] : options_.parameters)
      settings.push_back({key.c_str(), value.c_str()});
    std::vector<double> corners;
    const slalom_robot robot = to_c(robot_model, sensor, corners);
    char error[512] = "";
    void* method = api.create(settings.data(), settings.size(), &robot, error, sizeof error);
    error[sizeof error - 1] = '\0';
    if (method == nullptr)
      throw usage_error(where_(""), std::string(api.name) + " cannot be created: " +
                                        (error[0] == '\0' ? "no reason given" : error));
    return method;
  }

  const LibraryOptions& options_;
  const OptionLocation& where_;
  std::string where_plugin_, path_;
};

MethodFactory make_factory(const LibraryOptions& options, const OptionLocation& where) {
  return [options, where](const RobotModel& robot, const SensorModel& sensor) {
    return LibraryLoader(options, where).load(robot, sensor);
  };
}

}  // namespace

void LibraryOptions::visit(OptionVisitor& v) {
  v.option("plugin", plugin, External::Library,
           "shared library with the prototype of slalom_method.h");
}

MethodFactory plugin(const LibraryOptions& options) {
  return make_factory(options, location_of("plugin"));
}

MethodFactory plugin(const std::string& library,
                     const std::vector<std::pair<std::string, std::string>>& parameters) {
  return plugin(LibraryOptions{library, "", parameters});
}

MethodFactory read_library_method(const IniFile& ini, const std::string& section) {
  return make_factory(read_parameter_options<LibraryOptions>(ini, section),
                      location_in(ini, section));
}

}  // namespace slalom
