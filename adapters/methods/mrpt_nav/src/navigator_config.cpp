// SPDX-License-Identifier: BSD-3-Clause
#include "navigator_config.h"
#include "noted_config.h"

#include <slalom/core/distance.h>
#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>

#include <mrpt/config/config_parser.h>
#include <mrpt/core/bits_math.h>
#include <mrpt/system/string_utils.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace slalom {
namespace {

using mrpt::config::CConfigFileBase;
using mrpt::math::TPoint2D;

constexpr int kDiscCorners = 16;

struct Outline {
  std::string xs, ys;  ///< numbers separated by spaces
};

Outline as_text(const std::vector<TPoint2D>& corners) {
  Outline outline;
  for (const TPoint2D& corner : corners) {
    outline.xs += format_number(corner.x) + " ";
    outline.ys += format_number(corner.y) + " ";
  }
  return outline;
}

/// Writes PTG0_v_max_mps etc. for every trajectory generator that has these keys.
void write_generator_limits(CConfigFileBase& config, const std::string& section,
                            const RobotModel& robot) {
  std::vector<std::string> keys;
  config.getAllKeys(section, keys);
  for (const std::string& key : keys) {
    if (!starts_with(key, "PTG")) continue;
    if (ends_with(key, "_v_max_mps")) config.write(section, key, robot.max_v);
    if (ends_with(key, "_w_max_dps")) config.write(section, key, mrpt::RAD2DEG(robot.max_w));
  }
}

void write_levels(CConfigFileBase& config, const std::string& section, const Outline& outline,
                  double radius) {
  const int levels = config.read_int(section, "HEIGHT_LEVELS", 0);
  for (int level = 1; level <= levels; ++level) {
    const std::string prefix = "LEVEL" + std::to_string(level) + "_";
    config.write(section, prefix + "VECTORX", outline.xs);
    config.write(section, prefix + "VECTORY", outline.ys);
    config.write(section, prefix + "RADIUS", radius);
  }
}

void write_robot_section(CConfigFileBase& config, const RobotModel& robot) {
  const std::string section = "slalom_robot";
  config.write(section, "kinematics", to_string(robot.kinematics));
  config.write(section, "radius", robot.radius);
  config.write(section, "footprint", robot.footprint);
  config.write(section, "max_v", robot.max_v);
  config.write(section, "max_w", robot.max_w);
  config.write(section, "max_accel_v", robot.max_accel_v);
  config.write(section, "max_accel_w", robot.max_accel_w);
  config.write(section, "forward_only", robot.forward_only);
}

/// Intersection of the lines through (a, b) and (b, c), each moved outwards by `margin`.
TPoint2D offset_corner(const TPoint2D& a, const TPoint2D& b, const TPoint2D& c, double margin) {
  const auto normal = [](const TPoint2D& from, const TPoint2D& to) {
    const double length = distance_between(to, from);
    return TPoint2D((to.y - from.y) / length, (from.x - to.x) / length);
  };
  const TPoint2D n = normal(a, b), m = normal(b, c);
  const double scale = margin / (1 + n.x * m.x + n.y * m.y);
  return {b.x + scale * (n.x + m.x), b.y + scale * (n.y + m.y)};
}

struct Assignment {
  std::string section, key, value;
};

/// The overrides of "SECTION.KEY=VALUE; ...".
std::vector<Assignment> parse_assignments(const std::string& text, const std::string& where) {
  std::vector<Assignment> assignments;
  for (const std::string& assignment : split(text, ';')) {
    if (assignment.empty()) continue;
    const std::size_t equal = assignment.find('='), dot = assignment.rfind('.', equal);
    if (equal == std::string::npos || dot == std::string::npos || dot == 0 || dot + 1 >= equal)
      throw usage_error(where, "malformed assignment '" + assignment + "'",
                        "SECTION.KEY=VALUE; ...");
    assignments.push_back({trim(assignment.substr(0, dot)),
                           trim(assignment.substr(dot + 1, equal - dot - 1)),
                           trim(assignment.substr(equal + 1))});
  }
  return assignments;
}

}  // namespace

mrpt::config::CConfigFileMemory read_navigator_config(const std::string& path) {
  return {mrpt::config::config_parser(read_text(path, "an MRPT .ini", kMaxConfigSize))};
}

void override_config(CConfigFileBase& config, const std::string& assignments,
                     const std::string& where) {
  for (const auto& [section, key, value] : parse_assignments(assignments, where)) {
    if (!config.sectionExists(section))
      throw usage_error(where, "the configuration has no section [" + section + "]",
                        "a section of config");
    config.write(section, key, value);
  }
}

void require_overrides(const NotedConfig& config, const std::string& assignments,
                       const std::string& where) {
  using mrpt::system::strCmpI;  // MRPT ignores the case of names
  for (const auto& [section, key, value] : parse_assignments(assignments, where)) {
    std::vector<std::string> read;
    for (const auto& [read_section, read_key] : config.read_keys())
      if (strCmpI(read_section, section)) read.push_back(read_key);
    if (std::none_of(read.begin(), read.end(),
                     [&key = key](const std::string& one) { return strCmpI(one, key); }))
      throw usage_error(where, "nobody reads " + key + " in [" + section + "]",
                        expected_name(key, read, "a key that the class reads"));
  }
}

std::optional<std::string> value_of_key(const CConfigFileBase& config,
                                        const std::string& assignments, const std::string& name,
                                        const std::string& where) {
  const std::size_t dot = name.rfind('.');
  const std::string section = name.substr(0, dot), key = name.substr(dot + 1);
  std::optional<std::string> value;
  if (config.keyExists(section, key)) value = trim(config.read_string(section, key, ""));
  for (const Assignment& one : parse_assignments(assignments, where))
    if (one.section == section && one.key == key) value = one.value;
  return value;
}

std::vector<TPoint2D> enlarged_outline(const Footprint& shape, double margin) {
  std::vector<TPoint2D> outline;
  if (shape.is_disc()) {
    const double radius_of_corners =
        (shape.enclosing_radius() + margin) / math::cos(M_PI / kDiscCorners);
    for (int i = 0; i < kDiscCorners; ++i) {
      const double angle = (2 * i + 1) * M_PI / kDiscCorners;
      outline.emplace_back(radius_of_corners * math::cos(angle),
                           radius_of_corners * math::sin(angle));
    }
    return outline;
  }
  const std::vector<TPoint2D>& corners = shape.hull();
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i)
    outline.push_back(
        offset_corner(corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n], margin));
  return outline;
}

void write_robot(CConfigFileBase& config, const RobotModel& robot, double margin) {
  const Footprint shape = robot.shape();
  const Outline outline = as_text(enlarged_outline(shape, margin));
  const double radius = shape.enclosing_radius() + margin;
  config.write("CAbstractPTGBasedReactive", "robotMax_V_mps", robot.max_v);
  config.write("CAbstractPTGBasedReactive", "robotMax_W_degps", mrpt::RAD2DEG(robot.max_w));
  const std::string section_2d = "CReactiveNavigationSystem",
                    section_3d = "CReactiveNavigationSystem3D";
  config.write(section_2d, "RobotModel_shape2D_xs", outline.xs);
  config.write(section_2d, "RobotModel_shape2D_ys", outline.ys);
  config.write(section_2d, "RobotModel_circular_shape_radius", radius);
  write_levels(config, section_3d, outline, radius);
  write_generator_limits(config, section_2d, robot);
  write_generator_limits(config, section_3d, robot);
  write_robot_section(config, robot);
}

}  // namespace slalom
