#include "plugin_module.h"
#include "sectors.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/mrpt_nav/holonomic_method.h>

#include <mrpt/config/CConfigFile.h>
#include <mrpt/nav/holonomic/CAbstractHolonomicReactiveMethod.h>
#include <mrpt/nav/holonomic/ClearanceDiagram.h>
#include <mrpt/nav/registerAllClasses.h>
#include <mrpt/rtti/CObject.h>
#include <mrpt/system/filesystem.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::nav::CAbstractHolonomicReactiveMethod;

constexpr double kPi = 3.14159265358979323846;

std::vector<std::string> known_classes() {
  std::vector<std::string> names;
  for (const auto* id : mrpt::rtti::getAllRegisteredClassesChildrenOf(
           CLASS_ID_NAMESPACE(CAbstractHolonomicReactiveMethod, mrpt::nav)))
    names.emplace_back(id->className);
  std::sort(names.begin(), names.end());
  return names;
}

void load_plugin(const MethodContext& context, const std::string& path) {
  std::string error;
  if (path.empty() || load_plugin_module(path, error) != nullptr) return;
  throw usage_error(context.ini.where(context.section, "plugin"),
                    "cannot be loaded (" + error + ")", "an MRPT plug-in module");
}

CAbstractHolonomicReactiveMethod::Ptr create_by_name(const std::string& name) {
  const bool qualified = name.find("::") != std::string::npos;
  return CAbstractHolonomicReactiveMethod::Factory(qualified ? name : "mrpt::nav::" + name);
}

/// Tries the class's own .ini, so that a missing file or key is told before any run.
void check_config(const MethodContext& context, const HolonomicOptions& options) {
  if (options.config.empty()) return;
  const std::string where = context.ini.where(context.section, "config");
  if (!mrpt::system::fileExists(options.config))
    throw usage_error(where, "'" + options.config + "' cannot be read", "an MRPT .ini");
  try {
    create_by_name(options.class_name)->initialize(mrpt::config::CConfigFile(options.config));
  } catch (const std::exception& e) {
    throw usage_error(where, options.class_name + " refuses it (" + reason_of(e) + ")",
                      "an MRPT .ini with the class's own section");
  }
}

/// One MRPT holonomic method in the place of the robot's navigator.
class HolonomicMethod : public Method {
 public:
  HolonomicMethod(HolonomicOptions options, const MethodContext& context)
      : options_(std::move(options)), robot_(context.robot), aperture_(context.sensor.aperture()) {}

  /// MRPT's methods remember their last choice: a run gets a new one.
  void reset(const Task&) override {
    method_ = create_by_name(options_.class_name);
    if (!method_) throw MethodError("class " + options_.class_name + " cannot be made");
    configure();
    // With slow-down near the target off, CHolonomicVFF always answers speed 0.
    method_->enableApproachTargetSlowDown(true);
  }

  Command step(const Observation& observation) override {
    const auto points = obstacle_points(*observation.scan);
    const double radius = robot_.radius + options_.margin;
    CAbstractHolonomicReactiveMethod::NavInput input;
    input.obstacles = sector_distances(points, radius);
    input.maxObstacleDist = 1.0;
    input.maxRobotSpeed = 1.0;
    input.targets.push_back(target(observation.goal_in_robot));
    mrpt::nav::ClearanceDiagram clearance;
    fill_clearance(input.obstacles, clearance);
    input.clearance = &clearance;
    CAbstractHolonomicReactiveMethod::NavOutput output;
    method_->navigate(input, output);
    return to_command(output.desiredDirection, output.desiredSpeed, points);
  }

 private:
  /// Without an .ini the class's own defaults hold: initialize() insists on some keys.
  void configure() {
    if (options_.config.empty()) return;
    const mrpt::config::CConfigFile file(options_.config);
    method_->initialize(file);
  }

  /// Free travel of the enlarged disc in each sector, in parts of the reference distance.
  std::vector<double> sector_distances(const std::vector<mrpt::math::TPoint2D>& points,
                                       double radius) const {
    const auto count = static_cast<std::size_t>(options_.sectors);
    const double limit = options_.reference_distance;
    std::vector<double> distances(count);
    for (std::size_t k = 0; k < count; ++k) {
      const double direction = sector_direction(k, count);
      const bool unseen = std::abs(direction) > 0.5 * aperture_;
      const double unseen_way = options_.behind == "free" ? limit : 0.0;
      const double way = free_travel(points, direction, radius, limit);
      distances[k] = (unseen ? std::min(way, unseen_way) : way) / limit;
    }
    return distances;
  }

  /// The goal in the same units, brought within what the sectors show.
  mrpt::math::TPoint2D target(const mrpt::math::TPoint2D& goal) const {
    constexpr double kFarthest = 0.98;
    const double distance = std::hypot(goal.x, goal.y) / options_.reference_distance;
    const double scale = distance > kFarthest ? kFarthest / distance : 1.0;
    return goal * (scale / options_.reference_distance);
  }

  /// Clearance of a sector: the mean free way of it and its neighbours.
  static void fill_clearance(const std::vector<double>& obstacles,
                             mrpt::nav::ClearanceDiagram& clearance) {
    const std::size_t count = obstacles.size();
    clearance.resize(count, count);
    for (std::size_t k = 0; k < count; ++k) {
      const double mean =
          (obstacles[(k + count - 1) % count] + obstacles[k] + obstacles[(k + 1) % count]) / 3;
      auto& way = clearance.get_path_clearance(k);
      for (const double share : {0.25, 0.5, 0.75, 1.0}) way[share] = std::min(mean, 1.0);
    }
  }

  Command to_command(double direction, double speed,
                     const std::vector<mrpt::math::TPoint2D>& points) const {
    if (!std::isfinite(direction) || !std::isfinite(speed)) return {direction, speed};
    return robot_.holonomic() ? to_any_side(direction, speed, points)
                              : ahead(direction, speed, points);
  }

  /// What can be stopped before the disc would touch something in that direction, m/s.
  double stoppable_speed(double direction, const std::vector<mrpt::math::TPoint2D>& points) const {
    const double way = free_travel(points, direction, robot_.radius, options_.reference_distance);
    return std::sqrt(2 * 0.7 * robot_.max_accel_v * std::max(0.0, way - options_.stop_margin));
  }

  /// A holonomic robot goes where the class says, and turns there meanwhile or not at all.
  Command to_any_side(double direction, double speed,
                      const std::vector<mrpt::math::TPoint2D>& points) const {
    const double length =
        std::clamp(std::min(speed, 1.0) * robot_.max_v, 0.0, stoppable_speed(direction, points));
    const double v = length * std::cos(direction), vy = length * std::sin(direction);
    const double w = options_.turn == "face" && speed > 0 ? options_.turn_gain * direction : 0;
    return {robot_.forward_only ? std::max(0.0, v) : v, std::clamp(w, -robot_.max_w, robot_.max_w),
            vy};
  }

  /// A differential drive turns and drives ahead.
  Command ahead(double direction, double speed,
                const std::vector<mrpt::math::TPoint2D>& points) const {
    const double w = std::clamp(options_.turn_gain * direction, -robot_.max_w, robot_.max_w);
    if (std::abs(direction) > options_.turn_in_place) return {0, speed > 0 ? w : 0};
    const double wanted = std::min(1.0, speed) * robot_.max_v * std::cos(direction);
    return {std::clamp(std::min(wanted, stoppable_speed(0, points)), 0.0, robot_.max_v), w};
  }

  HolonomicOptions options_;
  RobotModel robot_;
  double aperture_;
  CAbstractHolonomicReactiveMethod::Ptr method_;
};

}  // namespace

void HolonomicOptions::visit(OptionVisitor& v) {
  std::string adapter = "mrpt_holonomic";
  v.option("adapter", adapter, "the adapter that this method comes in by", {"mrpt_holonomic"});
  v.option("class", class_name, "class derived from CAbstractHolonomicReactiveMethod");
  v.option("plugin", plugin, "MRPT plug-in module to load first");
  v.option("config", config, "MRPT .ini with the method's own section");
  v.option("sectors", sectors, "-", "sectors of the full circle", Range::between(8, 2000));
  v.option("reference_distance", reference_distance, "m", "what is farther away is free",
           Range::positive());
  v.option("margin", margin, "m", "added to the robot's radius", Range::at_least(0));
  v.option("behind", behind, "what stands where the scan does not look", {"free", "blocked"});
  v.option("turn_gain", turn_gain, "1/s", "w = turn_gain * direction", Range::positive());
  v.option("turn_in_place", turn_in_place, "rad",
           "beyond this direction a diff_drive turns without driving", Range::between(0, kPi));
  v.option("turn", turn, "whether a holonomic robot turns to where it goes", {"face", "keep"});
  v.option("stop_margin", stop_margin, "m",
           "v stays below what could be stopped this far before contact", Range::at_least(0));
}

std::unique_ptr<Method> make_holonomic_method(const MethodContext& context) {
  mrpt::nav::registerAllClasses_mrpt_nav();
  auto options = read_options<HolonomicOptions>(context.ini, context.section);
  load_plugin(context, options.plugin);
  if (!create_by_name(options.class_name)) {
    const std::vector<std::string> classes = known_classes();
    throw usage_error(context.ini.where(context.section, "class"),
                      "no holonomic method class '" + options.class_name + "'",
                      "one of " + join(classes, ", "));
  }
  check_config(context, options);
  return std::make_unique<HolonomicMethod>(std::move(options), context);
}

}  // namespace slalom
