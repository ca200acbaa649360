// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/math.h>
#include <slalom/statistics/betting.h>

#include <algorithm>
#include <cmath>

namespace slalom {

BettingTest::BettingTest(double null, double effect, double bound)
    : null_(null),
      effect_(effect),
      bound_(bound + std::abs(null)),
      squares_(kPriorValues * bound * bound / 4) {}

void BettingTest::add(double value) {
  const double gain = effect_ > 0 ? value - null_ : null_ - value;
  const double stake = std::min(std::abs(effect_) * values_ / squares_, 0.5 / bound_);
  log_wealth_ += std::log1p(stake * gain);
  log_evidence_ = std::max(log_evidence_, log_wealth_);
  squares_ += gain * gain;
  ++values_;
}

double BettingTest::p() const {
  return math::exp(-log_evidence_);
}

Interval betting_interval(const std::vector<double>& values, double low, double high, double effect,
                          double confidence) {
  const double middle = (low + high) / 2;
  const auto rejected = [&](double mean, double direction) {
    BettingTest test(mean - middle, direction * effect, (high - low) / 2);
    for (const double value : values) test.add(value - middle);
    return test.p() <= test_level(confidence) / 2;
  };
  Interval above = {low, high}, below = {low, high};  // hold the lower and the upper bound
  for (int i = 0; i < 14; ++i) {
    const double lower = (above.low + above.high) / 2, upper = (below.low + below.high) / 2;
    (rejected(lower, 1) ? above.low : above.high) = lower;
    (rejected(upper, -1) ? below.high : below.low) = upper;
  }
  return {above.low, below.high};
}

}  // namespace slalom
