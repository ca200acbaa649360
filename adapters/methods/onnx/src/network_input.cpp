// SPDX-License-Identifier: BSD-3-Clause
#include "network_input.h"

#include <slalom/core/enum_names.h>
#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr const char* kExpected =
    "CONTENTS or NAME: CONTENTS [as 1xN], separated by ';', with contents of scan, goal, velocity";

std::vector<int> parse_shape(const std::string& text, const std::string& where) {
  constexpr long long kMaxSide = 1'000'000;
  std::vector<int> shape;
  for (const std::string& part : split(text, 'x')) {
    long long side = 0;
    if (!parse_integer(part, side) || side < 1 || side > kMaxSide)
      throw usage_error(where, "invalid shape '" + text + "'", "for example 1x1x61");
    shape.push_back(static_cast<int>(side));
  }
  return shape;
}

NetworkInput parse_input(std::string text, const std::string& where) {
  NetworkInput input;
  if (const auto colon = text.find(':'); colon != std::string::npos) {
    input.name = trim(text.substr(0, colon));
    text = text.substr(colon + 1);
  }
  if (const auto as = text.find(" as "); as != std::string::npos) {
    input.shape = parse_shape(trim(text.substr(as + 4)), where);
    text.resize(as);
  }
  for (const std::string& word : split(text, ',')) {
    const auto content = from_name<InputContent>(word);
    if (!content) throw usage_error(where, "unknown content '" + word + "'", kExpected);
    input.contents.push_back(*content);
  }
  if (input.contents.empty()) throw usage_error(where, "an input without contents", kExpected);
  return input;
}

}  // namespace

std::vector<NetworkInput> parse_network_inputs(const std::string& text, const std::string& where) {
  std::vector<NetworkInput> inputs;
  for (const std::string& part : split(text, ';')) inputs.push_back(parse_input(part, where));
  if (inputs.size() > 1)
    for (const NetworkInput& input : inputs)
      if (input.name.empty())
        throw usage_error(where, "one of several inputs has no name", kExpected);
  return inputs;
}

InputEncoder::InputEncoder(const OnnxOptions& options, const RobotModel& robot,
                           const SensorModel& sensor, const std::string& where)
    : options_(options),
      robot_(robot),
      max_range_(sensor.max_range),
      rays_(static_cast<std::size_t>(sensor.rays)),
      scan_size_(options.scan_size > 0 ? static_cast<std::size_t>(options.scan_size) : rays_) {
  if (scan_size_ > rays_)
    throw usage_error(where, "scan_size is above the number of rays",
                      "at most " + std::to_string(rays_));
}

std::size_t InputEncoder::size(const NetworkInput& input) const {
  std::size_t total = 0;
  for (const InputContent content : input.contents) total += size(content);
  return total;
}

std::size_t InputEncoder::size(InputContent content) const {
  switch (content) {
    case InputContent::Scan:
      return scan_size_;
    case InputContent::Goal:
      return 3;
    case InputContent::Velocity:
      return robot_.holonomic() ? 3 : 2;
  }
  return 0;
}

std::vector<float> InputEncoder::encode(const NetworkInput& input,
                                        const Observation& observation) const {
  std::vector<float> values;
  values.reserve(size(input));
  for (const InputContent content : input.contents) {
    if (content == InputContent::Scan) add_scan(observation, values);
    if (content == InputContent::Goal) add_goal(observation, values);
    if (content == InputContent::Velocity) add_velocity(observation, values);
  }
  return values;
}

/// Group i has the rays from i rays / size on, so that groups differ by at most one ray.
void InputEncoder::add_scan(const Observation& observation, std::vector<float>& values) const {
  const auto& scan = *observation.scan;
  for (std::size_t group = 0; group < scan_size_; ++group) {
    const std::size_t first = group * rays_ / scan_size_, end = (group + 1) * rays_ / scan_size_;
    double nearest = max_range_;
    for (std::size_t i = first; i < end; ++i)
      if (scan.getScanRangeValidity(i)) nearest = std::min<double>(nearest, scan.getScanRange(i));
    const double ratio = nearest / max_range_;
    values.push_back(static_cast<float>(
        options_.scan_scaling == ScanScaling::None
            ? nearest
            : (options_.scan_scaling == ScanScaling::Divide ? ratio : 1 - ratio)));
  }
}

void InputEncoder::add_goal(const Observation& observation, std::vector<float>& values) const {
  const auto& goal = observation.goal_in_robot;
  const double distance = math::hypot(goal.x, goal.y);
  const double bearing = math::atan2(goal.y, goal.x);
  values.push_back(static_cast<float>(std::min(1.0, distance / options_.goal_distance)));
  values.push_back(static_cast<float>(math::cos(bearing)));
  values.push_back(static_cast<float>(math::sin(bearing)));
}

void InputEncoder::add_velocity(const Observation& observation, std::vector<float>& values) const {
  values.push_back(static_cast<float>(observation.v / robot_.max_v));
  values.push_back(static_cast<float>(observation.w / robot_.max_w));
  if (robot_.holonomic()) values.push_back(static_cast<float>(observation.vy / robot_.max_v));
}

}  // namespace slalom
