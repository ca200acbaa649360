// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/ros_parameters/parameter_table.h>

namespace slalom::ros {

using Result = std::optional<std::string>;

// Each is a RosConversion. Numbers are in SI units and radians in ROS, too.
Result number(const RosParameter& p, const RosContext& c);
Result limited_speed(const RosParameter& p, const RosContext& c);  ///< by that of any direction
Result reciprocal(const RosParameter& p, const RosContext& c);
Result half(const RosParameter& p, const RosContext& c);
Result absolute(const RosParameter& p, const RosContext& c);
Result whole(const RosParameter& p, const RosContext& c);
Result flag(const RosParameter& p, const RosContext& c);
Result obstacle_scale(const RosParameter& p, const RosContext& c);
Result largest(const RosParameter& p, const RosContext& c);  ///< of the parameters of this name
Result less_radius(const RosParameter& p, const RosContext& c);
Result radius(const RosParameter& p, const RosContext& c);
Result footprint(const RosParameter& p, const RosContext& c);

Result forward_if_not_negative(const RosParameter& p, const RosContext& c);
Result forward_if_zero(const RosParameter& p, const RosContext& c);
Result forward_if_false(const RosParameter& p, const RosContext& c);
Result first_item(const RosParameter& p, const RosContext& c);
Result third_item(const RosParameter& p, const RosContext& c);
Result forward_if_first_item_not_negative(const RosParameter& p, const RosContext& c);

Result zero_if_false(const RosParameter& p, const RosContext& c);
Result half_turn_if_false(const RosParameter& p, const RosContext& c);
Result collision_time(const RosParameter& p, const RosContext& c);
Result turn_radius(const RosParameter& p, const RosContext& c);
Result proximity_distance(const RosParameter& p, const RosContext& c);
Result rotation_angle(const RosParameter& p, const RosContext& c);
Result scaled_look_ahead(const RosParameter& p, const RosContext& c);
Result fixed_look_ahead(const RosParameter& p, const RosContext& c);
Result mppi_noise(const RosParameter& p, const RosContext& c);

Result mppi_steps(const RosParameter& p, const RosContext& c);
Result mppi_control_cost(const RosParameter& p, const RosContext& c);
Result mppi_kinematics(const RosParameter& p, const RosContext& c);
Result mppi_turning_radius(const RosParameter& p, const RosContext& c);
Result path_per_goal_weight(const RosParameter& p, const RosContext& c);

/// Whether both are the same text or number.
bool same_value(const std::string& a, const std::string& b);

/// The value of a parameter, in the place of `p`, that is converted to `value`; none if there is
/// none, or none that is the value itself, a multiple or, of a distance, with the radius added.
Result inverse(RosConversion conversion, const RosParameter& p, const RosContext& c,
               const std::string& value);

/// The text of a parameter; throws for a list and for a substitution of a launch file.
std::string scalar(const RosParameter& p, const std::string& expected);

}  // namespace slalom::ros
