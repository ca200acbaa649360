// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/rate_test.h>
#include <slalom/core/math.h>

#include <algorithm>
#include <limits>

namespace slalom {

RateTest::RateTest(double rate, double confidence)
    : log_target_(-math::log(1 - confidence)), log_futile_(math::log(kFutileWealth)) {
  constexpr double kFailures[] = {0, 0.2, 0.5}, kWeights[] = {0.5, 0.25, 0.25};
  for (std::size_t i = 0; i < alternatives_.size(); ++i) {
    Alternative& alternative = alternatives_[i];
    alternative.log_weight = math::log(kWeights[i]);
    alternative.log_success = math::log((1 - kFailures[i] * (1 - rate)) / rate);
    if (kFailures[i] > 0) alternative.log_failure = math::log(kFailures[i]);
  }
}

double RateTest::log_wealth(std::size_t successes, std::size_t failures) const {
  std::array<double, 3> logs;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    const Alternative& a = alternatives_[i];
    logs[i] = a.log_weight + static_cast<double>(successes) * a.log_success;
    if (failures == 0) continue;
    logs[i] = a.log_failure ? logs[i] + static_cast<double>(failures) * *a.log_failure
                            : -std::numeric_limits<double>::infinity();
  }
  const double largest = *std::max_element(logs.begin(), logs.end());
  double sum = 0;
  for (const double log : logs)
    if (log >= largest - 700) sum += math::exp(log - largest);
  return largest + math::log(sum);
}

void RateTest::add(bool success) {
  if (reached_ || futile_) return;
  ++(success ? successes_ : failures_);
  const double wealth = log_wealth(successes_, failures_);
  reached_ = wealth >= log_target_;
  futile_ = runs() >= kMinFutileRuns && wealth < log_futile_;
}

std::size_t runs_without_failure(double rate, double confidence) {
  const RateTest test(rate, confidence);
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
