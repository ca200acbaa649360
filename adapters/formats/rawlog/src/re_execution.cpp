// SPDX-License-Identifier: BSD-3-Clause
#include "rawlog_format.h"

#include <slalom/core/error.h>
#include <slalom/core/hash.h>
#include <slalom/core/text.h>
#include <slalom/rawlog/re_execution.h>

namespace slalom {
namespace {

/// "recorded v = 0.5, replayed v = 0.4", or "".
std::string difference(const char* name, double recorded, double replayed) {
  if (same_bits(recorded, replayed)) return "";
  const std::string label = std::string(name) + " = ";
  return "recorded " + label + format_numbers({recorded}) + ", replayed " + label +
         format_numbers({replayed});
}

std::string difference(const Command& recorded, const Command& replayed) {
  std::vector<std::string> parts;
  for (const std::string& part :
       {difference("v", recorded.v, replayed.v), difference("w", recorded.w, replayed.w),
        difference("vy", recorded.vy, replayed.vy)})
    if (!part.empty()) parts.push_back(part);
  return join(parts, "; ");
}

void set_clock(mrpt::Clock::time_point time) {
  mrpt::Clock::setActiveClock(mrpt::Clock::Simulated);
  mrpt::Clock::setSimulatedTime(time);
}

}  // namespace

std::optional<std::string> first_difference(const RecordedRun& run, Method& method) {
  if (!run.task) return std::nullopt;
  std::string where = "before the first cycle";
  try {
    set_clock(logged_start());
    method.reset(*run.task);
    for (std::size_t i = 0; i < run.cycles.size(); ++i) {
      const RecordedCycle& cycle = run.cycles[i];
      where =
          "cycle " + std::to_string(i + 1) + " (" + format_fixed(cycle.observation.time, 2) + " s)";
      set_clock(cycle.stamp);
      if (i == 0) method.settle(cycle.observation);
      const std::string found = difference(cycle.command, method.step(cycle.observation));
      if (!found.empty()) return where + ": " + found;
    }
  } catch (const std::exception& error) {
    return where + ": the method failed (" + reason_of(error) + ")";
  }
  return std::nullopt;
}

}  // namespace slalom
