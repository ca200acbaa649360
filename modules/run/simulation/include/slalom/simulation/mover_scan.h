// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/mover.h>
#include <slalom/scenario/ray_caster.h>

#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>

#include <vector>

namespace slalom {

/// Moving obstacles in the scans of a range sensor. The range to a mover is the smallest s >= 0 at
/// which the ray is on or in its disc, in closed form.
class MoverScan {
 public:
  /// `movers` must outlive this.
  MoverScan(const Movers& movers, const ScanGeometry& geometry);

  /// Reduces `ranges` (m, geometry.count of them), cast from `pose` among static obstacles, to the
  /// movers that are nearer at time t (s of the run).
  void add_to(const mrpt::math::TPose2D& pose, double t, float* ranges) const;

 private:
  void add_disc(const mrpt::math::TPoint2D& center, double radius, float* ranges) const;
  void add_rays(double bearing, double half_width, const mrpt::math::TPoint2D& center,
                double radius, float* ranges) const;

  const Movers& movers_;
  ScanGeometry geometry_;
  std::vector<mrpt::math::TPoint2D> directions_;  ///< of the rays, unit vectors in the robot frame
};

}  // namespace slalom
