// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/io/svg_scene.h>

#include <string>

namespace slalom {

/// The picture of render_svg() with a robot that drives along `trajectory` again and again, in the
/// time it took: one SVG element, animated by SMIL, without scripts. The disc has
/// options.robot_radius. Without two samples nothing moves.
std::string render_animated_svg(const Scenario& scenario, const SceneOptions& options,
                                const Trajectory& trajectory);

}  // namespace slalom
