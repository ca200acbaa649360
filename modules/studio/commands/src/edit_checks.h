// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/scenario.h>

#include <string>

namespace slalom {

/// Checks of scenario edits. All but the first two throw Error (Usage).

std::string point_text(const mrpt::math::TPoint2D& p);  ///< "(x, y)"
/// Whether an obstacle covers a point inside the bounds. Always false for point maps: points have
/// no extent until they are rasterized.
bool is_covered(const Scenario& scenario, const mrpt::math::TPoint2D& p);

[[noreturn]] void refuse_edit(const Scenario& scenario, const std::string& what,
                              const std::string& expected);
void expect_representation(const Scenario& scenario, Representation required,
                           const std::string& what);
void expect_inside(const Scenario& scenario, const std::string& what,
                   const mrpt::math::TPoint2D& p);
void expect_free(const Scenario& scenario, const std::string& what, const mrpt::math::TPoint2D& p);
/// Rejects an edit that covers the start or goal with an obstacle, unless it was covered before.
void require_free_start_goal(const Scenario& before, const Scenario& after);

}  // namespace slalom
