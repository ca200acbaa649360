#pragma once

#include <slalom/robot/robot_model.h>

#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/math/TPoint2D.h>

#include <string>
#include <vector>

namespace slalom {

/// The file with its definitions expanded. Throws std::runtime_error when it cannot be read.
mrpt::config::CConfigFileMemory read_navigator_config(const std::string& path);

/// Writes "SECTION.KEY=VALUE; ..." over what is there. Throws Error (Usage) at `where` for what is
/// not of that form and for sections that are not there.
void override_config(mrpt::config::CConfigFileBase& config, const std::string& assignments,
                     const std::string& where);

/// The outline of the robot enlarged by `margin`, counter-clockwise. A disc becomes a polygon of 16
/// corners around it, at most 2 % larger.
std::vector<mrpt::math::TPoint2D> enlarged_outline(const Footprint& shape, double margin);

/// Writes the robot's shape, enlarged by `margin` (m), and its limits where MRPT's navigators look
/// for them, and as they are in a section [slalom_robot] for navigators of other kinds.
void write_robot(mrpt::config::CConfigFileBase& config, const RobotModel& robot, double margin);

}  // namespace slalom
