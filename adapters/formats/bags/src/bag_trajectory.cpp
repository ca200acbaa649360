// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/bags/bag_trajectory.h>
#include <slalom/bags/frame_tree.h>
#include <slalom/bags/topic_choice.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <map>

namespace slalom {
namespace {

struct TimedPose {
  std::int64_t time = 0;  ///< ns
  double x = 0, y = 0, yaw = 0;
  RosTwist twist;
};

using Poses = std::vector<TimedPose>;

bool is_earlier(const TimedPose& a, const TimedPose& b) {
  return a.time < b.time;
}

std::int64_t time_of(const BagMessage& message, const RosHeader& header) {
  return header.stamp != 0 ? header.stamp : message.time;
}

/// The poses of a topic.
class TopicPoses {
 public:
  explicit TopicPoses(const std::string& topic) : choice_("--topic", topic, kTypes) {}

  Poses read(const std::string& path, std::vector<std::string>& notes) {
    const auto topics = read_bag(path, [&](const BagMessage& message) { add(message); });
    choice_.check(path, topics);
    if (choice_.name().empty())
      throw file_error(
          path, "has no poses",
          "nav_msgs/Odometry, geometry_msgs/PoseStamped, or --topic /tf:map.base_link");
    notes.push_back("poses of '" + printable_line(choice_.name()) + "' in frame '" +
                    printable_line(frame_) + "'");
    if (left_out_ > 0)
      notes.push_back(count_text(left_out_, "message") + " without a pose left out");
    return std::move(poses_);
  }

 private:
  static constexpr std::array<const char*, 3> kTypes = {kOdometryTypes[0], kPoseTypes[0],
                                                        kPoseTypes[1]};

  void add(const BagMessage& message) {
    if (!choice_.takes(message.topic)) return;
    if (!is_one_of(kOdometryTypes, message.topic.type)) {
      const RosStampedPose stamped = decode_pose(message);
      return add(message, stamped.header, stamped.pose, {});
    }
    const RosOdometry odometry = decode_odometry(message);
    add(message, odometry.header, odometry.pose, odometry.twist);
  }

  void add(const BagMessage& message, const RosHeader& header, const RosPose& pose,
           const RosTwist& twist) {
    frame_ = header.frame;
    if (pose.is_valid())
      poses_.push_back({time_of(message, header), pose.x, pose.y, pose.yaw(), twist});
    else
      ++left_out_;
  }

  TopicChoice choice_;
  std::string frame_;
  Poses poses_;
  std::size_t left_out_ = 0;
};

/// The poses of one frame in another, at the times of the transform between them that is sent most
/// often; of the others, the latest ones.
class FramePoses {
 public:
  explicit FramePoses(const std::string& frames) {
    const std::size_t dot = frames.find('.');
    base_ = frames.substr(0, dot);
    frame_ = dot == std::string::npos ? "" : frames.substr(dot + 1);
  }

  Poses read(const std::string& path, std::vector<std::string>& notes) {
    read_bag(path, [&](const BagMessage& message) {
      if (!is_one_of(kTransformTypes, message.topic.type)) return;
      for (const RosTransform& transform : decode_transforms(message))
        if (transform.pose.is_valid())
          links_[transform.child_frame].push_back({transform.header.frame,
                                                   time_of(message, transform.header),
                                                   pose_of(transform.pose)});
    });
    const std::vector<std::string> chain = find_chain(path);
    const auto often = std::max_element(chain.begin(), chain.end(), [&](auto& a, auto& b) {
      return links_.at(a).size() < links_.at(b).size();
    });
    Poses poses;
    for (const Link& link : links_.at(*often)) {
      mrpt::poses::CPose3D pose;
      for (const std::string& name : chain) pose = latest(name, link.time) + pose;
      poses.push_back({link.time, pose.x(), pose.y(), pose.yaw(), {}});
    }
    notes.push_back("poses of frame '" + printable_line(frame_) + "' in '" + printable_line(base_) +
                    "'");
    return poses;
  }

 private:
  struct Link {
    std::string parent;
    std::int64_t time;
    mrpt::poses::CPose3D pose;
  };

  /// From the frame up to the child of the base. Sorts its links.
  std::vector<std::string> find_chain(const std::string& path) {
    std::vector<std::string> chain;
    for (std::string name = frame_; name != base_; name = links_.at(name).front().parent) {
      if (links_.count(name) == 0 || contains(chain, name))
        throw file_error(path,
                         "has no transforms from '" + printable_line(base_) + "' to '" +
                             printable_line(frame_) + "'",
                         "--topic /tf:FRAME.FRAME; slalom-replay info lists frames");
      chain.push_back(name);
    }
    if (chain.empty())
      throw file_error(path, "frame '" + printable_line(frame_) + "' in itself", "two frames");
    for (const std::string& name : chain)
      std::stable_sort(links_.at(name).begin(), links_.at(name).end(),
                       [](const Link& a, const Link& b) { return a.time < b.time; });
    return chain;
  }

  const mrpt::poses::CPose3D& latest(const std::string& name, std::int64_t time) const {
    const auto& links = links_.at(name);
    const auto next =
        std::upper_bound(links.begin(), links.end(), time,
                         [](std::int64_t now, const Link& link) { return now < link.time; });
    return next == links.begin() ? next->pose : (next - 1)->pose;
  }

  std::string base_, frame_;
  std::map<std::string, std::vector<Link>> links_;
};

/// With velocities, if any of them is not zero.
std::string csv_of(const Poses& poses) {
  const bool has_twist = std::any_of(poses.begin(), poses.end(), [](const TimedPose& pose) {
    return pose.twist.vx != 0 || pose.twist.vy != 0 || pose.twist.wz != 0;
  });
  std::string csv = has_twist ? "t,x,y,phi,v,w,vy\n" : "t,x,y,phi\n";
  for (const TimedPose& pose : poses) {
    constexpr int kDigits = 6;
    csv += format_fixed(1e-9 * static_cast<double>(pose.time), kDigits);
    for (const double number : {pose.x, pose.y, pose.yaw}) csv += "," + format_number(number);
    if (has_twist)
      for (const double number : {pose.twist.vx, pose.twist.wz, pose.twist.vy})
        csv += "," + format_number(number);
    csv += "\n";
  }
  return csv;
}

}  // namespace

TrajectoryFile load_bag_trajectory(const std::string& path, const std::string& topic, bool sideways,
                                   const LogSelection& selection) {
  constexpr std::string_view kFrames = "/tf:";
  std::vector<std::string> notes;
  Poses poses = starts_with(topic, kFrames)
                    ? FramePoses(topic.substr(kFrames.size())).read(path, notes)
                    : TopicPoses(topic).read(path, notes);
  std::stable_sort(poses.begin(), poses.end(), is_earlier);
  TrajectoryFile file = trajectory_from_text(csv_of(poses), path, sideways, selection);
  file.notes.insert(file.notes.begin(), notes.begin(), notes.end());
  return file;
}

}  // namespace slalom
