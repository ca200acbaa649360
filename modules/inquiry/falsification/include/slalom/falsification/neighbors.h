// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/falsification/fairness.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace slalom {

struct NeighborOptions {
  FairnessOptions fairness;           ///< its geometric conditions
  std::uint64_t seed = 1;             ///< of the scenarios of the mix
  std::size_t per_failure = 3;        ///< neighbors of each failure
  std::size_t runs_per_failure = 12;  ///< scenarios of the mix that are run for it
  /// Polled; when it returns true, there is no result.
  std::function<bool()> interrupted = {};
};

/// For each failure, scenarios of a CandidateMix in which the method reaches the goal: those most
/// similar in the sides of the workspace and the distance from start to goal (smallest sum of
/// absolute log ratios), so that what differs is in the obstacles. They are drawn independently of
/// the failures and of the search, and each is a neighbor of one failure at most; with too few
/// successes the last failures have fewer neighbors, or none. Deterministic; nullopt when
/// interrupted.
std::optional<std::vector<std::vector<Scenario>>> successful_neighbors(
    const FalsificationSetup& setup, const std::vector<Scenario>& failures,
    const NeighborOptions& options);

/// The scenario without each of its obstacles, one at a time: the variants whose runs prove that a
/// shrunk scenario is 1-minimal. `resolution`: cell size (m) of continuous scenarios.
std::vector<Scenario> one_removal_variants(const Scenario& scenario, double resolution);

}  // namespace slalom
