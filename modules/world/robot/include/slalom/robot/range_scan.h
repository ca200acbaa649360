// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/robot/robot_model.h>

#include <mrpt/math/TPoint2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <vector>

namespace slalom {

/// The valid ranges of a scan as points in the robot frame (m), using the pose of the laser on the
/// robot. Empty if the scan plane is not horizontal.
std::vector<mrpt::math::TPoint2D> scan_points(const mrpt::obs::CObservation2DRangeScan& scan);

/// The scans of a robot's lasers as one of `sensor`, at the robot's center: sensor.rays ranges, m,
/// counter-clockwise from -aperture/2; max_range without a return. Each point covers the angle
/// between it and its neighbors in its scan; each ray returns the closest point that covers it.
/// Directions that no scan covers are free.
std::vector<float> merged_ranges(
    const std::vector<const mrpt::obs::CObservation2DRangeScan*>& scans, const SensorModel& sensor);

}  // namespace slalom
