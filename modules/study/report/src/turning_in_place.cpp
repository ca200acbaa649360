// SPDX-License-Identifier: BSD-3-Clause
#include "turning_in_place.h"

#include <slalom/trajectory/end_motion.h>

namespace slalom {
namespace {

constexpr std::size_t kFewest = 3;

}  // namespace

void TurningInPlace::add(std::size_t method, const RunRecord& run, const Trajectory& trajectory) {
  const auto outcome = from_name<Outcome>(run.outcome);
  if (!outcome || outcome == Outcome::Success) return;
  ++failures_[method];
  if (!trajectory.samples.empty() &&
      end_motion(*outcome, trajectory, radius_, max_v_) == EndMotion::Turning)
    ++turning_[method];
}

std::string TurningInPlace::line_of(std::size_t method) const {
  const std::size_t turning = turning_[method], failures = failures_[method];
  if (turning < kFewest || 2 * turning < failures) return "";
  return "turns in place at the end of " + std::to_string(turning) + " of " +
         std::to_string(failures) + " failures: does it see what it turns to?";
}

}  // namespace slalom
