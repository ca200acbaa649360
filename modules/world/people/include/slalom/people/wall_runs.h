// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/occupancy.h>

#include <vector>

namespace slalom {

/// A run of edges between occupied and free cells (m), along an axis.
struct WallRun {
  mrpt::math::TPoint2D a, b;
  mrpt::math::TPoint2D to_free;  ///< of length 1, across the run
};

/// The boundary of the occupied cells and of the workspace in maximal runs: together exactly the
/// closed cells seen from free ones, and each convex, so that a half plane per run suffices.
std::vector<WallRun> find_wall_runs(const Occupancy& occupancy);

/// Finds the runs near a point.
class WallRuns {
 public:
  /// For queries within `reach` (m).
  WallRuns(const Occupancy& occupancy, double reach);

  const std::vector<WallRun>& runs() const { return runs_; }
  /// Indexes of all runs within `reach` of a point of the workspace, and of some more.
  const std::vector<std::size_t>& near(const mrpt::math::TPoint2D& p) const;

 private:
  int column(double x) const;
  int row(double y) const;
  std::size_t index(int column, int row) const;

  std::vector<WallRun> runs_;
  Bounds bounds_;
  double bucket_;  ///< m; not below the reach, so that a run is in few buckets
  int columns_, rows_;
  std::vector<std::vector<std::size_t>> buckets_;
};

}  // namespace slalom
