// SPDX-License-Identifier: BSD-3-Clause
#include "descriptor_parameters.h"

#include <slalom/core/text.h>

namespace slalom::descriptors {

std::string robot(const DescriptorContext& context) {
  if (context.robot.is_disc()) return "robot_radius=" + format_number(context.robot_radius());
  std::vector<std::string> corners;
  for (const mrpt::math::TPoint2D& p : context.robot.corners())
    corners.push_back(format_number(p.x) + "," + format_number(p.y));
  return "footprint=" + join(corners, " ");
}

std::string resolution(const DescriptorContext& context) {
  if (context.world.scenario().representation() == Representation::Grid) return "";
  return "resolution=" + format_number(context.world.requested_resolution());
}

std::string sensor_range(const DescriptorContext& context) {
  return "sensor_range=" + format_number(context.sensor_range);
}

std::string join_parameters(const std::vector<DescriptorParameter>& parameters,
                            const DescriptorContext& context) {
  std::vector<std::string> given;
  for (const DescriptorParameter parameter : parameters) {
    given.push_back(parameter(context));
    if (given.back().empty()) given.pop_back();
  }
  return join(given, ";");
}

}  // namespace slalom::descriptors
