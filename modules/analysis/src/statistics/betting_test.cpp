// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/betting_test.h>
#include <slalom/core/math.h>

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

}  // namespace slalom
