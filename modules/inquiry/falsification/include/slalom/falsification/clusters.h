// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/enum_names.h>
#include <slalom/robot/robot_model.h>
#include <slalom/scenario/world.h>
#include <slalom/trajectory/end_motion.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace slalom {

/// Direction of the nearest obstacle at the end of a run, relative to the robot's heading: within
/// 45 degrees of it, beyond 135 degrees, or between.
enum class ObstacleSide { Front, Side, Back };
constexpr auto enum_names(ObstacleSide) {
  return std::array{"nearest obstacle in front", "nearest obstacle at the side",
                    "nearest obstacle behind"};
}

/// Features of a failing run, for clusters.
struct FailureFacts {
  Outcome outcome = Outcome::Collision;
  bool with_mover = false;   ///< a collision with a mover, which then is the nearest obstacle
  bool with_person = false;  ///< likewise, with a person
  ObstacleSide side = ObstacleSide::Front;
  EndMotion motion = EndMotion::Fast;
  bool faces_goal = true;       ///< at the end: the goal is within 90 degrees of the heading
  std::size_t obstacles = 0;    ///< of the smallest scenario
  double bottleneck_width = 0;  ///< robot widths, of the scenario
};

/// The facts of a run in `world` among `movers` (SimulationResult::movers); `obstacles` and
/// `bottleneck_width` are left to the caller. The nearest obstacle may be the border. Requires at
/// least one sample.
FailureFacts measure_end(const World& world, const Movers& movers, const RobotModel& robot,
                         Outcome outcome, const Trajectory& trajectory);

/// Each fact in words, in the order in which clusters are divided by them: outcome (and whether
/// it was with a mover or a person), side of the nearest obstacle, motion, direction of the goal,
/// number of obstacles (1, 2 to 3, more), bottleneck (below 2, below 4 robot widths, more).
std::vector<std::string> facts_in_words(const FailureFacts& facts);

/// Failures that are alike.
struct FailureCluster {
  std::string name;                  ///< the facts that all members share, the outcome first
  std::vector<std::size_t> members;  ///< indexes into the failures, ascending
};

/// Least size of a cluster: with fewer failures no contrast in 24 descriptors can be significant
/// (min_pairs_to_hold()).
constexpr std::size_t kMinCluster = 10;

/// Divides failures into clusters: by outcome, then fact by fact. Each value of a fact that at
/// least kMinCluster members have becomes a cluster of its own, and the others together another
/// one; if these are fewer than kMinCluster, the cluster is not divided by this fact. Sorted by
/// size, the largest first, then by name and first member. The clusters do not depend on the order
/// of the failures.
std::vector<FailureCluster> cluster_failures(const std::vector<FailureFacts>& failures);

}  // namespace slalom
