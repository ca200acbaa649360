// SPDX-License-Identifier: BSD-3-Clause
#include "bag_clock.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slalom {
namespace {

/// Exact also for times of which a double has no single nanoseconds, and without overflow.
double difference(std::int64_t a, std::int64_t b) {
  return static_cast<double>(
      static_cast<std::int64_t>(static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b)));
}

}  // namespace

void BagClock::finish() {
  std::sort(pairs_.begin(), pairs_.end());
  std::vector<double> shifts;
  for (const auto& [recorded, stamp] : pairs_)
    shifts.push_back(std::abs(difference(recorded, stamp)));
  if (shifts.empty()) return;
  const auto middle = shifts.begin() + static_cast<std::ptrdiff_t>(shifts.size() / 2);
  std::nth_element(shifts.begin(), middle, shifts.end());
  constexpr double kMaxTransport = 1e9;  // ns
  is_other_clock_ = *middle > kMaxTransport;
}

std::int64_t BagClock::stamp_of(std::int64_t recorded) const {
  if (!is_other_clock_) return recorded;
  const auto after = std::upper_bound(
      pairs_.begin(), pairs_.end(), std::pair(recorded, std::numeric_limits<std::int64_t>::max()));
  const auto& [time, stamp] = after == pairs_.begin() ? *after : *(after - 1);
  double rate = 1;
  if (after != pairs_.begin() && after != pairs_.end() && after->first > time)
    rate = difference(after->second, stamp) / difference(after->first, time);
  constexpr double kCentury = 3e18;  // ns; beyond, times are damaged
  return stamp + std::llround(std::clamp(rate * difference(recorded, time), -kCentury, kCentury));
}

}  // namespace slalom
