#include "solvable.h"

#include <slalom/core/error.h>
#include <slalom/references/exact_shortest.h>

#include <fmt/format.h>

#include <map>

namespace slalom {

SolvableWorld SolvableSearch::find(const std::string& name, const Draw& draw,
                                   int first_attempt) const {
  std::map<std::string, int> reasons;
  if (first_attempt > 0) reasons["duplicate of an earlier scenario"] = first_attempt;
  for (int attempt = first_attempt; attempt < settings_.attempts_per_scenario; ++attempt) {
    std::string reason;
    if (std::optional<Scenario> candidate = draw(attempt, reason)) {
      auto world = std::make_unique<const World>(std::move(*candidate), settings_.resolution);
      if (is_certified(*world, reason)) return {std::move(world), attempt};
    }
    ++reasons[reason];
  }
  std::string counts;
  for (const auto& [reason, times] : reasons)
    counts += fmt::format("{}{} times: {}", counts.empty() ? "" : "; ", times, reason);
  throw job_error(name,
                  fmt::format("no solvable scenario for a robot of radius {} m in {} attempts ({})",
                              settings_.robot_radius, settings_.attempts_per_scenario, counts),
                  "fewer or smaller obstacles, or a smaller robot");
}

bool SolvableSearch::is_certified(const World& world, std::string& reason) const {
  constexpr double kAnyGap = 1;  // any path suffices
  const Scenario& candidate = world.scenario();
  const auto& start = candidate.start();
  const PlanningProblem problem{
      world, settings_.robot_radius, {start.x, start.y}, candidate.goal()};
  return exact_shortest_path(problem, kAnyGap, reason).has_value();
}

std::string scenario_name(const std::string& prefix, int index) {
  return fmt::format("{}_{:04}", prefix, index);
}

}  // namespace slalom
