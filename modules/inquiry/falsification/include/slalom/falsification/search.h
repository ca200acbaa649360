// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/falsification/fairness.h>

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace slalom {

/// How a scenario is chosen: half of the runs are of each strategy. Only the random one bounds the
/// failure probability, because its scenarios do not depend on results.
enum class SearchStrategy {
  Random,  ///< scenarios of the mix
  /// Changed scenarios in which the method came close to obstacles, probed ones, or those in which
  /// a surrogate of the method fails.
  Adaptive
};
constexpr auto enum_names(SearchStrategy) {
  return std::array{"random", "adaptive"};
}

/// A fair failure, except for its repetition.
struct FoundFailure {
  SearchStrategy strategy = SearchStrategy::Random;
  std::uint64_t index = 0;  ///< of the candidate of its strategy
  Scenario scenario;
  Trial trial;
};

/// Counts of one strategy of a search.
struct SearchTally {
  std::size_t runs = 0;  ///< of the method, each in a scenario that meets the geometric conditions
  std::size_t failures = 0;  ///< with one of the outcomes searched for, where a witness arrives
  std::size_t without_witness = 0;  ///< the same, but no witness arrives: they do not count
  std::map<std::string, std::size_t> outcomes;  ///< runs by outcome

  /// Upper limit (95 %) of the probability of a failure, if there was none: 3 / runs (rule of
  /// three: Hanley and Lippman-Hand, "If nothing goes wrong, is everything all right?", JAMA 1983).
  double rule_of_three() const { return 3.0 / static_cast<double>(runs); }
};

/// State of an interrupted search at the end of a round.
struct SearchState {
  std::uint64_t rounds = 0;
  SearchTally random, adaptive;
  std::vector<FoundFailure> failures;  ///< in the order of their candidates
  struct NearMiss {
    Scenario scenario;
    double clearance = 0;  ///< m, of a run that reached the goal
  };
  std::vector<NearMiss> near_misses;  ///< by clearance; parents of adaptive candidates

  std::size_t runs() const { return random.runs + adaptive.runs; }
};

std::string to_bytes(const SearchState& state);
/// Throws Error (File) at `where` for malformed bytes.
SearchState search_state_from_bytes(const std::string& bytes, const std::string& where);

struct SearchOptions {
  std::uint64_t seed = 1;
  std::size_t runs = 10000;  ///< of the method, in both halves; 0: unlimited
  /// Wall-clock time; 0: unlimited. Rounds then take a few seconds each, so that the search ends
  /// soon after it; at least one is executed.
  double minutes = 0;
  /// The search stops after the round that reaches this number, and keeps up to twice as many so
  /// that near-duplicates can be dropped.
  std::size_t max_failures = 10;
  /// Processes, 0: one per core. With a budget in runs, results do not depend on their number.
  int workers = 1;
  FairnessOptions fairness;
  /// The first witness is a reference, such as the method's last version: adaptive candidates start
  /// where the two commands differ: in single steps at poses near obstacles, or for the same
  /// observations of a run of the reference. The search hill-climbs towards smaller clearance from
  /// there.
  bool probe = false;
  std::vector<Outcome> outcomes;  ///< that count as failures
  SearchState known = {};         ///< continues this search
  /// Called after each round.
  std::function<void(const SearchState&)> save = {};
  /// Called when more runs were begun, with their number so far.
  std::function<void(std::size_t runs)> on_runs = {};
  std::function<bool()> interrupted = {};  ///< polled; the search then ends with the last round
};

/// Collisions, leaving the workspace, and failures of the method itself: what is severe and rare.
std::vector<Outcome> severe_outcomes();

struct SearchResult {
  SearchState state;
  bool complete = false;  ///< false when interrupted
  std::string stopped;    ///< why the search ended
};

/// Searches scenarios in which the method of the setup fails although a witness reaches the goal,
/// or by itself (needs_witness()). Half of the runs are in scenarios drawn at random from a
/// CandidateMix, half in changed ones (mutate()) of those in which the robot came closest to
/// obstacles, in probed ones, or, if the setup has a surrogate, in those random ones in which that
/// fails. Runs are in batches, each in a worker process; when the method crashes, that run is a
/// failure, and the rest of the batch is executed in another process. Throws Error (Usage) if there
/// is no budget, or nothing to compare single steps with.
SearchResult search(const FalsificationSetup& setup, const SearchOptions& options);

}  // namespace slalom
