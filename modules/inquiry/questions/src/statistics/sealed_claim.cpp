// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/inquiry/sealed_claim.h>
#include <slalom/statistics/paired_rates.h>

#include <algorithm>
#include <string>

namespace slalom {
namespace {

void require(bool valid, const std::string& key, double value, const std::string& expected) {
  if (!valid) throw usage_error("SealedClaim." + key, format_number(value), expected);
}

void check_scenarios(std::size_t count) {
  require(count >= 1 && count <= SealedClaim::kMaxSealed, "max_scenarios",
          static_cast<double>(count), "1 to " + std::to_string(SealedClaim::kMaxSealed));
}

}  // namespace

RateEstimate betting_estimate(const std::vector<double>& values, double low, double effect,
                              double confidence) {
  const double value = mean(values);
  const Interval interval = betting_interval(values, low, 1, effect, confidence);
  return {value, {std::min(interval.low, value), std::max(interval.high, value)}};
}

SealedClaim::SealedClaim(const SealedOptions& options)
    : options_(options), test_(0, options.effect, 1) {
  require(options.effect > 0 && options.effect <= 1, "effect", options.effect, "in (0, 1]");
  require(options.confidence > 0 && options.confidence < 1, "confidence", options.confidence,
          "in (0, 1)");
  require(options.batch >= 1, "batch", static_cast<double>(options.batch), "at least 1");
  check_scenarios(options.max_scenarios);
}

void SealedClaim::extend(std::size_t max_scenarios) {
  check_scenarios(max_scenarios);
  options_.max_scenarios = std::max(options_.max_scenarios, max_scenarios);
}

std::size_t SealedClaim::next() const {
  if (verdict_ == TuneVerdict::Better) return 0;
  const std::size_t in_batch = options_.batch - scenarios() % options_.batch;
  return std::min(in_batch, options_.max_scenarios - scenarios());
}

void SealedClaim::add(bool tuned, bool reference) {
  if (next() == 0) return;
  tuned_.push_back(tuned ? 1 : 0);
  reference_.push_back(reference ? 1 : 0);
  test_.add(tuned_.back() - reference_.back());
  const std::size_t n = scenarios();
  const bool look =
      n == options_.max_scenarios || (n >= options_.min_scenarios && n % options_.batch == 0);
  if (look && p() <= test_level(options_.confidence) && mean(tuned_) > mean(reference_))
    verdict_ = TuneVerdict::Better;
}

RateEstimate SealedClaim::estimate(const std::vector<double>& values, double low) const {
  return betting_estimate(values, low, options_.effect, options_.confidence);
}

std::vector<double> SealedClaim::differences() const {
  std::vector<double> values;
  for (std::size_t i = 0; i < scenarios(); ++i) values.push_back(tuned_[i] - reference_[i]);
  return values;
}

RateEstimate SealedClaim::difference() const {
  return estimate(differences(), -1);
}

RateEstimate SealedClaim::optimism(const TuneCounts& finals) const {
  const double rate = mean(tuned_);
  return {finals.rate() - rate,
          rate_difference_interval(finals.rate(), static_cast<double>(finals.runs), rate,
                                   static_cast<double>(scenarios()), 0, options_.confidence)};
}

}  // namespace slalom
