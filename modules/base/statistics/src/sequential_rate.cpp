// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/math.h>
#include <slalom/statistics/distributions.h>
#include <slalom/statistics/sequential_rate.h>

#include <algorithm>
#include <limits>

namespace slalom {

RateMixture few_runs_mixture() {
  return {{0, 0.5}, {0.2, 0.25}, {0.5, 0.25}};
}

RateMixture close_rates_mixture() {
  return {{0, 0.45}, {0.2, 0.2}, {0.5, 0.15}, {0.7, 0.08}, {0.8, 0.05}, {0.9, 0.04}, {0.95, 0.03}};
}

RateTest::RateTest(double rate, double confidence, const RateMixture& mixture)
    : log_target_(-math::log(1 - confidence)), log_futile_(math::log(kFutileWealth)) {
  for (const auto& [part, weight] : mixture) {
    Alternative& alternative = alternatives_.emplace_back();
    alternative.log_weight = math::log(weight);
    alternative.log_success = math::log((1 - part * (1 - rate)) / rate);
    if (part > 0) alternative.log_failure = math::log(part);
  }
}

double RateTest::log_wealth(std::size_t successes, std::size_t failures) const {
  const auto log_ratio = [&](const Alternative& a) {
    const double log = a.log_weight + static_cast<double>(successes) * a.log_success;
    if (failures == 0) return log;
    return a.log_failure ? log + static_cast<double>(failures) * *a.log_failure
                         : -std::numeric_limits<double>::infinity();
  };
  double largest = -std::numeric_limits<double>::infinity(), sum = 0;
  for (const Alternative& a : alternatives_) largest = std::max(largest, log_ratio(a));
  for (const Alternative& a : alternatives_) {
    const double log = log_ratio(a);
    if (log >= largest - 700) sum += math::exp(log - largest);
  }
  return largest + math::log(sum);
}

void RateTest::add(bool success) {
  if (reached_ || futile_) return;
  ++(success ? successes_ : failures_);
  const double wealth = log_wealth(successes_, failures_);
  reached_ = wealth >= log_target_;
  futile_ = runs() >= kMinFutileRuns && wealth < log_futile_;
}

std::size_t runs_without_failure(double rate, double confidence, const RateMixture& mixture) {
  const RateTest test(rate, confidence, mixture);
  const auto suffices = [&](std::size_t runs) {
    return test.log_wealth(runs, 0) >= test.log_target();
  };
  std::size_t low = 0, high = 1;
  while (!suffices(high)) high *= 2;
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (suffices(middle) ? high : low) = middle;
  }
  return high;
}

double failure_bound(std::size_t runs, std::size_t failures, double confidence) {
  const RateMixture mixture = close_rates_mixture();
  double low = runs == 0 ? 1 : static_cast<double>(failures) / static_cast<double>(runs), high = 1;
  // Bisection: the wealth grows with the rate of failure that is tested.
  while (high - low > 1e-12 * high) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) break;
    const RateTest test(1 - middle, confidence, mixture);
    (test.log_wealth(runs - failures, failures) >= test.log_target() ? high : low) = middle;
  }
  return high;
}

double shown_confidence(std::size_t runs, std::size_t failures, double rate) {
  if (failures >= runs) return 0;
  return distributions::binomial_survival(static_cast<double>(failures), static_cast<double>(runs),
                                          1 - rate);
}

FixedSequence::FixedSequence(const Options& options) : options_(options) {
  if (options_.steps > 0) tests_.emplace_back(options_.rate, options_.confidence);
}

std::optional<std::size_t> FixedSequence::current() const {
  if (reached_ >= tests_.size() || runs_ >= options_.budget) return std::nullopt;
  const RateTest& test = tests_.back();
  if (test.futile() || test.runs() >= options_.max_per_step) return std::nullopt;
  return reached_;
}

void FixedSequence::add(std::size_t step, bool success) {
  if (current() != step) return;
  RateTest& test = tests_.back();
  test.add(success);
  ++runs_;
  if (!test.reached()) return;
  ++reached_;
  if (reached_ < options_.steps) tests_.emplace_back(options_.rate, options_.confidence);
}

}  // namespace slalom
