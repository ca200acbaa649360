// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/parameters.h"
#include "common/sectors.h"

/// Follow-the-Gap as an MRPT holonomic method: V. Sezer and M. Gokasan, "A novel obstacle avoidance
/// algorithm: Follow the Gap Method", Robotics and Autonomous Systems 60 (2012) 1123-1134. Equation
/// numbers refer to it.
namespace follow_the_gap_holonomic {

/// Lengths in the unit of the sectors: with the adapter mrpt_holonomic, reference distances.
struct Parameters {
  double alpha = 0.3;              ///< weight of the gap against the goal, Eq. (8)
  double look_ahead = 0.6;         ///< obstacles beyond this distance do not close gaps
  double goal_weight = 0.6;        ///< penalty of a gap: twice this per radian from the goal;
                                   ///< 0: the widest gap, as in the publication
  double field_of_view = 3.1416;   ///< rad: gaps outside it are ignored
  double slow_distance = 0.3;      ///< below this free distance the robot slows down
  double target_slow_down = 0.45;  ///< m: below this distance to the target the robot slows down

  void visit(slalom::OptionVisitor& v);
};

/// Direction of the midpoint between the obstacles at both ends of a gap, Eq. (7).
double gap_center(const reactive::Sectors& sectors, const reactive::SectorRun& run);

/// Eq. (8): the weighted mean of gap center and goal direction, with weight alpha / nearest
/// obstacle of the gap.
double final_direction(double gap_center, double goal, double nearest, double alpha);

class FollowTheGap {
 public:
  using Parameters = follow_the_gap_holonomic::Parameters;

  FollowTheGap() = default;
  explicit FollowTheGap(const Parameters& chosen) : parameters(chosen) {}
  reactive::Decision decide(const reactive::Sectors& sectors, const reactive::Point& target);

  Parameters parameters;

 private:
  reactive::SearchTurn search_;
};

}  // namespace follow_the_gap_holonomic
