#pragma once

#include <slalom/scenario/scenario.h>

#include <string>

namespace slalom {

/// What edits of a scenario check. All but the first two throw Error (Usage).

std::string place_text(const mrpt::math::TPoint2D& p);  ///< "(x, y)"
/// Whether an obstacle covers a place inside the bounds. A point covers none: it has no extent
/// until cells are made of it.
bool is_covered(const Scenario& scenario, const mrpt::math::TPoint2D& p);

[[noreturn]] void refuse_edit(const Scenario& scenario, const std::string& what,
                              const std::string& expected);
void expect_representation(const Scenario& scenario, Representation wanted,
                           const std::string& what);
void expect_inside(const Scenario& scenario, const std::string& what,
                   const mrpt::math::TPoint2D& p);
void expect_free(const Scenario& scenario, const std::string& what, const mrpt::math::TPoint2D& p);
/// Start and goal must not come under an obstacle by an edit; those that were may stay.
void expect_uncovered(const Scenario& before, const Scenario& after);

}  // namespace slalom
