// SPDX-License-Identifier: BSD-3-Clause
#include "wire_writer.h"

#include <slalom/bags/ros_encoding.h>

namespace slalom {
namespace {

/// Writes the members that messages share.
class MessageWriter : public WireWriter {
 public:
  MessageWriter() : WireWriter(ByteLayout::CdrLittleEndian) {}

  MessageWriter& stamp(std::int64_t stamp) {
    constexpr std::int64_t kNanoseconds = 1'000'000'000;
    add(static_cast<std::int32_t>(stamp / kNanoseconds));
    add(static_cast<std::uint32_t>(stamp % kNanoseconds));
    return *this;
  }
  MessageWriter& header(const RosHeader& header) {
    stamp(header.stamp).text(header.frame);
    return *this;
  }
  MessageWriter& pose(const RosPose& pose) {
    doubles({pose.x, pose.y, pose.z, pose.qx, pose.qy, pose.qz, pose.qw});
    return *this;
  }
  MessageWriter& twist(const RosTwist& twist) {
    doubles({twist.vx, twist.vy, 0, 0, 0, twist.wz});
    return *this;
  }
  MessageWriter& covariance() {
    constexpr int kCovariance = 36;
    for (int i = 0; i < kCovariance; ++i) add(0.0);
    return *this;
  }
  MessageWriter& floats(std::initializer_list<double> values) {
    for (const double value : values) add(static_cast<float>(value));
    return *this;
  }
  MessageWriter& count(std::size_t items) {
    add(static_cast<std::uint32_t>(items));
    return *this;
  }

  void marker(const RosMarker& marker) {
    constexpr std::int32_t kId = 0, kCylinder = 3, kAdd = 0, kDelete = 2;
    header(marker.header).text(marker.name);
    add(kId).add(kCylinder).add(marker.removed ? kDelete : kAdd);
    pose(marker.pose).doubles({marker.diameter, marker.diameter, marker.height});
    floats({0.9, 0.4, 0.1, 0.8});                         // orange
    stamp(0).add(std::uint8_t{0});                        // forever, not locked to its frame
    count(0).count(0).text("");                           // points, their colors, texture
    header({}).text("");                                  // image of the texture
    count(0).count(0).text("").text("");                  // its bytes and coordinates; text, mesh
    text("").add(std::uint32_t{0}).add(std::uint8_t{0});  // its file
  }
};

}  // namespace

std::string encode(const RosScan& scan) {
  const double last = scan.ranges.empty() ? 0 : static_cast<double>(scan.ranges.size() - 1);
  MessageWriter writer;
  writer.header(scan.header)
      .floats({scan.angle_min, scan.angle_min + scan.angle_increment * last, scan.angle_increment})
      .floats({0, 0, scan.range_min, scan.range_max})  // times between rays and scans
      .sequence(scan.ranges)
      .sequence(std::vector<float>());  // intensities
  return writer.bytes();
}

std::string encode(const RosOdometry& odometry) {
  MessageWriter writer;
  writer.header(odometry.header).text(odometry.child_frame);
  writer.pose(odometry.pose).covariance().twist(odometry.twist).covariance();
  return writer.bytes();
}

std::string encode(const std::vector<RosTransform>& transforms) {
  MessageWriter writer;
  writer.count(transforms.size());
  for (const RosTransform& transform : transforms) {
    writer.header(transform.header).text(transform.child_frame);
    writer.pose(transform.pose);
  }
  return writer.bytes();
}

std::string encode(const RosStampedPose& pose) {
  return MessageWriter().header(pose.header).pose(pose.pose).bytes();
}

std::string encode(const RosTwist& twist) {
  MessageWriter writer;
  if (twist.header) writer.header(*twist.header);
  return writer.twist(twist).bytes();
}

std::string encode(const RosGrid& grid) {
  MessageWriter writer;
  writer.header(grid.header).stamp(grid.header.stamp).floats({grid.resolution});
  writer.add(grid.width).add(grid.height);
  writer.pose(grid.origin).sequence(grid.cells);
  return writer.bytes();
}

std::string encode(const std::vector<RosMarker>& markers) {
  MessageWriter writer;
  writer.count(markers.size());
  for (const RosMarker& marker : markers) writer.marker(marker);
  return writer.bytes();
}

}  // namespace slalom
