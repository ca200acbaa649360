// SPDX-License-Identifier: BSD-3-Clause
#include "bag_clock.h"
#include "gzip.h"
#include "rawlog_format.h"

#include <slalom/bags/frame_tree.h>
#include <slalom/bags/topic_choice.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>
#include <slalom/io/result_file.h>
#include <slalom/rawlog/log_objects.h>

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace slalom {
namespace {

using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationOdometry;
using mrpt::poses::CPose2D;
using mrpt::poses::CPose3D;

/// A message without a stamp has the time of its recording, ns.
struct MessageTime {
  std::int64_t recorded = 0, stamp = 0;
};

struct ImportedScan {
  MessageTime time;
  std::string frame;
  double middle = 0;  ///< angle of the middle ray in that frame, rad
  CObservation2DRangeScan::Ptr scan;
};

struct ImportedOdometry {
  MessageTime time;
  std::string child_frame;
  RosPose pose;
  RosTwist twist;
};

struct ImportedCommand {
  MessageTime time;
  RosTwist twist;
};

/// A scan at the pose of its frame's origin; its rays are turned by `middle`.
CObservation2DRangeScan::Ptr to_scan(const RosScan& from, const BagMessage& message,
                                     double& middle) {
  const std::size_t rays = from.ranges.size();
  const double aperture = std::abs(from.angle_increment) * static_cast<double>(rays - 1);
  if (!std::isfinite(from.angle_min) || !(aperture < 2 * M_PI + 0.1))
    throw message.place.error(
        "a scan of " + format_number(aperture) + " rad from " + format_number(from.angle_min),
        "at most a turn");
  auto scan = CObservation2DRangeScan::Create();
  scan->sensorLabel = message.topic.name;
  scan->aperture = static_cast<float>(aperture);
  scan->rightToLeft = from.angle_increment >= 0;
  const bool has_limit = std::isfinite(from.range_max) && from.range_max > 0;
  scan->maxRange =
      has_limit ? static_cast<float>(from.range_max) : std::numeric_limits<float>::max();
  std::vector<float> ranges = from.ranges;
  std::vector<char> valid(rays);
  for (std::size_t i = 0; i < rays; ++i) {
    const float range = ranges[i];
    valid[i] = std::isfinite(range) && range > 0 && range >= static_cast<float>(from.range_min) &&
                       range <= scan->maxRange
                   ? 1
                   : 0;
    if (valid[i] == 0) ranges[i] = 0;
  }
  scan->loadFromVectors(rays, ranges.data(), valid.data());
  middle = from.angle_min + 0.5 * from.angle_increment * static_cast<double>(rays - 1);
  return scan;
}

/// Collects the messages of a bag and makes a log of them.
class BagImporter {
 public:
  BagImporter(const std::string& path, const BagSelection& selection)
      : scan_topic_("--scan", selection.scan, kScanTypes),
        odometry_topic_("--odom", selection.odometry, kOdometryTypes),
        command_topic_("--command", selection.command, kTwistTypes),
        base_(selection.base) {
    log_.path = path;
  }

  void add(const BagMessage& message) {
    if (is_one_of(kTransformTypes, message.topic.type)) return add_transforms(message);
    if (scan_topic_.takes(message.topic)) return add_scan(message);
    if (odometry_topic_.takes(message.topic)) return add_odometry(message);
    if (!command_topic_.takes(message.topic)) return;
    const RosTwist twist = decode_twist(message);
    commands_.push_back({{message.time, twist.header ? twist.header->stamp : 0}, twist});
  }

  LogObjects log(const std::vector<BagTopic>& topics) && {
    for (const TopicChoice* choice : {&scan_topic_, &odometry_topic_, &command_topic_})
      choice->check(log_.path, topics);
    if (odometry_topic_.name().empty()) take_odometry_of_frames();
    if (scans_.empty() && odometry_.empty() && commands_.empty())
      throw file_error(log_.path, "has no message that can be used",
                       "sensor_msgs/LaserScan, nav_msgs/Odometry or geometry_msgs/Twist");
    note_counts();
    clock_.finish();
    choose_base();
    add_scans();
    add_odometries();
    add_commands();
    note(left_out_, "message", "without a pose or rays left out");
    const auto earlier = [](const auto& a, const auto& b) { return a.first < b.first; };
    std::stable_sort(timed_.begin(), timed_.end(), earlier);
    for (auto& [time, object] : timed_) log_.objects.push_back(std::move(object));
    return std::move(log_);
  }

 private:
  void add_transforms(const BagMessage& message) {
    for (const RosTransform& transform : decode_transforms(message)) {
      frames_.add(transform);
      if (transform.header.frame == kOdometryFrame && transform.pose.is_valid())
        frame_odometry_.push_back(
            {{message.time, transform.header.stamp}, transform.child_frame, transform.pose, {}});
    }
  }

  void add_scan(const BagMessage& message) {
    const RosScan from = decode_scan(message);
    if (from.ranges.empty()) {
      ++left_out_;
      return;
    }
    ImportedScan scan;
    scan.time = stamped(message, from.header);
    scan.frame = from.header.frame;
    scan.scan = to_scan(from, message, scan.middle);
    scans_.push_back(std::move(scan));
  }

  void add_odometry(const BagMessage& message) {
    const RosOdometry from = decode_odometry(message);
    if (!from.pose.is_valid()) {
      ++left_out_;
      return;
    }
    odometry_.push_back({stamped(message, from.header), from.child_frame, from.pose, from.twist});
  }

  MessageTime stamped(const BagMessage& message, const RosHeader& header) {
    if (header.stamp != 0) clock_.add(message.time, header.stamp);
    return {message.time, header.stamp};
  }

  /// Uses transforms as odometry, which have no velocities.
  void take_odometry_of_frames() {
    odometry_ = std::move(frame_odometry_);
    has_twist_ = false;
    if (odometry_.empty()) return;
    const std::string child = odometry_.front().child_frame;
    for (const auto& odometry : odometry_)
      if (odometry.time.stamp != 0) clock_.add(odometry.time.recorded, odometry.time.stamp);
    log_.notes.push_back("odometry is the transform from '" + std::string(kOdometryFrame) +
                         "' to '" + child + "'");
    odometry_.erase(std::remove_if(odometry_.begin(), odometry_.end(),
                                   [&](const auto& other) { return other.child_frame != child; }),
                    odometry_.end());
  }

  void choose_base() {
    const std::string child = odometry_.empty() ? "" : odometry_.front().child_frame;
    if (base_.empty()) {
      constexpr const char* kUsual = "base_link";
      base_ = frames_.has(kUsual) || child.empty() ? kUsual : child;
      return;
    }
    const bool is_known =
        frames_.has(base_) || base_ == child ||
        std::any_of(scans_.begin(), scans_.end(), [&](const auto& s) { return s.frame == base_; });
    if (!is_known) {
      std::vector<std::string> names;
      for (const auto& [name, frame] : frames_.frames()) names.push_back(printable_line(name));
      throw file_error(log_.path, "has no frame '" + base_ + "'",
                       names.empty() ? "a bag with transforms" : expected_name(base_, names));
    }
  }

  /// The pose of the frame of a sensor on the robot, and a note about it.
  CPose3D sensor_pose(const std::string& frame) {
    if (frame == base_) return {};
    const std::string name = "laser '" + printable_line(frame) + "'";
    std::vector<std::string> moving;
    const auto pose = frames_.pose_in(base_, frame, moving);
    if (!pose) {
      log_.notes.push_back(name + ": no transform from '" + base_ +
                           "'; taken as at the robot's center");
      return {};
    }
    constexpr double kNegligible = 1e-3;  // m, rad
    if (moving.empty() &&
        std::abs(pose->x()) + std::abs(pose->y()) + std::abs(pose->yaw()) + std::abs(pose->roll()) <
            kNegligible)
      return *pose;
    const auto number = [](double value) { return format_fixed(value, 3); };
    std::string text = name + " is at (" + number(pose->x()) + ", " + number(pose->y()) + ", " +
                       number(pose->z()) + ") m, yaw " + number(pose->yaw()) + ", roll " +
                       number(pose->roll()) + " of '" + base_ + "'";
    if (!moving.empty())
      text += "; it moves (" + printable_line(join(moving, ", ")) + "), its first pose is used";
    log_.notes.push_back(text);
    return *pose;
  }

  void add_scans() {
    std::map<std::string, CPose3D> poses;
    for (ImportedScan& from : scans_) {
      auto known = poses.find(from.frame);
      if (known == poses.end()) known = poses.emplace(from.frame, sensor_pose(from.frame)).first;
      from.scan->sensorPose = known->second + CPose3D(0, 0, 0, from.middle, 0, 0);
      insert(from.time, Rank::Scan, std::move(from.scan));
    }
  }

  void add_odometries() {
    if (odometry_.empty()) return;
    const std::string& child = odometry_.front().child_frame;
    std::vector<std::string> moving;
    const auto found = frames_.pose_in(child, base_, moving);
    const CPose2D base(found.value_or(CPose3D()));
    if (!found && child != base_)
      log_.notes.push_back("odometry is of '" + printable_line(child) + "': no transform to '" +
                           base_ + "'; taken as that of the robot's center");
    if (has_twist_ && has_zero_twists()) {
      has_twist_ = false;
      log_.notes.push_back("twists of '" + printable_line(odometry_topic_.name()) +
                           "' are zero: velocities are the differences of its poses");
    }
    for (const ImportedOdometry& from : odometry_) {
      const CPose2D pose(from.pose.x, from.pose.y, from.pose.yaw());
      auto odometry = CObservationOdometry::Create();
      odometry->sensorLabel = kOdometryLabel;
      odometry->odometry = pose + base;
      odometry->hasVelocities = has_twist_;
      const RosTwist& twist = from.twist;
      odometry->velocityLocal = {twist.vx - twist.wz * base.y(), twist.vy + twist.wz * base.x(),
                                 twist.wz};
      odometry->velocityLocal.rotate(-base.phi());
      insert(from.time, Rank::Odometry, std::move(odometry));
    }
  }

  /// Whether a driver leaves the twists empty while the robot moves.
  bool has_zero_twists() const {
    const RosPose& first = odometry_.front().pose;
    bool has_moved = false;
    for (const auto& [time, child, pose, twist] : odometry_) {
      if (twist.vx != 0 || twist.vy != 0 || twist.wz != 0) return false;
      has_moved = has_moved || pose.x != first.x || pose.y != first.y || pose.qz != first.qz;
    }
    return has_moved;
  }

  void add_commands() {
    const bool lacks_stamps = std::any_of(commands_.begin(), commands_.end(),
                                          [](const auto& from) { return from.time.stamp == 0; });
    if (lacks_stamps && clock_.is_other_clock())
      log_.notes.push_back(
          "commands have no stamps: the times of their recording are put on the "
          "clock of the other stamps");
    for (const ImportedCommand& from : commands_) {
      auto command = CObservationOdometry::Create();
      command->sensorLabel = kCommandLabel;
      command->hasVelocities = true;
      command->velocityLocal = {from.twist.vx, from.twist.vy, from.twist.wz};
      insert(from.time, Rank::Command, std::move(command));
    }
  }

  /// At the same time odometry comes before the scan that has it, and before a command.
  enum class Rank { Odometry, Scan, Command };

  void insert(const MessageTime& from, Rank rank, mrpt::obs::CObservation::Ptr observation) {
    const std::int64_t time = from.stamp != 0 ? from.stamp : clock_.stamp_of(from.recorded);
    constexpr std::int64_t kTick = 100;  // ns
    observation->timestamp = mrpt::Clock::fromDouble(0) + mrpt::Clock::duration(time / kTick);
    timed_.emplace_back(std::pair(time, rank), std::move(observation));
  }

  void note_counts() {
    const auto used = [](std::size_t count, const char* noun, const TopicChoice& choice) {
      const std::string topic = printable_line(choice.name());
      return count_text(count, noun) + (topic.empty() ? "" : " of '" + topic + "'");
    };
    log_.notes.insert(log_.notes.begin(), used(scans_.size(), "scan", scan_topic_) + ", " +
                                              used(odometry_.size(), "pose", odometry_topic_) +
                                              ", " +
                                              used(commands_.size(), "command", command_topic_));
  }

  void note(std::size_t count, const char* noun, const char* text) {
    if (count > 0) log_.notes.push_back(count_text(count, noun) + " " + text);
  }

  static constexpr const char* kOdometryFrame = "odom";

  TopicChoice scan_topic_, odometry_topic_, command_topic_;
  std::string base_;
  LogObjects log_;
  FrameTree frames_;
  BagClock clock_;
  std::vector<ImportedScan> scans_;
  std::vector<ImportedOdometry> odometry_, frame_odometry_;
  std::vector<ImportedCommand> commands_;
  std::vector<std::pair<std::pair<std::int64_t, Rank>, mrpt::serialization::CSerializable::Ptr>>
      timed_;
  bool has_twist_ = true;
  std::size_t left_out_ = 0;
};

}  // namespace

bool BagSelection::is_default() const {
  return scan.empty() && odometry.empty() && command.empty() && base.empty();
}

LogObjects import_bag(const std::string& path, const BagSelection& selection) {
  BagImporter importer(path, selection);
  const auto topics = read_bag(path, [&](const BagMessage& message) { importer.add(message); });
  return std::move(importer).log(topics);
}

void write_rawlog(const LogObjects& log, const std::string& path) {
  GzipWriter file;
  for (const auto& object : log.objects) {
    mrpt::io::CMemoryStream bytes;
    mrpt::serialization::archiveFrom(bytes).WriteObject(object.get());
    file.write(bytes.getRawBufferData(), bytes.getTotalBytesCount());
  }
  write_file_atomically(path, file.finish());
}

}  // namespace slalom
