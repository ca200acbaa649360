// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/mover.h>

#include <mrpt/math/TPose2D.h>

#include <string>

namespace slalom {

/// A scenario of Arena without its map.
struct ArenaScenario {
  mrpt::math::TPose2D start;
  mrpt::math::TPoint2D goal;
  Movers movers;
  std::string message;  ///< what is left out, in one line, "" if nothing
};

/// Throws Error (File) with the place in the file.
ArenaScenario arena_scenario_from_text(const std::string& text, const std::string& where);

}  // namespace slalom
