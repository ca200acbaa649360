#include "shared_library.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/library/library_method.h>
#include <slalom/methods/slalom_method.h>

#include <algorithm>
#include <vector>

namespace slalom {
namespace {

constexpr char kSymbol[] = "slalom_method_get_api";

/// The robot in C; its footprint's numbers stay in `corners`.
slalom_robot to_c(const RobotModel& robot, const SensorModel& sensor,
                  std::vector<double>& corners) {
  corners.clear();
  const Footprint footprint = robot.shape();
  for (const auto& corner : footprint.corners()) {
    corners.push_back(corner.x);
    corners.push_back(corner.y);
  }
  slalom_robot result = {};
  result.holonomic = robot.holonomic() ? 1 : 0;
  result.footprint = corners.empty() ? nullptr : corners.data();
  result.footprint_points = corners.size() / 2;
  result.radius = robot.radius;
  result.max_v = robot.max_v;
  result.max_w = robot.max_w;
  result.max_accel_v = robot.max_accel_v;
  result.max_accel_w = robot.max_accel_w;
  result.forward_only = robot.forward_only ? 1 : 0;
  result.rays = sensor.rays;
  result.aperture = sensor.aperture();
  result.max_range = sensor.max_range;
  return result;
}

/// What could have been meant by a key that a method does not know.
std::string expected_instead(const std::string& key, const std::vector<std::string>& known) {
  if (known.empty()) return "no key but adapter and plugin";
  const std::string nearest = nearest_name(key, known);
  return nearest.empty() ? "one of " + join(known, ", ") : "'" + nearest + "'";
}

/// A method behind the C table; the library stays loaded as long as the method lives.
class LibraryMethod : public Method {
 public:
  LibraryMethod(std::unique_ptr<SharedLibrary> library, const slalom_method_api& api, void* method)
      : library_(std::move(library)), api_(api), method_(method) {}
  ~LibraryMethod() override { api_.destroy(method_); }
  LibraryMethod(const LibraryMethod&) = delete;
  LibraryMethod& operator=(const LibraryMethod&) = delete;

  void reset(const Task& task) override {
    slalom_task t = {};
    t.start_x = task.start.x;
    t.start_y = task.start.y;
    t.start_phi = task.start.phi;
    t.goal_x = task.goal.x;
    t.goal_y = task.goal.y;
    t.goal_tolerance = task.goal_tolerance;
    t.control_period = task.control_period;
    t.seed = task.seed;
    expect_success("reset", api_.reset(method_, &t));
  }

  Command step(const Observation& observation) override {
    const auto& scan = *observation.scan;
    ranges_.resize(scan.getScanSize());
    for (std::size_t i = 0; i < ranges_.size(); ++i) ranges_[i] = scan.getScanRange(i);
    slalom_observation o = {};
    o.time = observation.time;
    o.x = observation.odometry.x;
    o.y = observation.odometry.y;
    o.phi = observation.odometry.phi;
    o.v = observation.v;
    o.vy = observation.vy;
    o.w = observation.w;
    o.goal_x = observation.goal_in_robot.x;
    o.goal_y = observation.goal_in_robot.y;
    o.ranges = ranges_.data();
    o.rays = ranges_.size();
    slalom_command command = {};
    expect_success("step", api_.step(method_, &o, &command));
    return {command.v, command.w, command.vy};
  }

 private:
  void expect_success(const std::string& call, int code) const {
    if (code != 0)
      throw MethodError(std::string(api_.name) + ": " + call + " returned error " +
                        std::to_string(code));
  }

  std::unique_ptr<SharedLibrary> library_;
  const slalom_method_api& api_;
  void* method_;
  std::vector<float> ranges_;
};

/// Loads the library of a section step by step, each with its own explanation when it fails.
class LibraryLoader {
 public:
  explicit LibraryLoader(const MethodContext& context)
      : context_(context), where_(context.ini.where(context.section, "plugin")) {}

  std::unique_ptr<Method> load() {
    LibraryOptions options;
    OptionReader reader(context_.ini, context_.section);
    options.visit(reader);
    if (options.plugin.empty())
      throw usage_error(context_.ini.where(context_.section), "no library named",
                        "plugin = PATH of a shared library");
    path_ = resolve_plugin_path(context_.ini, context_.section, options.plugin);
    std::string error;
    std::unique_ptr<SharedLibrary> library = load_shared_library(path_, error);
    if (!library)
      throw usage_error(where_, path_ + " cannot be loaded (" + error + ")", "a shared library");
    const slalom_method_api& api = find_api(*library);
    void* method = create(api);
    return std::make_unique<LibraryMethod>(std::move(library), api, method);
  }

 private:
  const slalom_method_api& find_api(const SharedLibrary& library) const {
    using GetApi = const slalom_method_api* (*)();
    const auto get_api = reinterpret_cast<GetApi>(library.find(kSymbol));
    if (get_api == nullptr)
      throw usage_error(where_, path_ + " does not export " + kSymbol + "()",
                        "a library with that function, marked SLALOM_METHOD_EXPORT so that hidden "
                        "visibility does not hide it");
    const slalom_method_api* api = get_api();
    if (api == nullptr) throw usage_error(where_, path_ + " returned no table of functions");
    if (api->abi_version != SLALOM_METHOD_ABI_VERSION)
      throw usage_error(
          where_,
          path_ + " is made for version " + std::to_string(api->abi_version) +
              " of the method prototype",
          "version " + std::to_string(SLALOM_METHOD_ABI_VERSION) + ": build it again");
    const bool whole = api->create != nullptr && api->reset != nullptr && api->step != nullptr &&
                       api->destroy != nullptr && api->name != nullptr &&
                       (api->parameter_count == 0 || api->parameters != nullptr);
    if (!whole)
      throw usage_error(where_, path_ + " leaves entries of its table of functions empty",
                        "create, reset, step, destroy and name");
    return *api;
  }

  /// The keys of the section that are the method's own, checked against those that it declares.
  std::vector<std::pair<std::string, std::string>> own_settings(
      const slalom_method_api& api) const {
    std::vector<std::string> known;
    for (std::size_t i = 0; i < api.parameter_count; ++i) known.emplace_back(api.parameters[i].key);
    std::vector<std::pair<std::string, std::string>> settings;
    for (const std::string& key : context_.ini.keys(context_.section)) {
      if (key == "adapter" || key == "plugin") continue;
      if (std::find(known.begin(), known.end(), key) == known.end()) {
        throw usage_error(context_.ini.where(context_.section, key),
                          std::string(api.name) + " has no such parameter",
                          expected_instead(key, known));
      }
      settings.emplace_back(key, *context_.ini.get(context_.section, key));
    }
    return settings;
  }

  void* create(const slalom_method_api& api) const {
    const auto own = own_settings(api);
    std::vector<slalom_setting> settings;
    for (const auto& [key, value] : own) settings.push_back({key.c_str(), value.c_str()});
    std::vector<double> corners;
    const slalom_robot robot = to_c(context_.robot, context_.sensor, corners);
    char error[512] = "";
    void* method = api.create(settings.data(), settings.size(), &robot, error, sizeof error);
    error[sizeof error - 1] = '\0';
    if (method == nullptr)
      throw usage_error(
          context_.ini.where(context_.section),
          std::string(api.name) + " refuses: " + (error[0] == '\0' ? "no reason given" : error));
    return method;
  }

  const MethodContext& context_;
  std::string where_, path_;
};

}  // namespace

void LibraryOptions::visit(OptionVisitor& v) {
  std::string adapter = "library";
  v.option("adapter", adapter, "the adapter that this method comes in by", {"library"});
  v.option("plugin", plugin, "shared library with the prototype of slalom_method.h");
}

std::unique_ptr<Method> make_library_method(const MethodContext& context) {
  return LibraryLoader(context).load();
}

}  // namespace slalom
