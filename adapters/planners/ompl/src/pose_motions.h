// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/robot/robot_model.h>
#include <slalom/scenario/world.h>
#include <slalom/trajectory/path.h>

#include <mrpt/math/TPose2D.h>

#include <array>
#include <memory>
#include <vector>

namespace slalom {

/// The motions from pose to pose of a robot whose heading matters.
class PoseMotions {
 public:
  virtual ~PoseMotions() = default;

  using Pose = mrpt::math::TPose2D;

  virtual double length(const Pose& a, const Pose& b) const = 0;  ///< of the positions, m
  virtual Pose between(const Pose& a, const Pose& b, double fraction) const = 0;
  /// Whether the footprint is free of contact on the motion; then `fraction` is unchanged,
  /// otherwise it is the part of the motion that is known to be free.
  virtual bool is_free(const Pose& a, const Pose& b, double& fraction) const = 0;
  bool is_free(const Pose& a, const Pose& b) const {
    double unused = 0;
    return is_free(a, b, unused);
  }
  bool is_free_at(const Pose& pose) const;
  /// Adds the positions after that of a, up to that of b.
  virtual void append_positions(const Pose& a, const Pose& b, Path& path) const = 0;

  const RobotModel& robot() const { return robot_; }
  const World& world() const { return world_; }

 protected:
  PoseMotions(const World& world, const RobotModel& robot)
      : world_(world), robot_(robot), footprint_(robot.shape()) {}
  const Footprint& footprint() const { return footprint_; }

 private:
  const World& world_;
  RobotModel robot_;
  Footprint footprint_;
};

/// Dubins curves for a robot with a minimum turning radius, Reeds-Shepp curves if it may reverse;
/// for others straight motions: of a holonomic robot while it turns evenly, otherwise it rotates in
/// place before and after. Straight motions are checked exactly, curves along chords that deviate
/// by at most 0.01 mm, with the collision test of the simulation. The world must outlive them.
std::unique_ptr<PoseMotions> make_pose_motions(const World& world, const RobotModel& robot);

/// The poses between which a robot rotates in place, drives straight and rotates again.
std::array<mrpt::math::TPose2D, 4> rotate_and_drive(const mrpt::math::TPose2D& a,
                                                    const mrpt::math::TPose2D& b,
                                                    bool forward_only);

double length(const PoseMotions& motions, const std::vector<mrpt::math::TPose2D>& poses);

/// The positions, less those on the straight line between their neighbors.
Path positions_along(const PoseMotions& motions, const std::vector<mrpt::math::TPose2D>& poses);

}  // namespace slalom
