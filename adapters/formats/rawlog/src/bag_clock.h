// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace slalom {

/// Relates the times at which messages were recorded to the clock of their headers: simulated time
/// is another one, and can be faster or slower. Times in ns.
class BagClock {
 public:
  void add(std::int64_t recorded, std::int64_t stamp) { pairs_.emplace_back(recorded, stamp); }

  /// Call once, after all were added.
  void finish();

  /// Whether stamps differ from the times of recording by more than transport can explain.
  bool is_other_clock() const { return is_other_clock_; }

  /// The time on the clock of the headers: interpolated between the messages around it, or the time
  /// itself if that is the same clock.
  std::int64_t stamp_of(std::int64_t recorded) const;

 private:
  std::vector<std::pair<std::int64_t, std::int64_t>> pairs_;  ///< recorded, stamp
  bool is_other_clock_ = false;
};

}  // namespace slalom
