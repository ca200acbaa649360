// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/math.h>
#include <slalom/statistics/betting.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slalom {

namespace {

/// Constant stakes, as parts of the one that could lose all.
const std::array<double, BettingTest::kStakes>& constant_stakes() {
  static const auto stakes = [] {
    std::array<double, BettingTest::kStakes> values;
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = math::sin(M_PI / 2 * (static_cast<double>(i) + 0.5) / BettingTest::kStakes);
    return values;
  }();
  return stakes;
}

}  // namespace

BettingTest::BettingTest(double null, double effect, double bound, std::size_t population)
    : null_(null),
      effect_(effect),
      bound_(bound),
      population_(static_cast<double>(population)),
      squares_(kPriorValues * bound * bound / 4) {
  shares_.fill(0.5 / kStakes);
}

bool BettingTest::is_possible() const {
  const double left = (population_ - values_) * bound_, sum = population_ * null_;
  const double rounding = 1e-9 * (1 + population_) * bound_;
  return effect_ > 0 ? sum_ - left <= sum + rounding : sum_ + left >= sum - rounding;
}

void BettingTest::add(double value) {
  const double null =
      population_ > 0 ? (population_ * null_ - sum_) / (population_ - values_) : null_;
  const double gain = effect_ > 0 ? value - null : null - value, most = bound_ + std::abs(null),
               part = gain / most, kelly = std::abs(effect_) * (kPriorValues + values_) / squares_,
               of_effect = std::min(kelly, 0.5 / most) * gain;
  const auto& stakes = constant_stakes();
  double growth = of_effect_ * of_effect;  // of the whole wealth
  for (std::size_t i = 0; i < kStakes; ++i) growth += shares_[i] * stakes[i] * part;
  of_effect_ *= (1 + of_effect) / (1 + growth);
  for (std::size_t i = 0; i < kStakes; ++i) shares_[i] *= (1 + stakes[i] * part) / (1 + growth);
  squares_ += gain * gain;
  sum_ += value;
  ++values_;
  log_wealth_ += std::log1p(growth);
  if (population_ > 0 && !is_possible()) log_wealth_ = std::numeric_limits<double>::infinity();
  log_evidence_ = std::max(log_evidence_, log_wealth_);
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
