#pragma once

#include <slalom/core/value.h>
#include <slalom/references/reference.h>
#include <slalom/robot/robot_model.h>
#include <slalom/scenario/world.h>
#include <slalom/trajectory/trajectory.h>

#include <memory>
#include <string>
#include <vector>

namespace slalom {

/// Clearance (m) of the footprint below which a robot is at risk, unless a user says otherwise:
/// about the width of a small robot.
constexpr double kSafeDistance = 0.5;

/// What a metric may look at. The trajectory may come from anywhere; the simulator is not known
/// here.
struct MetricContext {
  const World& world;
  const RobotModel& robot;
  const Trajectory& trajectory;
  Outcome outcome;
  const References& references;
  double max_time = 60;                  ///< s, T_max
  double goal_tolerance = 0.2;           ///< m
  double safe_distance = kSafeDistance;  ///< m, a clearance below it is a risk
  /// Clearance of the footprint at each sample (m), from the scenario's geometry.
  std::vector<double> clearances;
};

/// Clearance (m) of the footprint at a pose: of a disc d(p) - radius, of a polygon the distance
/// from its outline.
double footprint_clearance(const World& world, const Footprint& footprint,
                           const mrpt::math::TPose2D& pose);

/// Fills `clearances`.
MetricContext make_metric_context(const World& world, const RobotModel& robot,
                                  const Trajectory& trajectory, Outcome outcome,
                                  const References& references, double max_time,
                                  double goal_tolerance, double safe_distance = kSafeDistance);

/// One number about a run (Strategy); the paper's trajectory descriptor.
class Metric {
 public:
  virtual ~Metric() = default;
  virtual QuantityInfo info() const = 0;
  virtual Value compute(const MetricContext& context) const = 0;
};

/// All metrics, in the order of definitions.md: the one list to add a line to.
const std::vector<std::shared_ptr<const Metric>>& all_metrics();

/// The metric with this id; throws Error (Usage) naming the nearest id.
const Metric& metric(const std::string& id);

}  // namespace slalom
