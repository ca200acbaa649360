// SPDX-License-Identifier: BSD-3-Clause
#include "wall_time.h"

#include <slalom/core/math.h>
#include <slalom/references/exact_shortest.h>
#include <slalom/references/reference.h>
#include <slalom/references/safest_path.h>
#include <slalom/scenario/contact.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slalom {
namespace {

/// Why a planner's path is invalid; empty if it is valid.
std::string defect_of(const std::optional<Path>& path, const std::string& reason,
                      const PlanningProblem& problem) {
  if (!path) return "found no path" + (reason.empty() ? "" : ": " + reason);
  if (!is_free(problem.world, *path, problem.robot_radius))
    return "returned a path that is not free";
  return "";
}

/// Uses the planner's path if it is valid and within the gap; otherwise adds a note.
void use_shortest(const ReferencePlanner& planner, const std::optional<Path>& path,
                  const std::string& defect, double gap, ShortestPath& best) {
  if (!defect.empty()) {
    best.note = planner.name() + " " + defect;
    return;
  }
  const double path_length = length(*path);
  best.planner_length = path_length;
  // Chords along the arcs of a car are shorter than these by about 1e-6.
  best.certificate.upper_bound =
      std::max(best.certificate.lower_bound, std::min(best.certificate.upper_bound, path_length));
  if (path_length > (1 + gap) * best.certificate.lower_bound) {
    best.note = fmt::format("{} found {:.4f} m, not within the gap of {}", planner.name(),
                            path_length, gap);
    return;
  }
  best.path = *path;
  best.length = path_length;
  best.planner = planner.name();
}

/// Bounds of the robot for which the planner plans, if it is not the disc: the disc's path is none
/// of its paths.
void use_bounds_of_robot(const ReferencePlanner& planner, const PlanningProblem& problem,
                         ShortestPath& best) {
  const std::optional<double> lower = planner.lower_bound(problem, best);
  if (lower) best.certificate = {*lower, std::numeric_limits<double>::infinity()};
}

void use_safest(const ReferencePlanner& planner, const PlanningProblem& problem,
                const std::optional<Path>& path, const std::string& defect, double gap,
                SafestPath& best) {
  const double width = defect.empty() ? bottleneck_of(problem.world, *path) : 0;
  if (!defect.empty()) {
    best.note = planner.name() + " " + defect;
  } else if (width < (1 - gap) * best.bottleneck) {
    best.note = fmt::format("{} found a bottleneck of {:.4f} m, not within the gap of {}",
                            planner.name(), width, gap);
  } else {
    best = {*path, width, planner.name(), ""};
  }
}

void query_planner(const ReferencePlanner& planner, const PlanningProblem& problem, double gap,
                   std::uint64_t seed, References& references) {
  const bool shortest = planner.objective() == ReferencePlanner::Objective::Length;
  if (shortest ? !references.shortest : !references.safest) return;
  if (shortest) use_bounds_of_robot(planner, problem, *references.shortest);
  std::string reason;
  const std::optional<Path> path = planner.plan(problem, references, seed, reason);
  const std::string defect = defect_of(path, reason, problem);
  if (shortest)
    use_shortest(planner, path, defect, gap, *references.shortest);
  else
    use_safest(planner, problem, path, defect, gap, *references.safest);
}

}  // namespace

void remove_paths(References& references) {
  if (references.shortest) references.shortest->path.clear();
  if (references.safest) references.safest->path.clear();
  if (references.arrival) references.arrival->plan.clear();
}

bool is_free(const World& world, const Path& path, double radius) {
  const DistanceField& field = world.distance_field();
  if (path.size() == 1) return field.clearance(path[0]) >= radius - kContactTolerance;
  for (std::size_t i = 1; i < path.size(); ++i)
    if (field.segment_clearance(path[i - 1], path[i], radius) < radius - kContactTolerance)
      return false;
  return !path.empty();
}

double bottleneck_of(const World& world, const Path& path) {
  const DistanceField& field = world.distance_field();
  double width = path.empty() ? 0 : field.clearance(path.front());
  for (std::size_t i = 1; i < path.size(); ++i)
    width = field.segment_clearance(path[i - 1], path[i], width);
  return width;
}

mrpt::math::TPoint2D narrowest_place(const World& world, const Path& path) {
  const DistanceField& field = world.distance_field();
  const double step = world.occupancy().resolution() / 4;
  mrpt::math::TPoint2D narrowest = path.front();
  double least = field.clearance(narrowest);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const mrpt::math::TPoint2D &from = path[i - 1], &to = path[i];
    const int steps = static_cast<int>(std::ceil(math::hypot(to.x - from.x, to.y - from.y) / step));
    for (int k = 1; k <= steps; ++k) {
      const double part = static_cast<double>(k) / steps;
      const mrpt::math::TPoint2D at(from.x + part * (to.x - from.x),
                                    from.y + part * (to.y - from.y));
      const double clearance = field.clearance(at);
      if (clearance < least) least = clearance, narrowest = at;
    }
  }
  return narrowest;
}

References compute_references(const PlanningProblem& problem, const ReferencePlanner* planner,
                              double gap, std::uint64_t seed) {
  References references;
  references.timing.exact = wall_time_of(
      [&] { references.shortest = exact_shortest_path(problem, references.shortest_reason); });
  references.timing.safest =
      wall_time_of([&] { references.safest = safest_path(problem, references.safest_reason); });
  if (planner != nullptr)
    references.timing.planner =
        wall_time_of([&] { query_planner(*planner, problem, gap, seed, references); });
  return references;
}

}  // namespace slalom
