// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/metrics/metric.h>

#include <mrpt/math/TPoint2D.h>

#include <functional>
#include <optional>

namespace slalom {

/// The robot relative to a mover while both move straight.
struct Encounter {
  double begin = 0, end = 0;      ///< s of the run
  mrpt::math::TPoint2D from;      ///< m, from the mover's center to the robot's at `begin`
  mrpt::math::TPoint2D movement;  ///< m, how that changes until `end`
  double reach = 0;  ///< m, radius of the mover and of the disc that encloses the robot
};

/// NA with the reason if there is no trajectory, or nothing moved but the robot.
std::optional<Value> na_without_movers(const MetricContext& context);

/// Time (s of the run, which begins at 0) of a sample.
double run_time(const MetricContext& context, const Sample& sample);

/// Radius (m) of a mover and of the disc that encloses the robot: the distance of their centers at
/// which these touch.
double reach_of(const MetricContext& context, const Mover& mover);

/// The mover with which a run collided, the one at the robot in the last sample; null if there is
/// none, or the run did not end in a collision.
const Mover* touched_mover(const MetricContext& context);

/// Every part of every interval between samples in which a mover is present and its velocity is
/// constant. The robot moves straight at constant speed between samples.
void for_each_encounter(const MetricContext& context,
                        const std::function<void(const Encounter&)>& visit);

/// The smallest distance (m) during the encounter between the two discs; negative when they
/// overlap.
double smallest_gap(const Encounter& encounter);

}  // namespace slalom
