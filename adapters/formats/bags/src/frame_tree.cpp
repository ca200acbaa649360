// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/bags/frame_tree.h>
#include <slalom/core/text.h>

#include <mrpt/math/CQuaternion.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

bool is_same(const RosPose& a, const RosPose& b) {
  constexpr double kTolerance = 1e-4;  // m; components of a quaternion
  const auto near = [](double one, double other) { return std::abs(one - other) < kTolerance; };
  return near(a.x, b.x) && near(a.y, b.y) && near(a.z, b.z) && near(a.qx, b.qx) &&
         near(a.qy, b.qy) && near(a.qz, b.qz) && near(a.qw, b.qw);
}

}  // namespace

mrpt::poses::CPose3D pose_of(const RosPose& pose) {
  mrpt::math::CQuaternionDouble rotation;
  rotation.r(pose.qw);
  rotation.x(pose.qx);
  rotation.y(pose.qy);
  rotation.z(pose.qz);
  rotation.normalize();
  return {rotation, pose.x, pose.y, pose.z};
}

void FrameTree::add(const RosTransform& transform) {
  if (!transform.pose.is_valid()) return;
  const auto [frame, is_new] =
      frames_.try_emplace(transform.child_frame, BagFrame{transform.header.frame, transform.pose});
  if (!is_new && !is_same(frame->second.pose, transform.pose)) frame->second.moves = true;
}

bool FrameTree::has(const std::string& frame) const {
  return frames_.count(frame) != 0 ||
         std::any_of(frames_.begin(), frames_.end(),
                     [&](const auto& other) { return other.second.parent == frame; });
}

std::optional<mrpt::poses::CPose3D> FrameTree::pose_in(const std::string& base,
                                                       const std::string& frame,
                                                       std::vector<std::string>& moving) const {
  const std::vector<std::string> of_base = chain(base), of_frame = chain(frame);
  const auto common = std::find_if(of_frame.begin(), of_frame.end(),
                                   [&](const auto& name) { return contains(of_base, name); });
  if (common == of_frame.end()) return std::nullopt;
  const auto pose_of_chain = [&](const std::vector<std::string>& names) {
    mrpt::poses::CPose3D pose;
    for (const std::string& name : names) {
      if (name == *common) break;
      const BagFrame& link = frames_.at(name);
      pose = pose_of(link.pose) + pose;
      if (link.moves) moving.push_back(name);
    }
    return pose;
  };
  return pose_of_chain(of_frame) - pose_of_chain(of_base);
}

std::vector<std::string> FrameTree::chain(const std::string& frame) const {
  std::vector<std::string> names = {frame};
  for (auto link = frames_.find(frame); link != frames_.end(); link = frames_.find(names.back())) {
    if (contains(names, link->second.parent)) break;
    names.push_back(link->second.parent);
  }
  return names;
}

}  // namespace slalom
