// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/ompl/disc_checks.h>

#include <ompl/base/Planner.h>

namespace slalom {

/// The exact shortest path of a disc (shortest_disc_path()) as a planner of OMPL, for any program
/// that uses OMPL. Its space is R^2 or SE(2) with the checks of set_disc_checks(), by which it
/// knows the world; with SE(2), the heading turns evenly from that of the start to that of the
/// goal. The objective is the path length, the goal a GoalState or GoalStates.
///
/// The solution is a PathGeometric, valid for the same checks, longer than the shortest path by at
/// most the fraction `max_excess` of its length (also a parameter of the planner): no solution of
/// another planner is shorter than that. Without a solution, solve() returns INVALID_START,
/// INVALID_GOAL or UNRECOGNIZED_GOAL_TYPE, or ABORT, and then it is proved that there is none. It
/// needs milliseconds. OMPL's PathSimplifier gains nothing, and without a limit of time it does not
/// always end: set `simplify = false` in a request of ompl::tools::Benchmark. The termination
/// condition is evaluated before each pair of start and goal (TIMEOUT). Throws ompl::Exception for
/// other spaces, checks and objectives.
class ExactDiscPlanner : public ompl::base::Planner {
 public:
  explicit ExactDiscPlanner(const ompl::base::SpaceInformationPtr& space);

  void setup() override;
  void checkValidity() override;
  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& stop) override;
  void clear() override;
  /// The states of the last solution, connected in their order.
  void getPlannerData(ompl::base::PlannerData& data) const override;

  double max_excess() const { return max_excess_; }
  void set_max_excess(double max_excess) { max_excess_ = max_excess; }

 private:
  const DiscValidityChecker& disc() const;
  /// nullptr if it is proved that there is none.
  ompl::base::PathPtr find_path(const ompl::base::State* start,
                                const ompl::base::State* goal) const;

  double max_excess_ = 1e-6;
  ompl::base::PathPtr solution_;
};

}  // namespace slalom
