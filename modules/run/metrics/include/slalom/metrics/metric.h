// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/value.h>
#include <slalom/people/hindrance.h>
#include <slalom/references/reference.h>
#include <slalom/robot/robot_model.h>
#include <slalom/scenario/world.h>
#include <slalom/trajectory/trajectory.h>

#include <string>
#include <vector>

namespace slalom {

/// Default clearance (m) of the footprint below which a robot is at risk: about the width of a
/// small robot.
constexpr double kSafeDistance = 0.5;

/// Inputs of a metric. Independent of the simulator: the trajectory may come from any source.
struct MetricContext {
  const World& world;
  const RobotModel& robot;
  const Trajectory& trajectory;
  Outcome outcome;
  const References& references;
  const Movers& movers;                  ///< all that moved in the run but the robot
  double max_time = 60;                  ///< s, T_max
  double goal_tolerance = 0.2;           ///< m
  double safe_distance = kSafeDistance;  ///< m, a clearance below it counts as risk
  /// Clearance of the footprint at each sample (m), computed from the scenario's geometry.
  std::vector<double> clearances;
  Hindrances hindrances = {};  ///< of the people; empty: the scenario has none
};

/// Clearance (m) of the footprint at a pose: \f$d(p) - r\f$ for a disc of radius r, with the
/// distance d to the nearest obstacle; for a polygon the distance from its outline.
double footprint_clearance(const World& world, const Footprint& footprint,
                           const mrpt::math::TPose2D& pose);

/// Creates a context and computes its clearances. Without `movers` those of the scenario moved.
MetricContext make_metric_context(const World& world, const RobotModel& robot,
                                  const Trajectory& trajectory, Outcome outcome,
                                  const References& references, double max_time,
                                  double goal_tolerance, double safe_distance = kSafeDistance,
                                  const Movers* movers = nullptr);

/// How a successful run contradicts its references, or "": its length, extended to start and goal,
/// is below the optimum of the inscribed disc, or it ends before the lower bound of the earliest
/// arrival. That is impossible, so it is a defect of Slalom.
std::string bound_violation(const MetricContext& context);

/// A scalar result of a run: what it is, and the function that computes it. Called trajectory
/// descriptor in "Advances in the Framework for Automatic Evaluation of Obstacle Avoidance
/// Methods".
struct Metric {
  QuantityInfo info;
  Value (*compute)(const MetricContext& context);
};

/// All metrics, in the order of definitions.md; the table is in metric_table.cpp.
const std::vector<Metric>& all_metrics();
std::vector<std::string> metric_ids();  ///< of all of them
/// Metrics that are NA unless the run reached the goal.
const std::vector<std::string>& reached_metric_ids();

/// The metric with this id; throws Error (Usage) with the most similar id.
const Metric& metric(const std::string& id);

}  // namespace slalom
