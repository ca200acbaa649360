// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/statistics/sequential_rate.h>

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// Consecutive bins of a parameter, from easy to hard: `first` up to `end`, excluded.
struct BinRange {
  std::size_t first = 0, end = 0;
};

/// The purpose of runs. Runs of different purposes must be independent of each other.
enum class LimitPhase {
  Pilot,  ///< to find where the limit may be; not part of the claim
  Claim,
  Curve  ///< the success in the bins beyond the limit; not part of the claim
};
constexpr auto enum_names(LimitPhase) {
  return std::array{"pilot", "claim", "curve"};
}

/// Makes runs with the parameter drawn uniformly in the bins, and passes whether each succeeded to
/// `receive`, in order, until that returns false or there are `max_runs`. Returns false when
/// interrupted.
using RunBins = std::function<bool(LimitPhase phase, const BinRange& bins, std::size_t max_runs,
                                   const std::function<bool(bool success)>& receive)>;

struct LimitOptions {
  std::size_t bins = 0;  ///< from easy to hard
  double reliability = 0.95, confidence = 0.95;
  std::size_t blocks = 6;  ///< of bins before the limit of the pilot; 0: each bin is a step
  std::size_t max_per_step = 2000, budget = 5000;  ///< runs for the claim
};

/// Runs in some bins.
struct BinRuns {
  BinRange bins;
  std::size_t runs = 0, failures = 0;
  bool reached = false;  ///< the reliability; of steps of the claim only

  double rate() const {
    return runs == 0 ? 0 : 1 - static_cast<double>(failures) / static_cast<double>(runs);
  }
};

struct LimitResult {
  std::vector<BinRuns> pilot;  ///< in the order of the bisection
  /// Tests from easy to hard. With the probability `confidence`, the rate of success in each that
  /// is reached is above `reliability`.
  std::vector<BinRuns> steps;
  std::vector<BinRuns> curve;  ///< bins after those that are claimed
  /// The pilot succeeds in the hardest bin and fails in the easiest one.
  bool exchanged = false;
  bool complete = false;  ///< false if interrupted, or if exchanged

  std::size_t claimed() const;  ///< steps that are reached
  std::size_t runs() const;     ///< of all phases
};

/// Finds the hardest bins up to which a method is reliable: a pilot by bisection, then a
/// FixedSequence over equal blocks of bins from the easy end to three bins before the limit of the
/// pilot, and over single bins from there; then the curve beyond. No step is split, repeated or
/// skipped.
LimitResult find_limit(const LimitOptions& options, const RunBins& run);

constexpr std::size_t kPilotRuns = 20;  ///< of each probe
constexpr std::size_t kCurveBins = 5, kCurveRuns = 30;

}  // namespace slalom
