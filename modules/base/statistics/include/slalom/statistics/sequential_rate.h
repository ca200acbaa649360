// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace slalom {

/// An alternative of a RateTest.
struct RateAlternative {
  double part;    ///< its rate of failure, in parts of that of the hypothesis, in [0, 1)
  double weight;  ///< all weights together are 1
};
using RateMixture = std::vector<RateAlternative>;

/// Reaches a decision with few runs if the rate is not near that of the hypothesis.
RateMixture few_runs_mixture();
/// Also reaches it, with more runs, for rates just above that of the hypothesis.
RateMixture close_rates_mixture();

/// A test of "the rate of success is at most `rate`" that is valid however often one looks. Its
/// wealth is a mixture of likelihood ratios against that rate, 1 at first: a nonnegative martingale
/// at the rate, a supermartingale below it, so that it ever reaches 1 / (1 - confidence) with a
/// probability of at most 1 - confidence (Ville 1939).
///
/// Runs after the decision do not count: batches of any size give the same decision.
class RateTest {
 public:
  /// Requires both in (0, 1).
  RateTest(double rate, double confidence, const RateMixture& mixture = few_runs_mixture());

  void add(bool success);

  bool reached() const { return reached_; }
  /// Wealth below kFutileWealth after kMinFutileRuns: a rate above is not worth more runs.
  bool futile() const { return futile_; }
  std::size_t runs() const { return successes_ + failures_; }  ///< up to the decision
  std::size_t failures() const { return failures_; }

  /// Logarithm of the wealth after these runs, in any order.
  double log_wealth(std::size_t successes, std::size_t failures) const;
  double log_target() const { return log_target_; }  ///< of the wealth

  static constexpr double kFutileWealth = 0.01;
  static constexpr std::size_t kMinFutileRuns = 40;

 private:
  struct Alternative {
    double log_weight, log_success;
    std::optional<double> log_failure;  ///< none: it has no failures
  };
  std::vector<Alternative> alternatives_;
  double log_target_, log_futile_;
  std::size_t successes_ = 0, failures_ = 0;
  bool reached_ = false, futile_ = false;
};

/// The smallest number of runs with which a RateTest is reached, which is without a failure.
std::size_t runs_without_failure(double rate, double confidence,
                                 const RateMixture& mixture = few_runs_mixture());

/// The largest rate of failure that these runs do not exclude: above it the wealth of a RateTest
/// with the close_rates_mixture() reaches its target. As valid however often one looks as the test
/// is, so that the number of runs need not be planned. 1 without runs.
double failure_bound(std::size_t runs, std::size_t failures, double confidence);

/// The confidence with which runs of a planned number show that the rate of success is at least
/// `rate` (exact, one-sided; Clopper and Pearson 1934): 0.893 for 10 runs without a failure and a
/// rate of 0.8.
double shown_confidence(std::size_t runs, std::size_t failures, double rate);

/// Tests of several steps, from easy to hard, at one confidence: a step is tested once all before
/// it are reached, and the first that is not ends the sequence. The probability that a step is
/// reached whose rate is at most `rate` is at most 1 - confidence over all steps, because only the
/// first one of these can be tested without such an error (Maurer, Hothorn and Lehmacher 1995).
class FixedSequence {
 public:
  struct Options {
    double rate = 0.95, confidence = 0.95;
    std::size_t steps = 0;
    std::size_t max_per_step = 2000;  ///< runs
    std::size_t budget = 5000;        ///< runs of all steps
  };
  explicit FixedSequence(const Options& options);

  /// A run of a step; ignored unless that is the current step.
  void add(std::size_t step, bool success);

  /// The step that needs runs; none at the end.
  std::optional<std::size_t> current() const;
  std::size_t reached() const { return reached_; }  ///< steps
  std::size_t runs() const { return runs_; }        ///< of all steps
  /// The tests of the steps so far, in order.
  const std::vector<RateTest>& tests() const { return tests_; }

 private:
  Options options_;
  std::vector<RateTest> tests_;
  std::size_t reached_ = 0, runs_ = 0;
};

}  // namespace slalom
