// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

namespace slalom::arrival {

/// A closed interval of times (s).
struct Interval {
  double first = 0, last = 0;
};

/// The parts of [first, last] outside of the open `intervals`, in order. Two intervals that touch
/// leave a moment between them.
inline std::vector<Interval> gaps_between(std::vector<Interval> intervals, double first,
                                          double last) {
  std::sort(intervals.begin(), intervals.end(),
            [](const Interval& a, const Interval& b) { return a.first < b.first; });
  std::vector<Interval> gaps;
  for (const Interval& interval : intervals) {
    if (interval.last < first) continue;
    if (interval.first > last) break;
    if (interval.first >= first) gaps.push_back({first, interval.first});
    first = interval.last;
  }
  if (first <= last) gaps.push_back({first, last});
  return gaps;
}

}  // namespace slalom::arrival
