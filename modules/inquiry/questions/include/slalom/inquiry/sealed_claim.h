// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/inquiry/tune_search.h>
#include <slalom/statistics/betting.h>
#include <slalom/statistics/statistics.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace slalom {

/// Conclusion about a tuned configuration, compared with the default in success.
enum class TuneVerdict { NotShown, Better };
constexpr auto enum_names(TuneVerdict) {
  return std::array{"not_shown", "better"};
}

struct SealedOptions {
  double effect = 0.1;  ///< a difference in success for which the test is fast; in (0, 1]
  double confidence = 0.95;
  std::size_t batch = 20;           ///< scenarios between two looks
  std::size_t min_scenarios = 200;  ///< before it stops early
  std::size_t max_scenarios = 400;  ///< at most kMaxSealed
};

struct RateEstimate {
  double value = 0;
  Interval interval;
};

/// The mean of values in [low, 1], with its betting_interval(); requires a value.
RateEstimate betting_estimate(const std::vector<double>& values, double low, double effect,
                              double confidence);

/// A comparison of a tuned configuration with the default, in pairs of runs in scenarios that took
/// no part in its choice, in their order. It is Better when a BettingTest shows that its rate of
/// success is higher. If it is not, that happens with a probability of at most (1 - confidence) /
/// 2, also if the number of scenarios is increased later.
///
/// Intervals are valid at the end, however early (betting_interval()). That of the difference
/// reaches below 0 if and only if the configuration is not shown to be Better. The difference
/// itself would be too large after an early stop; hence the minimum of 200 scenarios.
class SealedClaim {
 public:
  /// Throws Error (Usage) for invalid options.
  explicit SealedClaim(const SealedOptions& options = {});

  /// Scenarios to add before the next look; 0 at the end.
  std::size_t next() const;
  /// The outcomes of the next scenario; ignored at the end.
  void add(bool tuned, bool reference);
  /// Increases the number of scenarios. Throws Error (Usage) if it is invalid.
  void extend(std::size_t max_scenarios);

  TuneVerdict verdict() const { return verdict_; }
  /// Valid at any time, for a difference in either direction.
  double p() const { return std::min(1.0, 2 * test_.p()); }
  std::size_t scenarios() const { return tuned_.size(); }

  /// Rates of success and their difference; require a scenario.
  RateEstimate tuned() const { return estimate(tuned_, 0); }
  RateEstimate reference() const { return estimate(reference_, 0); }
  RateEstimate difference() const;
  /// Success in the finals minus that here, with Newcombe's interval of independent samples, which
  /// supposes a number of scenarios that is fixed. From 200 scenarios on it covers as it should.
  RateEstimate optimism(const TuneCounts& finals) const;

  static constexpr std::size_t kMaxSealed = 1000;

 private:
  RateEstimate estimate(const std::vector<double>& values, double low) const;
  std::vector<double> differences() const;

  SealedOptions options_;
  BettingTest test_;
  TuneVerdict verdict_ = TuneVerdict::NotShown;
  std::vector<double> tuned_, reference_;  ///< 1 for success
};

}  // namespace slalom
