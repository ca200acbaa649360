// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/generation/generator.h>
#include <slalom/references/reference.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace slalom {

/// Whether a disc has a path, and also one over cell centers: a passage that it fits through to
/// rounding errors only would make a scenario solvable that no method can solve, and that has no
/// safest path and no bottleneck width.
bool is_certified(const PlanningProblem& problem, std::string& reason);

/// The same for the robot. A polygon that rotates in place has a path if its enclosing disc, of
/// `robot_radius`, has, or if find_footprint_path() finds one for the polygon.
bool is_certified(const World& world, double robot_radius, const std::optional<Footprint>& polygon,
                  std::string& reason);

/// A certified scenario with its world model.
struct SolvableWorld {
  std::unique_ptr<const World> world;
  int attempt = 0;  ///< number of the successful attempt
};

/// Generates candidates until one has a certified path for the robot; counts the reasons of
/// rejection.
class SolvableSearch {
 public:
  explicit SolvableSearch(const GenerationSettings& settings) : settings_(settings) {}

  /// Returns the candidate of attempt `attempt`, or nullopt with the reason.
  using Draw = std::function<std::optional<Scenario>(int attempt, std::string& reason)>;

  /// Starts with `first_attempt`; earlier attempts gave duplicates. Throws Error (Job) with the
  /// scenario's name when the attempts are exhausted.
  SolvableWorld find(const std::string& name, const Draw& draw, int first_attempt = 0) const;

 private:
  const GenerationSettings& settings_;
};

/// The scenario; with settings.goal_headings, of its seed, its goal has a random heading.
Scenario with_goal_heading(const Scenario& scenario, const GenerationSettings& settings,
                           std::uint64_t seed);

/// "PREFIX_0007".
std::string scenario_name(const std::string& prefix, int index);

}  // namespace slalom
