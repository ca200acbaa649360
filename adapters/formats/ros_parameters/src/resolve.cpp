// SPDX-License-Identifier: BSD-3-Clause
#include "conversions.h"
#include "parameter_files.h"
#include "urdf_file.h"

#include <slalom/core/enum_names.h>
#include <slalom/core/error.h>
#include <slalom/core/options.h>
#include <slalom/core/printable.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/robot/robot_model.h>
#include <slalom/ros_parameters/resolve.h>
#include <slalom/simulation/simulate.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

namespace slalom {
namespace {

using ros::Controller;
using ros::ParameterFiles;

/// The files of `from`, relative to the folder of the .ini or to the current one.
std::vector<std::string> files_of(const IniFile& ini, const std::string& section,
                                  const std::string& from) {
  std::vector<std::string> files;
  for (const std::string& name : split_nonempty(from, ',')) {
    const std::filesystem::path beside = std::filesystem::path(ini.folder()) / name;
    std::error_code ignored;
    files.push_back(std::filesystem::exists(beside, ignored) ? beside.string() : name);
  }
  if (files.empty())
    throw usage_error(ini.where(section, "from"), "names no file", "a .yaml of Nav2 or move_base");
  return files;
}

/// Takes the robots in URDF out of the files.
std::vector<std::string> take_robots(std::vector<std::string>& files) {
  const auto robots = std::stable_partition(files.begin(), files.end(), [](const auto& file) {
    return !ends_with(file, ".urdf") && !ends_with(file, ".xacro");
  });
  std::vector<std::string> taken(robots, files.end());
  files.erase(robots, files.end());
  return taken;
}

std::vector<std::string> names_of(const std::vector<Controller>& controllers) {
  std::vector<std::string> names;
  for (const Controller& controller : controllers) names.push_back(controller.name);
  return names;
}

/// The controller that the section names, else the only one of the files.
std::optional<Controller> choose_controller(const IniFile& ini, const std::string& section,
                                            const std::vector<Controller>& controllers) {
  const std::string name = ini.get(section, "controller").value_or("");
  const std::vector<std::string> names = names_of(controllers);
  if (name.empty()) {
    if (controllers.size() > 1)
      throw usage_error(ini.where(section, "from"), "has several controllers",
                        "controller = " + join(names, " or "));
    return controllers.empty() ? std::nullopt : std::make_optional(controllers.front());
  }
  for (const Controller& controller : controllers)
    if (controller.name == name) return controller;
  throw usage_error(ini.where(section, "controller"), "no controller '" + name + "' in the file",
                    expected_name(name, names, names.empty() ? "a file with controllers" : ""));
}

/// Classes of Nav2 and sections of move_base that are in the table.
std::optional<RosFamily> family_of(const std::string& kind) {
  const std::string short_kind =  // TEB has its class in ROS 2, too
      kind.substr(kind.rfind(':') == std::string::npos ? 0 : kind.rfind(':') + 1);
  for (const std::string& name : {kind, short_kind})
    if (const auto family = from_name<RosFamily>(name); family && *family < RosFamily::LocalCostmap)
      return family;
  return std::nullopt;
}

/// A part of the files whose parameters are of one family.
struct Part {
  RosFamily family;
  std::string name;  ///< precedes the keys in reports
  std::vector<RosParameter> parameters, unused = {};
  std::string why_unused = {};
};

std::vector<std::string> words_of(const RosParameter& list) {
  return list.items ? *list.items : split_nonempty(list.text, ' ');
}

/// Whether the section `name` of `parent` is enabled and, if that lists its sections, listed.
bool is_in_use(const std::vector<RosParameter>& parameters, const std::string& parent,
               const std::string& name) {
  bool has_list = false, is_listed = false;
  for (const RosParameter& p : parameters) {
    if (p.key == parent + name + ".enabled" && contains({"false", "no", "off"}, lower_case(p.text)))
      return false;
    for (const std::string list : {"critics", "plugins", "filters", "observation_sources"}) {
      if (p.key != parent + list) continue;
      const std::vector<std::string> words = words_of(p);
      // move_base has lists of maps, whose items are "".
      is_listed = is_listed || contains(words, name) || contains(words, "");
      const bool lists_sources = list == "observation_sources";
      has_list = has_list || (list != "filters" && !(lists_sources && ends_with(name, "layer")));
    }
  }
  return is_listed || !has_list;
}

/// Whether all sections of a key are in use: critics, layers, sources.
bool is_used(const std::vector<RosParameter>& parameters, const std::string& key) {
  for (std::size_t begin = 0, dot = key.find('.'); dot != std::string::npos;
       begin = dot + 1, dot = key.find('.', begin))
    if (!is_in_use(parameters, key.substr(0, begin), key.substr(begin, dot - begin))) return false;
  return true;
}

/// The number without its last digits, which are those of products of numbers of the file.
std::string decimal(double number) {
  return fmt::format("{:.12g}", number);
}

/// Resolves one section.
class SectionResolver {
 public:
  SectionResolver(IniFile& ini, const std::string& section)
      : ini_(ini), section_(section), kind_(section) {}

  RosParameterReport resolve() {
    const std::string from = ini_.get(section_, "from").value_or("");
    std::vector<std::string> paths = files_of(ini_, section_, from);
    const std::vector<std::string> robots = take_robots(paths);
    if (!robots.empty() && section_ != "robot")
      throw usage_error(ini_.where(section_, "from"), "'" + robots[0] + "' describes a robot",
                        "[robot] from for it, and a .yaml of Nav2 or move_base here");
    const ParameterFiles files = ParameterFiles::load(paths);
    report_.section = section_;
    report_.source = from;
    const bool is_simulation = section_ == "simulation";
    if (is_simulation)
      read_only_controller(files);
    else
      read_controller(files);
    if (!is_simulation) add_part(files, RosFamily::LocalCostmap);
    if (section_ == "robot") add_part(files, RosFamily::VelocitySmoother);
    if (is_method() || is_simulation) {
      add_part(files, RosFamily::ControllerServer);
      add_part(files, RosFamily::MoveBase);
    }
    if (is_method()) set_library();
    remove("from");
    remove("controller");
    for (const std::string& key : ini_.keys(section_)) given_.insert(key);
    convert_all();
    for (const std::string& path : robots) add_robot(ros::UrdfRobot::read(path), path);
    return report_;
  }

 private:
  bool is_method() const { return starts_with(section_, "method."); }
  void remove(const std::string& key) { ini_.remove(section_, key); }

  /// The parameters of a node, without those of the controllers in it.
  void add_part(const ParameterFiles& files, RosFamily family) {
    Part part{family, to_string(family), files.of_node(family)};
    const auto is_of_controller = [&](const RosParameter& parameter) {
      const std::vector<std::string> names = split(parameter.key, '.');
      return names.size() > 1 &&
             (contains(controllers_, names.front()) || ends_with(names.front(), "_costmap"));
    };
    part.parameters.erase(
        std::remove_if(part.parameters.begin(), part.parameters.end(), is_of_controller),
        part.parameters.end());
    if (family == RosFamily::LocalCostmap) set_aside(part, "its layer or source is not in use");
    parts_.push_back(std::move(part));
  }

  /// Robots have the limits of their controller first.
  void read_controller(const ParameterFiles& files) {
    const std::vector<Controller> controllers = files.controllers();
    controllers_ = names_of(controllers);
    const auto controller = choose_controller(ini_, section_, controllers);
    if (!controller) {
      if (is_method())
        throw usage_error(ini_.where(section_, "from"),
                          "lists no controller in controller_plugins, nor has one of a known class",
                          "a section with plugin: CLASS, or DWAPlannerROS and the like");
      return;
    }
    prefix_ = controller->name;
    report_.source += ", " + controller->name;
    if (controller->kind != controller->name) report_.source += " (" + controller->kind + ")";
    std::vector<RosParameter> parameters = files.below(controller->path);
    auto family = family_of(controller->kind);
    if (family == RosFamily::RotationShim) {
      const auto primary =
          std::find_if(parameters.begin(), parameters.end(),
                       [](const RosParameter& p) { return p.key == "primary_controller"; });
      if (primary != parameters.end()) family = family_of(ros::scalar(*primary, "a class"));
      is_shim_ = true;
    }
    if (is_method()) require_method(*controller, family);
    if (!family) return;
    kind_ = is_method() ? method_of(*family) : section_;
    parts_.push_back({*family, controller->name, std::move(parameters)});
    if (family == RosFamily::Dwb) set_aside(parts_.back(), "critics does not list it");
  }

  /// The controllers of move_base have the tolerance of the goal; others need no choice.
  void read_only_controller(const ParameterFiles& files) {
    const std::vector<Controller> controllers = files.controllers();
    controllers_ = names_of(controllers);
    if (controllers.size() > 1 && !ini_.get(section_, "controller")) return;
    const auto controller = choose_controller(ini_, section_, controllers);
    if (!controller) return;
    if (const auto family = family_of(controller->kind))
      parts_.push_back({*family, controller->name, files.below(controller->path)});
  }

  void require_method(const Controller& controller, const std::optional<RosFamily>& family) const {
    if (family && !method_of(*family).empty()) return;
    throw usage_error(controller.where, "no shipped method is a '" + controller.kind + "'",
                      "DWB, regulated pure pursuit, MPPI, DWAPlannerROS, TrajectoryPlannerROS or "
                      "EBandPlannerROS");
  }

  void set_library() {
    const std::string library = "libslalom_" + kind_ + ".so";
    const std::string adapter = ini_.get(section_, "adapter").value_or("library");
    if (adapter != "library")
      throw usage_error(ini_.where(section_, "adapter"), "parameters are of a shipped method",
                        "library, or no key from");
    const auto plugin = ini_.get(section_, "plugin");
    if (plugin && std::filesystem::path(*plugin).filename() != library)
      throw usage_error(ini_.where(section_, "plugin"),
                        "'" + *plugin + "' is not the method of " + report_.source,
                        library + ", or no key plugin; the controller is the key controller");
    const std::string origin = ini_.where(section_, "from") + ": ";
    if (!ini_.get(section_, "adapter")) ini_.set(section_, "adapter", "library", origin);
    if (!plugin) ini_.set(section_, "plugin", library, origin);
  }

  void convert_all() {
    if (is_method())
      control_period_ = read_options<SimulationOptions>(ini_, "simulation").control_period;
    if (section_ != "robot" && section_ != "simulation")
      radius_ = read_robot_model(ini_).shape().inscribed_radius();
    if (kind_ == "mppi") parse_number(ini_.get(section_, "hold").value_or(""), noise_hold_);
    for (const Part& part : parts_) {
      for (const RosParameter& parameter : part.parameters) {
        convert(part, parameter, context_of(part));
        note_repetition(parameter);
      }
      for (const RosParameter& parameter : part.unused) {
        if (is_method() && rows_of(part, parameter).empty())
          report_.unknown.push_back(parameter.where);
        else if (has_target(part, parameter) || is_method())
          report_.without_counterpart.push_back({part.name + "." + parameter.key, part.why_unused});
      }
    }
    list_not_in_file();
  }

  RosContext context_of(const Part& part) const {
    RosContext context{part.parameters, control_period_, radius_};
    context.noise_hold = noise_hold_;
    for (const Part& other : parts_)
      if (other.family == RosFamily::LocalCostmap)
        for (const RosParameter& p : other.parameters)
          if (p.key == "resolution") parse_number(p.text, context.costmap_resolution);
    return context;
  }

  void note_repetition(const RosParameter& parameter) {
    if (!parameter.replaced_line) return;
    report_.repeated.push_back(parameter.where + ", which replaces line " +
                               std::to_string(*parameter.replaced_line + 1));
  }

  /// Moves the parameters of what the files define and do not use.
  static void set_aside(Part& part, const char* reason) {
    part.why_unused = reason;
    const std::vector<RosParameter> all = std::move(part.parameters);
    part.parameters.clear();
    for (const RosParameter& parameter : all)
      (is_used(all, parameter.key) ? part.parameters : part.unused).push_back(parameter);
  }

  bool has_target(const Part& part, const RosParameter& parameter) const {
    const auto rows = rows_of(part, parameter);
    return std::any_of(rows.begin(), rows.end(),
                       [&](const RosMapping* row) { return row->section == kind_; });
  }

  std::vector<const RosMapping*> rows_of(const Part& part, const RosParameter& parameter) const {
    std::vector<const RosMapping*> rows = find_mappings(part.family, parameter.key);
    if (rows.empty() && is_shim_ && part.name == prefix_)
      rows = find_mappings(RosFamily::RotationShim, parameter.key);
    return rows;
  }

  void convert(const Part& part, const RosParameter& parameter, const RosContext& context) {
    const std::vector<const RosMapping*> rows = rows_of(part, parameter);
    const std::string name = part.name + "." + parameter.key;
    bool has_target = false;
    std::string reason;
    for (const RosMapping* row : rows) {
      if (row->section == kind_) {
        has_target = true;
        if (part.family == RosFamily::VelocitySmoother && set_.count(row->target) > 0) continue;
        set(*row, parameter, context, name, row->convert(parameter, context));
      } else if (*row->section == '\0') {
        reason = row->note;
      }
    }
    if (has_target || !is_method()) return;
    if (rows.empty())
      report_.unknown.push_back(parameter.where);
    else
      report_.without_counterpart.push_back({name, reason});
  }

  bool is_given(const std::string& target) const {
    const bool is_shape = section_ == "robot" && (target == "radius" || target == "footprint");
    return given_.count(target) > 0 ||
           (is_shape && given_.count("radius") + given_.count("footprint") > 0);
  }

  void add_edit(const RosMapping& row, const RosParameter& parameter, const RosContext& context,
                const std::string& converted) {
    found_.insert(row.target);
    const std::string given = ini_.get(section_, row.target).value_or("");
    if (ros::same_value(given, converted)) return;
    const auto text = ros::inverse(row.convert, parameter, context, given);
    if (!text && !contains(report_.no_way_back, row.target))
      report_.no_way_back.emplace_back(row.target);
    if (text)
      report_.edits.push_back(
          {parameter.file, parameter.line, parameter.column, parameter.text, *text});
  }

  /// Keys of the .ini whose parameter the files do not have.
  void list_not_in_file() {
    for (const std::string& key : given_) {
      if (found_.count(key) > 0) continue;
      std::string name;
      for (const Part& part : parts_)
        if (name.empty()) name = name_of(part, key);
      if (name.empty() && key != "adapter" && key != "plugin") report_.no_way_back.push_back(key);
      if (!name.empty()) report_.not_in_file.push_back(name);
    }
  }

  /// "FollowPath.sim_time: 2" for a key of the .ini that is a parameter of the part, else "".
  std::string name_of(const Part& part, const std::string& key) const {
    for (const RosMapping& row : ros_parameter_table()) {
      if (row.family != part.family || row.section != kind_ || row.target != key) continue;
      RosParameter parameter;
      parameter.key = row.key;
      const auto text = ros::inverse(row.convert, parameter, context_of(part),
                                     ini_.get(section_, key).value_or(""));
      if (text && !starts_with(row.key, "*")) return part.name + "." + row.key + ": " + *text;
    }
    return "";
  }

  /// The largest step up to the default that divides the control period.
  void set_step(const RosParameter& parameter) {
    if (ini_.get(section_, "step")) return;
    const auto options = read_options<SimulationOptions>(ini_, section_);
    const double steps = options.control_period / options.step;
    if (std::abs(steps - std::round(steps)) <= 1e-6 * steps) return;
    const std::string step = format_number(options.control_period / std::ceil(steps));
    ini_.set(section_, "step", step, parameter.where + ": ");
    report_.mapped.push_back({parameter.key + " = " + parameter.text, "step = " + step});
  }

  void set(const RosMapping& row, const RosParameter& parameter, const RosContext& context,
           const std::string& name, const std::optional<std::string>& value) {
    const std::string text =
        parameter.items ? "[" + join(*parameter.items, ", ") + "]" : parameter.text;
    const RosParameterReport::Line line{name + " = " + text,
                                        row.target + (" = " + value.value_or(""))};
    if (!value) {
      auto& lines = report_.without_counterpart;  // once, however many targets there are
      if (lines.empty() || lines.back().parameter != line.parameter)
        lines.push_back({line.parameter, row.note});
    } else if (is_given(row.target)) {
      add_edit(row, parameter, context, *value);
      report_.overridden.push_back(
          {line.parameter,
           row.target + (" = " + ini_.get(section_, row.target).value_or("")) + " in the .ini"});
    } else if (set_.insert(row.target).second) {
      ini_.set(section_, row.target, *value, parameter.where + ": ");
      report_.mapped.push_back(line);
      if (row.target == std::string("control_period")) set_step(parameter);
    } else if (ini_.get(section_, row.target) == value) {
      report_.mapped.push_back(line);
    } else {
      report_.overridden.push_back(
          {line.parameter,
           row.target + (" = " + ini_.get(section_, row.target).value_or("")) + " of another one"});
    }
  }

  /// One value of a robot in URDF; what the .ini or another file says comes first.
  void set_of_robot(const std::string& path, const std::string& what, const std::string& target,
                    const std::string& value) {
    const bool is_shape = target == "radius" || target == "footprint";
    const RosParameterReport::Line line{what, target + " = " + value};
    if (is_given(target)) {
      const std::string given = is_shape && given_.count(target) == 0
                                    ? "another shape"
                                    : target + " = " + ini_.get(section_, target).value_or("");
      report_.overridden.push_back({what, given + " in the .ini"});
    } else if (is_set(target)) {
      report_.overridden.push_back({what, target + " of another file"});
    } else {
      set_.insert(target);
      ini_.set(section_, target, value, path + ": ");
      report_.mapped.push_back(line);
    }
  }
  bool is_set(const std::string& target) const {
    const bool is_shape = target == "radius" || target == "footprint";
    return set_.count(target) > 0 ||
           (is_shape && set_.count("radius") + set_.count("footprint") > 0);
  }

  void add_robot(const ros::UrdfRobot& robot, const std::string& path) {
    const bool has_shape = is_given("radius") || is_set("radius");
    const std::string way_in = "boxes, cylinders or spheres, or [robot] footprint beside from";
    if (!has_shape && !robot.meshes.empty())
      throw usage_error(robot.meshes[0], "its collision shape is a mesh, which is not read",
                        way_in);
    if (!has_shape && !robot.radius && robot.footprint.empty())
      throw usage_error(path, "no link has a collision shape", way_in);
    for (const std::string& mesh : robot.meshes)
      report_.without_counterpart.push_back({mesh, "a mesh is not read"});
    const std::string shapes = "collision shapes of '" + robot.name + "'";
    if (robot.radius) set_of_robot(path, shapes, "radius", decimal(*robot.radius));
    if (!robot.footprint.empty()) {
      std::vector<std::string> corners;
      for (const auto& corner : robot.footprint)
        corners.push_back(decimal(corner.x) + "," + decimal(corner.y));
      set_of_robot(path, shapes, "footprint", join(corners, "; "));
    }
    const std::string wheels = "limits of the joints of two wheels";
    if (robot.max_v) set_of_robot(path, wheels, "max_v", decimal(*robot.max_v));
    if (robot.max_w) set_of_robot(path, wheels, "max_w", decimal(*robot.max_w));
    add_lasers(robot, path);
  }

  void add_lasers(const ros::UrdfRobot& robot, const std::string& path) {
    const std::vector<std::string> sections = ini_.sections();
    const bool has_lasers = std::any_of(sections.begin(), sections.end(), [](const auto& name) {
      return starts_with(name, "laser.");
    });
    for (const ros::UrdfLaser& laser : robot.lasers) {
      const std::string what = "laser of '" + laser.name + "'";
      std::string section = "laser." + laser.name;
      while (!has_lasers && ini_.has_section(section)) section += "_";  // another one of the link
      if (has_lasers) {
        report_.overridden.push_back({what, "[laser.NAME] of the .ini"});
        continue;
      }
      const auto set = [&](const std::string& key, const std::string& value) {
        ini_.set(section, key, value, path + ": ");
      };
      set("x", decimal(laser.pose.x));
      set("y", decimal(laser.pose.y));
      set("yaw", decimal(laser.pose.phi));
      if (laser.upside_down) set("upside_down", "true");
      if (laser.aperture) set("aperture_deg", decimal(mrpt::RAD2DEG(*laser.aperture)));
      if (laser.rays) set("rays", decimal(*laser.rays));
      if (laser.max_range) set("max_range", decimal(*laser.max_range));
      report_.mapped.push_back({what, "[" + section + "]"});
    }
    if (!has_lasers) set_scan(robot.lasers, path);
  }

  /// The scan of [sensor], which methods get, is as wide, as dense and as far as those of lasers.
  void set_scan(const std::vector<ros::UrdfLaser>& lasers, const std::string& path) {
    constexpr double kMaxRays = 100000;
    double half = 0, range = 0, rays = 0;
    for (const ros::UrdfLaser& laser : lasers) {
      range = std::max(range, laser.max_range.value_or(0));
      if (!laser.aperture) continue;
      half = std::max(half, std::min(M_PI, std::abs(laser.pose.phi) + *laser.aperture / 2));
      rays = std::max(rays, (laser.rays.value_or(1) - 1) / *laser.aperture);  // per rad
    }
    const auto set = [&](const std::string& key, const std::string& value) {
      if (ini_.get("sensor", key)) return;
      ini_.set("sensor", key, value, path + ": ");
      report_.mapped.push_back({"scans of the lasers", "[sensor] " + key + " = " + value});
    };
    if (half > 0) set("aperture_deg", decimal(mrpt::RAD2DEG(2 * half)));
    const double all = std::round(2 * half * rays) + 1;
    if (all > 1 && all <= kMaxRays) set("rays", decimal(all));  // more are refused of the laser
    if (range > 0 && !ini_.get("sensor", "from")) set("max_range", decimal(range));
  }

  IniFile& ini_;
  const std::string section_;
  std::string kind_;    // the section of rows of the table
  std::string prefix_;  // the controller
  bool is_shim_ = false;
  std::vector<std::string> controllers_;  // of the files
  std::vector<Part> parts_;
  std::set<std::string> given_, set_, found_;      // keys of the .ini: its own, new, in the files
  double control_period_ = 0, radius_ = 0;         // s, m: of the campaign
  double noise_hold_ = RosContext{{}}.noise_hold;  // control periods
  RosParameterReport report_;
};

std::string lines_of(const std::string& title, const std::vector<RosParameterReport::Line>& lines) {
  if (lines.empty()) return "";
  std::string text = title + "\n";
  for (const RosParameterReport::Line& line : lines)
    text += "  " + printable_line(line.parameter + ": " + line.result) + "\n";
  return text;
}

constexpr char kNoLineBreak[] = "\n\\ No newline at end of file";

/// The lines of a file; a last one without a line break is followed by what diffs say of it.
std::vector<std::string> lines_of_file(const std::string& path) {
  const std::string text =
      read_text(path, "parameters of Nav2 or move_base (.yaml)", kMaxConfigSize);
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  if (!lines.empty() && text.back() != '\n') lines.back() += kNoLineBreak;
  return lines;
}

void replace_value(const RosParameterReport::Edit& edit, std::string& line) {
  const auto column = static_cast<std::size_t>(edit.column);
  if (line.size() < column || line.compare(column, edit.old_text.size(), edit.old_text) != 0)
    throw file_error(edit.file + ":" + std::to_string(edit.line + 1),
                     "the value '" + edit.old_text + "' is not written in its line",
                     "a number without quotes, tags or aliases, in a file of ASCII");
  line.replace(column, edit.old_text.size(), edit.new_text);
}

/// A note for readers of a file of Nav2 about the method that takes its parameters.
std::string note_on_counterpart(const std::string& section, const std::string& source) {
  const auto is_of = [&](const char* package) { return source.find(package) != std::string::npos; };
  if (!starts_with(section, "method.")) return "";
  const bool has_critics = is_of("(dwb_core::") || is_of("(nav2_mppi_controller::");
  if (!has_critics && !is_of("(nav2_")) return "";
  return std::string("; its ") + (has_critics ? "critics are" : "code is") +
         " not Nav2's: for your controller itself use adapter = ros2";
}

}  // namespace

void RosParameterSource::visit(OptionVisitor& v) {
  v.option(
      "from", from,
      "parameters of Nav2 or move_base (.yaml), of [robot] also a .urdf; comma-separated files");
  v.option("controller", controller, "with from: a controller of these files; empty: the only one");
}

std::string RosParameterReport::summary() const {
  std::string text = "[" + section + "] from " + source + ": " +
                     count_text(mapped.size(), "parameter") + " mapped";
  if (!overridden.empty()) text += ", " + std::to_string(overridden.size()) + " overridden";
  if (!without_counterpart.empty())
    text += ", " + std::to_string(without_counterpart.size()) + " without counterpart";
  text += note_on_counterpart(section, source);
  if (!repeated.empty()) text += "; given twice: " + join(repeated, ", ");
  if (unknown.empty()) return printable_line(text);
  constexpr std::size_t kShown = 3;
  const std::vector<std::string> shown(unknown.begin(),
                                       unknown.begin() + std::min(kShown, unknown.size()));
  text += "; unknown: " + join(shown, ", ");
  if (unknown.size() > kShown) text += " and " + std::to_string(unknown.size() - kShown) + " more";
  return printable_line(text);
}

std::string RosParameterReport::listing() const {
  std::string text = printable_line("[" + section + "] from " + source) + "\n";
  text += lines_of("mapped", mapped) + lines_of("overridden", overridden) +
          lines_of("without counterpart", without_counterpart);
  if (!repeated.empty()) text += "given twice\n";
  for (const std::string& where : repeated) text += "  " + printable_line(where) + "\n";
  if (!unknown.empty()) text += "unknown\n";
  for (const std::string& where : unknown) text += "  " + printable_line(where) + "\n";
  return text;
}

std::vector<RosParameterReport> resolve_ros_parameters(IniFile& ini) {
  std::vector<std::string> sections;
  for (const std::string& section : ini.sections())
    if (ini.get(section, "from") &&
        (contains({"simulation", "robot", "sensor"}, section) || starts_with(section, "method.")))
      sections.push_back(section);
  // Conversions of methods use the robot and the control period.
  for (const char* const first : {"simulation", "robot"})
    std::stable_partition(sections.begin(), sections.end(),
                          [&](const std::string& section) { return section == first; });
  std::vector<RosParameterReport> reports;
  for (const std::string& section : sections)
    reports.push_back(SectionResolver(ini, section).resolve());
  return reports;
}

std::vector<EditedRosParameters> edit_ros_parameters(
    const std::vector<RosParameterReport>& reports) {
  using Edit = RosParameterReport::Edit;
  std::map<std::string, std::map<std::pair<int, int>, Edit>> files;  // by line, last column first
  for (const RosParameterReport& report : reports)
    for (const Edit& edit : report.edits) {
      const auto [known, is_new] = files[edit.file].insert({{edit.line, -edit.column}, edit});
      if (!is_new && known->second.new_text != edit.new_text)
        throw usage_error(
            edit.file + ":" + std::to_string(edit.line + 1),
            "sections have different values, " + known->second.new_text + " and " + edit.new_text,
            "the same value in all sections of the .ini");
    }
  std::vector<EditedRosParameters> edited;
  for (const auto& [file, edits] : files) {
    std::vector<std::string> lines = lines_of_file(file);
    std::map<int, std::string> changed;
    for (const auto& [position, edit] : edits) {
      const auto line = static_cast<std::size_t>(edit.line);
      std::string& written =
          changed.try_emplace(edit.line, line < lines.size() ? lines[line] : "").first->second;
      replace_value(edit, written);
    }
    std::string diff = "--- " + file + "\n+++ " + file + "\n";
    for (const auto& [line, written] : changed) {
      const std::string number = std::to_string(line + 1);
      std::string& old = lines[static_cast<std::size_t>(line)];
      diff += "@@ -" + number + " +" + number + " @@\n-" + old + "\n+" + written + "\n";
      old = written;
    }
    std::string text;
    for (const std::string& line : lines) text += line.substr(0, line.find(kNoLineBreak)) + "\n";
    edited.push_back({file, std::move(text), std::move(diff)});
  }
  return edited;
}

std::string ros_parameter_diff(const std::vector<RosParameterReport>& reports) {
  std::string text;
  for (const EditedRosParameters& edited : edit_ros_parameters(reports)) text += edited.diff;
  return text;
}

}  // namespace slalom
