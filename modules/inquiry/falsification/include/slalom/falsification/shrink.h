// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/falsification/fairness.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

struct ShrinkOptions {
  FairnessOptions fairness;
  std::size_t max_runs = 5000;  ///< of the method and the witnesses
  /// Polled; when it returns true, shrinking ends without a result.
  std::function<bool()> interrupted = {};
  /// Called when more runs were begun, with their number so far.
  std::function<void(std::size_t runs)> on_runs = {};
};

/// The removal of one part of the obstacles of the smallest scenario.
struct Removal {
  std::string part;     ///< "disc of radius 0.3 m at (2, 3.5)"
  std::string verdict;  ///< why the scenario without it is not the same failure: "mine: success"
};

/// The smallest scenario found in which the method fails with the same outcome.
struct ShrinkResult {
  Scenario scenario;
  Trial trial;  ///< of the method
  std::size_t parts_before = 0,
              parts_after = 0;  ///< obstacles; of grids and points: groups of cells
  std::size_t runs = 0;         ///< of the method and the witnesses
  std::size_t unfair = 0;       ///< scenarios that were refused for their geometry, without a run
  double moved = 0;  ///< m, from the last position of the original run to that of this one
  /// Each part was removed alone, and none of these scenarios is the same failure.
  bool minimal = false;
  std::vector<Removal> removals = {};
  FairnessReport fairness = {};
};

/// Whether `a` is the simpler one: it has fewer obstacles, or as many and a wider bottleneck, or
/// also that and a shorter distance from start to goal.
bool is_simpler(const ShrinkResult& a, const ShrinkResult& b);

std::string to_bytes(const ShrinkResult& result);
/// Throws Error (File) at `where` for malformed bytes.
ShrinkResult shrink_result_from_bytes(const std::string& bytes, const std::string& where);

/// Shrinks a failure: a scenario in which `setup.method` does not reach the goal. The result fails
/// with the same outcome; a witness reaches its goal, if one does in the original; no geometric
/// condition is violated more than in the original, and the workspace does not grow. Obstacles are
/// removed by delta debugging (Zeller and Hildebrandt, "Simplifying and Isolating Failure-Inducing
/// Input", IEEE TSE 2002; complements only), start and goal come closer to the failure, the
/// workspace is cropped, shapes get fewer corners, numbers fewer digits. Deterministic; nullopt
/// when interrupted. Throws Error (Job) when the run is no failure.
std::optional<ShrinkResult> shrink(const FalsificationSetup& setup, const Scenario& scenario,
                                   const ShrinkOptions& options = {});

}  // namespace slalom
