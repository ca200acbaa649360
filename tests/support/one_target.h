// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hwy/targets.h>

#include <cstdint>

namespace slalom::testing {

/// Restricts Highway to one instruction set.
class OneTarget {
 public:
  explicit OneTarget(std::int64_t target) { select(target); }
  ~OneTarget() { select(0); }
  OneTarget(const OneTarget&) = delete;
  OneTarget& operator=(const OneTarget&) = delete;

 private:
  static void select(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

}  // namespace slalom::testing
