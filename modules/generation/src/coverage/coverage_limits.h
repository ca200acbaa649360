// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "coverage_bins.h"

#include <optional>
#include <string>

namespace slalom {

/// Maximum cell size (m) of a grid that coverage accepts; the proofs account for it.
constexpr double kMaxCellSize = 0.25;

/// Why no scenario within the plan's limits can lie in a bin, or nullopt if that is not proved. The
/// proofs are in docs/guide/scenarios.md.
std::optional<std::string> infeasibility_reason(const CoverageBins& bins, std::size_t bin,
                                                const CoverageOptions& options,
                                                const CoverageSettings& settings);

/// The maximum density that leaves space for the robot's path: 1 - (2 r D + pi r^2) / S^2.
double density_limit(double robot_radius, double min_distance, double side);

/// The maximum clearness of a free set of this area: that of a disc.
double clearness_limit(double free_area, double sensor_range);

/// The minimum confinement of a free set of this area in a square of this side.
double confinement_limit(double free_area, double side, double sensor_range);

}  // namespace slalom
