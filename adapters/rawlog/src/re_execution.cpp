#include "rawlog_format.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/rawlog/re_execution.h>

#include <cstring>

namespace slalom {
namespace {

bool same_bits(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

/// "v = 0.5 was recorded, 0.4 is answered", or nothing.
std::string difference(const char* name, double recorded, double answered) {
  if (same_bits(recorded, answered)) return "";
  return std::string(name) + " = " + format_numbers({recorded}) + " was recorded, " +
         format_numbers({answered}) + " is answered";
}

std::string difference(const Command& recorded, const Command& answered) {
  std::vector<std::string> parts;
  for (const std::string& part :
       {difference("v", recorded.v, answered.v), difference("w", recorded.w, answered.w),
        difference("vy", recorded.vy, answered.vy)})
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
      const std::string found = difference(cycle.command, method.step(cycle.observation));
      if (!found.empty()) return where + ": " + found;
    }
  } catch (const std::exception& error) {
    return where + ": the method fails (" + reason_of(error) + ")";
  }
  return std::nullopt;
}

}  // namespace slalom
