#pragma once

#include "coverage_bins.h"

#include <optional>
#include <string>

namespace slalom {

/// Coarsest cells (m) of a grid that coverage accepts; the proofs allow for it.
constexpr double kCoarsestCell = 0.25;

/// Why no scenario that meets the plan's limits can lie in a bin, or nullopt where nothing is
/// proved. The proofs stand in docs/scenarios.md.
std::optional<std::string> why_impossible(const CoverageBins& bins, std::size_t bin,
                                          const CoverageOptions& options, const CoverageTask& task);

/// The largest density that leaves a robot room for its way: 1 - (2 r D + pi r^2) / S^2.
double density_limit(double robot_radius, double min_distance, double side);

/// The largest clearness of any free set of this area: that of a disc.
double clearness_limit(double free_area, double sensor_range);

/// The least confinement of any free set of this area in a square of this side.
double confinement_limit(double free_area, double side, double sensor_range);

}  // namespace slalom
