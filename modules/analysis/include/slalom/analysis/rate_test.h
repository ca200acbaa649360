// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace slalom {

/// A test of "the rate of success is at most `rate`" that is valid however often one looks. Its
/// wealth is a mixture of three likelihood ratios against that rate, 1 at first: a nonnegative
/// martingale at the rate, a supermartingale below it, so that it ever reaches 1 / (1 - confidence)
/// with a probability of at most 1 - confidence (Ville 1939). The alternatives are rates of
/// failure of 0, 0.2 and 0.5 times 1 - rate, with the weights 1/2, 1/4 and 1/4.
///
/// Runs after the decision do not count: batches of any size give the same decision.
class RateTest {
 public:
  /// Requires both in (0, 1).
  RateTest(double rate, double confidence);

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
  std::array<Alternative, 3> alternatives_;
  double log_target_, log_futile_;
  std::size_t successes_ = 0, failures_ = 0;
  bool reached_ = false, futile_ = false;
};

/// The smallest number of runs with which a RateTest is reached, which is without a failure.
std::size_t runs_without_failure(double rate, double confidence);

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
