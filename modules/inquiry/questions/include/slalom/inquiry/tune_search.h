// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/inquiry/tune_space.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace slalom {

/// The purpose of runs. Their scenarios must be independent of each other, and of those with which
/// the winner is compared with the default at last (SealedClaim).
enum class TunePhase {
  Development,  ///< to find good configurations
  Finals        ///< to choose among the best ones
};
constexpr auto enum_names(TunePhase) {
  return std::array{"development", "finals"};
}

struct TuneOutcome {
  bool success = false, collision = false;
  std::optional<double> secondary;  ///< less is better, as the time to the goal; none if it failed
};

struct TuneRequest {
  TunePhase phase = TunePhase::Development;
  std::size_t index = 0;  ///< of the configuration; 0 is the default
  const Configuration& configuration;
  std::size_t first = 0, count = 0;  ///< scenarios of the phase
};

/// Runs a configuration in consecutive scenarios and returns the outcomes in their order; fewer
/// than `count` when interrupted. No configuration is run twice in a scenario of a phase.
using RunConfiguration = std::function<std::vector<TuneOutcome>(const TuneRequest&)>;

struct TuneOptions {
  std::size_t budget = 3000;                    ///< runs of both phases; at least kMinTuneBudget
  std::size_t development = 240, finals = 300;  ///< scenarios
  double collision_cost = 3;                    ///< in failures
  double confidence =
      0.95;  ///< of a difference in success that the secondary value cannot outweigh
  std::uint64_t seed = 1;
};

struct TuneCandidate {
  Configuration configuration;
  std::vector<TuneOutcome> development, finals;  ///< the first scenarios of each
};

struct TuneCounts {
  std::size_t runs = 0, successes = 0, collisions = 0;
  std::optional<double> secondary;  ///< mean of the runs that have one

  double rate() const;  ///< of success; 0 without runs
};
TuneCounts counts_of(const std::vector<TuneOutcome>& outcomes);

/// p value of McNemar's exact test of success in pairs: the first scenarios, which both have.
double success_p_value(const std::vector<TuneOutcome>& a, const std::vector<TuneOutcome>& b);

struct TuneResult {
  std::vector<TuneCandidate> candidates;  ///< the first is the default
  std::size_t spread = 0;                 ///< candidates behind the default that are Sobol points
  std::vector<std::vector<std::size_t>> elites;  ///< after each iteration, best first
  std::vector<std::size_t> finalists;            ///< best first, by success in the finals
  std::size_t winner = 0;                        ///< the index of a candidate
  bool complete = false;                         ///< false if interrupted

  bool keeps_default() const { return winner == 0; }
  std::size_t runs(TunePhase phase) const;
};

/// Finds a configuration with a high rate of success, which may be the default.
///
/// Three iterations of successive halving (Jamieson and Talwalkar 2016): configurations are run in
/// the same few scenarios, the better half in twice as many, until five are left or the part of
/// the budget is used. The configurations are Sobol points in the first iteration, then draws from
/// normals around the five elites so far, with standard deviations of 0.2 and 0.12 of the unit cube
/// (as in iterated racing: Lopez-Ibanez et al. 2016). Then the elites and the default are run in
/// scenarios that the search has not seen, which alone decide: success in the scenarios of the
/// search is too good by the choice among many. A finalist with more collisions than the default
/// does not win; among finalists whose difference to the best in success is not shown (McNemar) the
/// best mean secondary value wins, over scenarios in which all of these have one.
///
/// The search uses 60 % of the budget, less if 100 scenarios of the finals need it, but 40 % at
/// least. Throws Error (Usage) for invalid options.
TuneResult tune_search(const ParameterSpace& space, const TuneOptions& options,
                       const RunConfiguration& run);

constexpr std::size_t kMinTuneBudget = 300;
constexpr std::size_t kTuneElites = 5, kTuneIterations = 3;

}  // namespace slalom
