// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/bags/ros_messages.h>

#include <mrpt/poses/CPose3D.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

mrpt::poses::CPose3D pose_of(const RosPose& pose);

/// A frame in that of its parent.
struct BagFrame {
  std::string parent;
  RosPose pose;        ///< the first one
  bool moves = false;  ///< other poses follow
};

/// The frames of the transforms of a bag: what tf's listeners would know. As there, transforms that
/// are not valid are left out.
class FrameTree {
 public:
  void add(const RosTransform& transform);

  /// All frames with a parent, by name.
  const std::map<std::string, BagFrame>& frames() const { return frames_; }
  bool has(const std::string& frame) const;

  /// The first pose of `frame` in `base`; none if they are not connected. Frames between them that
  /// move are added to `moving`.
  std::optional<mrpt::poses::CPose3D> pose_in(const std::string& base, const std::string& frame,
                                              std::vector<std::string>& moving) const;

 private:
  /// From a frame to the root, without repetition.
  std::vector<std::string> chain(const std::string& frame) const;

  std::map<std::string, BagFrame> frames_;
};

}  // namespace slalom
