// SPDX-License-Identifier: BSD-3-Clause
#include "full_eval.h"
#include "navigator_config.h"
#include "noted_config.h"
#include "plugin_module.h"
#include "sectors.h"

#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/text.h>
#include <slalom/methods/goal_turn.h>
#include <slalom/methods/registry.h>
#include <slalom/mrpt_nav/holonomic_method.h>

#include <mrpt/nav/holonomic/CAbstractHolonomicReactiveMethod.h>
#include <mrpt/nav/holonomic/ClearanceDiagram.h>
#include <mrpt/nav/registerAllClasses.h>
#include <mrpt/rtti/CObject.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace slalom {
namespace {

using mrpt::nav::CAbstractHolonomicReactiveMethod;

std::vector<std::string> known_classes() {
  std::vector<std::string> names;
  for (const auto* id : mrpt::rtti::getAllRegisteredClassesChildrenOf(
           CLASS_ID_NAMESPACE(CAbstractHolonomicReactiveMethod, mrpt::nav)))
    names.emplace_back(id->className);
  std::sort(names.begin(), names.end());
  return names;
}

void load_plugin(const std::string& path, const OptionLocation& where) {
  std::string error;
  if (path.empty() || load_plugin_module(path, error) != nullptr) return;
  throw usage_error(where("plugin"), "cannot be loaded (" + error + ")", "an MRPT plug-in module");
}

CAbstractHolonomicReactiveMethod::Ptr create_by_name(const std::string& name) {
  const bool qualified = name.find("::") != std::string::npos;
  return CAbstractHolonomicReactiveMethod::Factory(qualified ? name : "mrpt::nav::" + name);
}

/// The .ini of the class, else what the object, which may be null, writes.
mrpt::config::CConfigFileMemory base_config(const HolonomicOptions& options,
                                            const CAbstractHolonomicReactiveMethod* object) {
  if (!options.config.empty()) return read_navigator_config(options.config);
  mrpt::config::CConfigFileMemory config;
  if (object != nullptr) object->saveConfigFile(config);
  // Names are padded until the text is read.
  return {config.getContent()};
}

/// The same with the overrides.
mrpt::config::CConfigFileMemory class_config(const HolonomicOptions& options,
                                             const CAbstractHolonomicReactiveMethod* object,
                                             const std::string& where) {
  mrpt::config::CConfigFileMemory config = base_config(options, object);
  override_config(config, options.config_set, where);
  return config;
}

/// Loads the .ini of the class once, to report a missing file or key before any run.
void check_config(const HolonomicOptions& options, const OptionLocation& where) {
  if (options.config.empty() && options.config_set.empty()) return;
  std::optional<NotedConfig> config;
  try {
    const auto object = create_by_name(options.class_name);
    config.emplace(class_config(options, object.get(), where("config_set")));
    object->initialize(*config);
  } catch (const Error& e) {
    if (e.kind() == ErrorKind::Usage) throw;
    throw usage_error(where("config"), e.what());
  } catch (const std::exception& e) {
    const std::string at = config ? config->last_read() : "";
    throw usage_error(where("config"),
                      options.class_name + " rejects it (" + at + reason_of(e) + ")",
                      "an MRPT .ini with the section of the class");
  }
  require_overrides(*config, options.config_set, where("config_set"));
}

/// Clearance of a sector: the mean free distance of the sector and its two neighbors. The maps of
/// MRPT's diagram are made once, for all steps.
class SectorClearances {
 public:
  explicit SectorClearances(std::size_t sectors) {
    diagram_.resize(sectors, sectors);
    for (std::size_t k = 0; k < sectors; ++k) {
      auto& of_sector = diagram_.get_path_clearance(k);
      for (const double fraction : {0.25, 0.5, 0.75, 1.0}) values_.push_back(&of_sector[fraction]);
    }
  }

  const mrpt::nav::ClearanceDiagram& of(const std::vector<double>& distances) {
    const std::size_t count = distances.size(), per_sector = values_.size() / count;
    for (std::size_t k = 0; k < count; ++k) {
      const double mean =
          (distances[(k + count - 1) % count] + distances[k] + distances[(k + 1) % count]) / 3;
      for (std::size_t i = 0; i < per_sector; ++i)
        *values_[k * per_sector + i] = std::min(mean, 1.0);
    }
    return diagram_;
  }

 private:
  mrpt::nav::ClearanceDiagram diagram_;
  std::vector<double*> values_;  ///< in the maps of the diagram, sector by sector
};

/// An MRPT holonomic method that is used as a complete navigator.
class HolonomicMethod : public Method {
 public:
  HolonomicMethod(HolonomicOptions options, RobotModel robot, const SensorModel& sensor)
      : options_(std::move(options)),
        sectors_(static_cast<std::size_t>(options_.sectors)),
        robot_(std::move(robot)),
        aperture_(sensor.aperture()),
        clearance_(static_cast<std::size_t>(options_.sectors)) {}

  /// MRPT's methods store their last decision, so each run uses a new object.
  void reset(const NavigationTask& task) override {
    task_ = task;
    control_period_ = task.control_period;
    method_ = create_by_name(options_.class_name);
    if (!method_) throw MethodError("class " + options_.class_name + " cannot be created");
    configure();
    paths_ = complete_full_eval(*method_, static_cast<std::size_t>(options_.sectors));
    // Classes take meters, and the unit of lengths for a meter where no path has another one.
    method_->setTargetApproachSlowDownDistance(method_->getTargetApproachSlowDownDistance() /
                                               options_.reference_distance);
    // CHolonomicVFF always returns speed 0 unless it slows down near the target.
    method_->enableApproachTargetSlowDown(true);
  }

  /// Options of the adapter for all classes; those of the class are in `config`.
  std::vector<TunableParameter> tunable_parameters() const override {
    const HolonomicOptions defaults;
    return {{"sectors", static_cast<double>(defaults.sectors), 61, 241, true, true},
            {"reference_distance", defaults.reference_distance, 1.5, 6, true, false},
            {"margin", defaults.margin, 0, 0.25, false, false},
            {"turn_gain", defaults.turn_gain, 0.5, 6, true, false},
            {"turn_in_place", defaults.turn_in_place, 0.3, 2, false, false},
            {"stop_margin", defaults.stop_margin, 0, 0.2, false, false}};
  }

  /// Options of the adapter that each step reads.
  void set_parameter(const std::string& name, const std::string& value) override {
    static const std::vector<std::string> known = {"margin", "turn_gain", "turn_in_place",
                                                   "stop_margin"};
    if (!contains(known, name))
      throw MethodError("'" + name + "' cannot be set during a run; expected " +
                        expected_name(name, known));
    try {
      for_each_option(options_, [&](const Option& option) {
        if (option.key == name) option.set(value, name);
      });
    } catch (const Error& error) {
      throw MethodError(error.what());
    }
  }

  Command step(const Observation& observation) override {
    if (const auto turn = turn_at_goal(task_, observation, robot_)) return *turn;
    const auto points = obstacle_points(*observation.scan);
    const double radius = robot_.radius + options_.margin;
    CAbstractHolonomicReactiveMethod::NavInput input;
    input.obstacles = sector_distances(points, radius);
    input.maxObstacleDist = 1.0;
    input.maxRobotSpeed = 1.0;
    // Points in MRPT 2.5; poses, made from a point here, since 2.14.3.
    input.targets.emplace_back(target(observation.goal_in_robot));
    input.clearance = &clearance_.of(input.obstacles);
    CAbstractHolonomicReactiveMethod::NavOutput output;
    method_->navigate(input, output);
    return to_command(output.desiredDirection, output.desiredSpeed, observation.v, points);
  }

 private:
  /// Keeps the defaults of the class if there is no .ini, as initialize() requires some keys.
  void configure() {
    if (options_.config.empty() && options_.config_set.empty()) return;
    method_->initialize(class_config(options_, method_.get(), "config_set"));
  }

  /// Free distance of the enlarged disc in each sector, as a fraction of the reference distance.
  std::vector<double> sector_distances(const std::vector<mrpt::math::TPoint2D>& points,
                                       double radius) const {
    const double limit = options_.reference_distance;
    std::vector<double> distances = sectors_.free_distances(points, radius, limit);
    limit_unseen(distances, aperture_, options_.behind, limit);
    for (double& distance : distances) distance /= limit;
    return distances;
  }

  /// The goal in the same units, moved to within the reference distance.
  mrpt::math::TPoint2D target(const mrpt::math::TPoint2D& goal) const {
    constexpr double kMaxTarget = 0.98;
    const double distance = math::hypot(goal.x, goal.y) / options_.reference_distance;
    const double scale = distance > kMaxTarget ? kMaxTarget / distance : 1.0;
    return goal * (scale / options_.reference_distance);
  }

  Command to_command(double direction, double speed, double measured_v,
                     const std::vector<mrpt::math::TPoint2D>& points) const {
    if (!std::isfinite(direction) || !std::isfinite(speed)) return {direction, speed};
    return robot_.holonomic() ? holonomic_command(direction, speed, points)
                              : diff_drive_command(direction, speed, measured_v, points);
  }

  /// Speed from which the disc can stop before contact in that direction, m/s.
  double stopping_speed(double direction, const std::vector<mrpt::math::TPoint2D>& points) const {
    const double distance =
        free_distance(points, direction, robot_.radius, options_.reference_distance);
    return std::sqrt(2 * 0.7 * robot_.max_accel_v * std::max(0.0, distance - options_.stop_margin));
  }

  /// A holonomic robot moves in the given direction and turns towards it or keeps its heading.
  Command holonomic_command(double direction, double speed,
                            const std::vector<mrpt::math::TPoint2D>& points) const {
    const double length =
        std::clamp(std::min(speed, 1.0) * robot_.max_v, 0.0, stopping_speed(direction, points));
    const double v = length * math::cos(direction), vy = length * math::sin(direction);
    const double w =
        options_.turn == Heading::FaceMotion && speed > 0 ? options_.turn_gain * direction : 0;
    return {robot_.forward_only ? std::max(0.0, v) : v, std::clamp(w, -robot_.max_w, robot_.max_w),
            vy};
  }

  /// A differential drive robot turns towards the direction and moves forward. If it is to stop and
  /// cannot within one control period, it does not turn until it can: only the distance straight
  /// ahead was checked for obstacles.
  Command diff_drive_command(double direction, double speed, double measured_v,
                             const std::vector<mrpt::math::TPoint2D>& points) const {
    const double w = std::clamp(options_.turn_gain * direction, -robot_.max_w, robot_.max_w);
    const bool in_place = std::abs(direction) > options_.turn_in_place;
    const double wanted = in_place ? 0 : std::min(1.0, speed) * robot_.max_v * math::cos(direction);
    const double v = std::clamp(std::min(wanted, stopping_speed(0, points)), 0.0, robot_.max_v);
    const bool stops = std::abs(measured_v) <= robot_.max_accel_v * control_period_;
    if (v > 0 || stops) return {v, in_place && speed <= 0 ? 0 : w};
    return {};
  }

  HolonomicOptions options_;
  Sectors sectors_;
  RobotModel robot_;
  double aperture_;
  NavigationTask task_;
  double control_period_ = 0;                                            ///< s
  std::unique_ptr<mrpt::nav::CParameterizedTrajectoryGenerator> paths_;  ///< used by method_
  CAbstractHolonomicReactiveMethod::Ptr method_;
  SectorClearances clearance_;
};

MethodFactory make_factory(const HolonomicOptions& options, const OptionLocation& where) {
  return [options, where](const RobotModel& robot, const SensorModel& sensor) {
    mrpt::nav::registerAllClasses_mrpt_nav();
    load_plugin(options.plugin, where);
    if (!create_by_name(options.class_name))
      throw usage_error(where("class"),
                        "unknown holonomic method class '" + options.class_name + "'",
                        "one of " + join(known_classes(), ", "));
    check_config(options, where);
    return std::make_unique<HolonomicMethod>(options, robot, sensor);
  };
}

}  // namespace

void HolonomicOptions::visit(OptionVisitor& v) {
  v.option("class", class_name, "class derived from CAbstractHolonomicReactiveMethod");
  v.option("plugin", plugin, External::Library, "MRPT plug-in module to load first");
  v.option("config", config, External::File, "MRPT .ini with the section of the class");
  v.option("config_set", config_set, "SECTION.KEY=VALUE; ... overrides of it, or of the defaults");
  v.option("sectors", sectors, "-", "sectors of the full circle", Range::between(8, 2000));
  v.option("reference_distance", reference_distance, "m", "obstacles beyond it are ignored",
           Range::positive());
  v.option("margin", margin, "m", "added to the robot's radius", Range::at_least(0));
  v.option("behind", behind, "sectors outside the scan");
  v.option("turn_gain", turn_gain, "1/s", "w = turn_gain * direction", Range::positive());
  v.option("turn_in_place", turn_in_place, "rad",
           "beyond this direction a diff_drive robot rotates in place", Range::between(0, M_PI));
  v.option("turn", turn, "heading of a holonomic robot: face the direction of motion or keep");
  v.option("stop_margin", stop_margin, "m",
           "v is limited so that the robot can stop this far before contact", Range::at_least(0));
}

MethodFactory mrpt_holonomic(const HolonomicOptions& options) {
  check_options(options, location_of("mrpt_holonomic"));
  return make_factory(options, location_of("mrpt_holonomic"));
}

MethodFactory mrpt_holonomic(const std::string& class_name) {
  HolonomicOptions options;
  options.class_name = class_name;
  return mrpt_holonomic(options);
}

MethodFactory read_holonomic_method(const IniFile& ini, const std::string& section) {
  return make_factory(read_mrpt_options<HolonomicOptions>(ini, section), location_in(ini, section));
}

std::optional<std::string> holonomic_config_value(const IniFile& ini, const std::string& section,
                                                  const std::string& name) {
  const auto options = read_mrpt_options<HolonomicOptions>(ini, section);
  // No code of a plug-in runs in this process.
  mrpt::nav::registerAllClasses_mrpt_nav();
  const auto object = options.plugin.empty() ? create_by_name(options.class_name) : nullptr;
  return value_of_key(base_config(options, object.get()), options.config_set, name,
                      ini.where(section, "config_set"));
}

}  // namespace slalom
