#include "contact.h"

#include <slalom/references/exact_shortest.h>
#include <slalom/references/reference.h>
#include <slalom/references/safest_path.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

/// Uses the planner's path where it keeps its promise; says so where it does not.
void consult(const ReferencePlanner& planner, const PlanningProblem& problem, double gap,
             std::uint64_t seed, ShortestPath& best) {
  const std::optional<Path> path = planner.plan(problem, best, seed);
  if (!path) {
    best.note = planner.name() + " found no path";
  } else if (!is_free(problem.world, *path, problem.robot_radius)) {
    best.note = planner.name() + " gave a path that is not free";
  } else if (length(*path) > (1 + gap) * best.certificate.lower_bound) {
    best.note = fmt::format("{} came to {:.4f} m, not within the gap of {}", planner.name(),
                            length(*path), gap);
  } else {
    best.path = *path;
    best.length = length(*path);
    best.planner = planner.name();
    best.certificate.upper_bound = std::min(best.certificate.upper_bound, best.length);
  }
}

}  // namespace

bool is_free(const World& world, const Path& path, double radius) {
  const DistanceField& field = world.distance_field();
  if (path.size() == 1) return field.clearance(path[0]) >= radius - kContactTolerance;
  for (std::size_t i = 1; i < path.size(); ++i)
    if (field.segment_clearance(path[i - 1], path[i], radius) < radius - kContactTolerance)
      return false;
  return !path.empty();
}

References compute_references(const PlanningProblem& problem, const ReferencePlanner* planner,
                              double gap, std::uint64_t seed) {
  References references;
  references.shortest = exact_shortest_path(problem, gap, references.shortest_reason);
  if (references.shortest && planner != nullptr)
    consult(*planner, problem, gap, seed, *references.shortest);
  references.safest = safest_path(problem, references.safest_reason);
  return references;
}

}  // namespace slalom
