// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bag_writers.h"

#include <cmath>

namespace slalom::testing {

using Layout = ByteList::Layout;

constexpr std::int64_t kSecond = 1'000'000'000;  // ns

/// Messages as common_interfaces and common_msgs define them.
inline std::string scan_bytes(Layout layout, std::int64_t stamp, const std::string& frame,
                              float angle_min, float increment, float range_max,
                              const std::vector<float>& ranges) {
  const float angle_max = angle_min + increment * float(ranges.size() - 1);
  return ByteList(layout)
      .header(stamp, frame)
      .floats({angle_min, angle_max, increment, 0, 0.1F, 0.05F, range_max})
      .add(std::uint32_t(ranges.size()))
      .floats(ranges)
      .add(std::uint32_t{0})  // intensities
      .bytes();
}

/// {x, y, yaw} as position and quaternion.
inline std::vector<double> pose_numbers(double x, double y, double yaw) {
  return {x, y, 0, 0, 0, std::sin(yaw / 2), std::cos(yaw / 2)};
}

inline std::string odometry_bytes(Layout layout, std::int64_t stamp, const std::string& child,
                                  const std::vector<double>& pose, double v, double w) {
  return ByteList(layout)
      .header(stamp, "odom")
      .text(child)
      .doubles(pose)
      .doubles(std::vector<double>(36))
      .doubles({v, 0, 0, 0, 0, w})
      .doubles(std::vector<double>(36))
      .bytes();
}

inline std::string twist_bytes(Layout layout, double v, double w) {
  return ByteList(layout).doubles({v, 0, 0, 0, 0, w}).bytes();
}

inline std::string transform_bytes(Layout layout, std::int64_t stamp, const std::string& parent,
                                   const std::string& child, const std::vector<double>& pose) {
  return ByteList(layout)
      .add(std::uint32_t{1})
      .header(stamp, parent)
      .text(child)
      .doubles(pose)
      .bytes();
}

}  // namespace slalom::testing
