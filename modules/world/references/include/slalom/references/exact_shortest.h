// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/references/reference.h>

#include <optional>
#include <string>

namespace slalom {

/// The shortest path of a disc by shortest_disc_path(), as a polyline that is free in the model of
/// collision checking and at most 1e-6 (relative) longer. Length and both bounds are the optimum.
/// nullopt with `reason` if start or goal is not free or there is no path, which is then proved.
std::optional<ShortestPath> exact_shortest_path(const PlanningProblem& problem,
                                                std::string& reason);

}  // namespace slalom
