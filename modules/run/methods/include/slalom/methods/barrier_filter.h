// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>
#include <slalom/methods/method_factory.h>

#include <string>

namespace slalom {

/// A safety filter around another method. A section [method.NAME] with filter = cbf.
struct BarrierFilterOptions {
  double gain = 5;           ///< 1/s: of the barrier's distance to the allowed speed of approach
  double margin = 0.02;      ///< m, kept between the footprint and obstacles
  double look_ahead = 0.15;  ///< s: the footprint is extended by the path of the command within it

  void visit(OptionVisitor& v);
};

/// The commands of `base`; where a control barrier function does not allow what the robot can reach
/// of it within the reaction time (control period, delays of robot and scan), the nearest allowed
/// one that it can reach, or 0 if there is none.
/// The barrier is the distance h of an obstacle point of the scan to the footprint, less the
/// margin; a command (v, w), of a holonomic robot (v, vy) at the w of the base, is allowed if for
/// all points dh/dt >= -alpha(h), where alpha(h) is gain * h, but at most the speed from which the
/// robot stops within h. This is the quadratic program of A. Ames et al., "Control Barrier
/// Functions: Theory and Applications", European Control Conference 2019, Eq. (22), solved exactly:
/// with two inputs its constraints are half planes. h is that after the reaction time at the
/// measured velocity. Obstacles count as standing still;
/// what the scan does not contain is not avoided. A command beyond the robot's limits is passed on.
MethodFactory barrier_filter(MethodFactory base, const BarrierFilterOptions& options = {});

/// The same with options from an .ini.
MethodFactory read_barrier_filter(const IniFile& ini, const std::string& section,
                                  MethodFactory base);

}  // namespace slalom
