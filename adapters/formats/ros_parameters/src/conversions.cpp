// SPDX-License-Identifier: BSD-3-Clause
#include "conversions.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/robot/footprint.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace slalom::ros {
namespace {

/// Substitutions are made by ROS's launch programs, which do not run here.
void refuse_substitution(const RosParameter& p, const std::string& text,
                         const std::string& expected) {
  if (text.find("$(") != std::string::npos)
    throw usage_error(p.where, "'" + text + "' is a substitution of a launch file", expected);
}

double to_number(const RosParameter& p, const std::string& text) {
  const std::string expected = "a finite number";
  refuse_substitution(p, text, expected);
  double value = 0;
  if (!parse_number(text, value))
    throw usage_error(p.where, "'" + text + "' is not a number", expected);
  return value;
}

double value_of(const RosParameter& p) {
  return to_number(p, scalar(p, "a finite number"));
}

/// A word of YAML 1.1, as ROS reads it.
bool truth_of(const RosParameter& p) {
  const std::string word = lower_case(scalar(p, "true or false"));
  if (contains({"true", "yes", "on"}, word)) return true;
  if (contains({"false", "no", "off"}, word)) return false;
  throw usage_error(p.where, "'" + p.text + "' is neither true nor false", "true or false");
}

double sibling_number(const RosContext& c, const std::string& key, double otherwise) {
  const RosParameter* p = c.find(key);
  return p == nullptr ? otherwise : value_of(*p);
}

/// Whether a flag is given as false.
bool is_off(const RosContext& c, const std::string& key) {
  const RosParameter* p = c.find(key);
  return p != nullptr && !truth_of(*p);
}

/// Nav2's default is false.
bool is_look_ahead_scaled(const RosContext& c) {
  const RosParameter* p = c.find("use_velocity_scaled_lookahead_dist");
  return p != nullptr && truth_of(*p);
}

std::string truth_text(bool value) {
  return value ? "true" : "false";
}

double item_of(const RosParameter& p, std::size_t index) {
  const std::string expected = "[x, y, theta]";
  if (!p.items || p.items->size() != 3)
    throw usage_error(p.where, "is not a list of three numbers", expected);
  return to_number(p, (*p.items)[index]);
}

std::string without_sections(const std::string& key) {
  const std::size_t dot = key.rfind('.');
  return dot == std::string::npos ? key : key.substr(dot + 1);
}

/// A parameter, unless the flag that enables it is given as false: then 0.
Result number_or_zero(const RosParameter& p, const RosContext& c, const std::string& enabled) {
  return is_off(c, enabled) ? "0" : number(p, c);
}

/// The corners as text, of a list [[x, y], ...] or of a text with that list.
std::string corners_text(const RosParameter& p) {
  if (!p.items) return scalar(p, "[[x, y], ...]");
  std::string text;
  for (std::size_t i = 0; i < p.items->size(); ++i) {
    refuse_substitution(p, (*p.items)[i], "[[x, y], ...]");
    text += (i == 0 ? "" : i % 2 == 0 ? ";" : ",") + (*p.items)[i];
  }
  return text;
}

bool has_footprint(const RosParameter& p) {
  const std::string text = corners_text(p);
  return !text.empty() && text != "[]";
}

/// Names of Jazzy and, in lower case, of later versions.
std::string motion_model(const RosParameter& p) {
  return lower_case(scalar(p, "DiffDrive, Ackermann or Omni"));
}

}  // namespace

std::string scalar(const RosParameter& p, const std::string& expected) {
  if (p.items) throw usage_error(p.where, "is a list", expected);
  refuse_substitution(p, p.text, expected);
  return p.text;
}

Result number(const RosParameter& p, const RosContext&) {
  return format_number(value_of(p));
}

Result limited_speed(const RosParameter& p, const RosContext& c) {
  double speed = value_of(p);
  for (const char* key : {"max_speed_xy", "max_vel_trans", "max_trans_vel"})
    if (const double limit = sibling_number(c, key, -1); limit >= 0) speed = std::min(speed, limit);
  return format_number(speed);
}

Result reciprocal(const RosParameter& p, const RosContext&) {
  const double value = value_of(p);
  if (!(value > 0)) throw usage_error(p.where, "'" + p.text + "' is not positive", "more than 0");
  return format_number(1 / value);
}

Result half(const RosParameter& p, const RosContext&) {
  return format_number(0.5 * value_of(p));
}

Result absolute(const RosParameter& p, const RosContext&) {
  return format_number(std::abs(value_of(p)));
}

Result whole(const RosParameter& p, const RosContext&) {
  const double value = value_of(p);
  if (value != std::round(value))
    throw usage_error(p.where, "'" + p.text + "' is not an integer", "an integer");
  return format_number(value);
}

bool same_value(const std::string& a, const std::string& b) {
  double x = 0, y = 0;
  return a == b ||
         (parse_number(a, x) && parse_number(b, y) && std::abs(x - y) <= 1e-9 * std::abs(x));
}

Result inverse(RosConversion conversion, const RosParameter& p, const RosContext& c,
               const std::string& value) {
  std::vector<RosParameter> siblings;
  for (const RosParameter& one : c.siblings)
    if (one.where != p.where) siblings.push_back(one);
  siblings.push_back(p);
  siblings.back().items.reset();
  const RosContext context{siblings, c.control_period, c.inscribed_radius, c.costmap_resolution,
                           c.noise_hold};
  const auto convert = [&](const std::string& text) -> Result {
    siblings.back().text = text;
    try {
      return conversion(siblings.back(), context);
    } catch (const Error&) {
      return std::nullopt;  // no value of this parameter
    }
  };
  std::vector<std::string> texts = {value};
  if (double number = 0; parse_number(value, number)) {
    texts = {format_number(number), fmt::format("{:.12g}", number + c.inscribed_radius)};
    double image = 0;
    if (parse_number(convert(texts[0]).value_or(""), image) && image != 0)
      texts.push_back(fmt::format("{:.12g}", number * number / image));
    if (number != 0) texts.push_back(fmt::format("{:.12g}", 1 / number));
  }
  for (const std::string& text : texts)
    if (const Result back = convert(text); back && same_value(*back, value)) return text;
  return std::nullopt;
}

Result flag(const RosParameter& p, const RosContext&) {
  return truth_text(truth_of(p));
}

/// nav2, ObstacleFootprintCritic::getScale() and MapGridCritic::getScale(): distances count in m.
Result obstacle_scale(const RosParameter& p, const RosContext& c) {
  return format_number(c.costmap_resolution * value_of(p));
}

Result largest(const RosParameter& p, const RosContext& c) {
  double value = value_of(p);
  for (const RosParameter& other : c.siblings)
    if (without_sections(other.key) == without_sections(p.key))
      value = std::max(value, value_of(other));
  return format_number(value);
}

Result less_radius(const RosParameter& p, const RosContext& c) {
  return format_number(std::max(0.0, value_of(p) - c.inscribed_radius));
}

Result radius(const RosParameter& p, const RosContext& c) {
  const RosParameter* polygon = c.find("footprint");
  if (polygon != nullptr && has_footprint(*polygon)) return std::nullopt;
  return number(p, c);
}

/// Only numbers of the file become part of the .ini.
Result footprint(const RosParameter& p, const RosContext&) {
  if (!has_footprint(p)) return std::nullopt;
  const Footprint polygon = Footprint::parse(corners_text(p), p.where);
  std::vector<std::string> corners;
  for (const auto& corner : polygon.corners())
    corners.push_back(format_number(corner.x) + "," + format_number(corner.y));
  return join(corners, ";");
}

Result forward_if_not_negative(const RosParameter& p, const RosContext&) {
  return truth_text(value_of(p) >= 0);
}

Result forward_if_zero(const RosParameter& p, const RosContext&) {
  return truth_text(value_of(p) == 0);
}

Result forward_if_false(const RosParameter& p, const RosContext&) {
  return truth_text(!truth_of(p));
}

Result first_item(const RosParameter& p, const RosContext&) {
  return format_number(item_of(p, 0));
}

Result third_item(const RosParameter& p, const RosContext&) {
  return format_number(item_of(p, 2));
}

Result forward_if_first_item_not_negative(const RosParameter& p, const RosContext&) {
  return truth_text(item_of(p, 0) >= 0);
}

Result zero_if_false(const RosParameter& p, const RosContext&) {
  return truth_of(p) ? std::nullopt : Result("0");
}

Result half_turn_if_false(const RosParameter& p, const RosContext&) {
  return truth_of(p) ? std::nullopt : Result(format_number(M_PI));
}

Result collision_time(const RosParameter& p, const RosContext& c) {
  return number_or_zero(p, c, "use_collision_detection");
}

Result turn_radius(const RosParameter& p, const RosContext& c) {
  return number_or_zero(p, c, "use_regulated_linear_velocity_scaling");
}

Result proximity_distance(const RosParameter& p, const RosContext& c) {
  return is_off(c, "use_cost_regulated_linear_velocity_scaling") ? "0" : less_radius(p, c);
}

Result rotation_angle(const RosParameter& p, const RosContext& c) {
  return is_off(c, "use_rotate_to_heading") ? format_number(M_PI) : number(p, c);
}

Result scaled_look_ahead(const RosParameter& p, const RosContext& c) {
  if (is_look_ahead_scaled(c)) return number(p, c);
  return c.find("lookahead_dist") != nullptr ? std::nullopt : Result("0.6");
}

Result fixed_look_ahead(const RosParameter& p, const RosContext& c) {
  return is_look_ahead_scaled(c) ? std::nullopt : number(p, c);
}

/// A sample that is held spreads rollouts as independent ones of each `model_dt` do: variances of
/// a distance grow by (std * duration of a sample)^2 per sample.
Result mppi_noise(const RosParameter& p, const RosContext& c) {
  const double held = c.noise_hold * c.control_period;
  return format_number(value_of(p) * std::sqrt(sibling_number(c, "model_dt", 0.05) / held));
}

Result mppi_steps(const RosParameter&, const RosContext& c) {
  const double horizon = sibling_number(c, "time_steps", 56) * sibling_number(c, "model_dt", 0.05);
  return format_number(std::round(horizon / c.control_period));
}

Result mppi_control_cost(const RosParameter& p, const RosContext& c) {
  const double temperature = sibling_number(c, "temperature", 0.3);
  if (!(temperature > 0)) throw usage_error(p.where, "no positive temperature", "temperature > 0");
  return format_number(sibling_number(c, "gamma", 0.015) / temperature);
}

Result mppi_kinematics(const RosParameter& p, const RosContext&) {
  const std::string model = motion_model(p);
  if (model == "omni") return "holonomic";
  if (model == "diffdrive" || model == "diff_drive" || model == "ackermann") return "diff_drive";
  throw usage_error(p.where, "'" + p.text + "' is unknown", "DiffDrive, Ackermann or Omni");
}

Result mppi_turning_radius(const RosParameter& p, const RosContext& c) {
  const RosParameter* model = c.find("motion_model");
  if (model == nullptr || motion_model(*model) != "ackermann") return std::nullopt;
  return number(p, c);
}

Result path_per_goal_weight(const RosParameter& p, const RosContext& c) {
  const double goal =
      sibling_number(c, "gdist_scale", sibling_number(c, "goal_distance_bias", 0.8));
  const double path =
      sibling_number(c, "pdist_scale", sibling_number(c, "path_distance_bias", 0.6));
  if (!(goal > 0)) throw usage_error(p.where, "no positive weight of the goal", "gdist_scale > 0");
  return format_number(path / goal);
}

}  // namespace slalom::ros
