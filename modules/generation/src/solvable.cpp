#include "solvable.h"

#include <slalom/core/error.h>
#include <slalom/references/exact_shortest.h>

#include <fmt/format.h>

namespace slalom {

Scenario SolvableSearch::find(const std::string& name, const Draw& draw) {
  std::map<std::string, int> reasons;
  for (int attempt = 0; attempt < task_.attempts_per_scenario; ++attempt) {
    std::string reason;
    const std::optional<Scenario> candidate = draw(attempt, reason);
    if (candidate && is_certified(*candidate, reason)) {
      if (hashes_.insert(candidate->hash()).second) return *candidate;
      reason = "the same content was drawn before";
    }
    ++reasons[reason];
  }
  std::string why;
  for (const auto& [reason, times] : reasons)
    why += fmt::format("{}{} times: {}", why.empty() ? "" : "; ", times, reason);
  throw job_error(name,
                  fmt::format("no solvable scenario for a robot of radius {} m in {} attempts ({})",
                              task_.robot_radius, task_.attempts_per_scenario, why),
                  "fewer or smaller obstacles, or a smaller robot");
}

std::string SolvableSearch::name_of(int index) const {
  return fmt::format("{}_{:04}", task_.name_prefix, index);
}

bool SolvableSearch::is_certified(const Scenario& candidate, std::string& reason) const {
  const World world(candidate, task_.resolution);
  constexpr double kAnyGap = 1;  // that there is a path is enough here
  const auto& start = candidate.start();
  const PlanningProblem problem{world, task_.robot_radius, {start.x, start.y}, candidate.goal()};
  return exact_shortest_path(problem, kAnyGap, reason).has_value();
}

}  // namespace slalom
