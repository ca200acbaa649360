// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/value.h>
#include <slalom/scenario/world.h>
#include <slalom/trajectory/path.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The name of the exact search among the planners.
constexpr char kExactPlanner[] = "exact";

/// Proven bounds of the length of the shortest path (m), or of the time of the earliest arrival
/// (s): lower_bound <= minimum <= upper_bound. The bounds of a path are equal for a disc that can
/// rotate in place. With a planner whose robot is another one (ReferencePlanner::lower_bound())
/// they are those of its robot.
struct Certificate {
  double lower_bound = 0;
  double upper_bound = 0;  ///< infinite if no path of such a robot was found
  /// Relative, \f$(U - L) / L\f$ of the upper bound U and the lower bound L; 0 where start and goal
  /// coincide.
  double gap() const {
    return upper_bound > lower_bound ? (upper_bound - lower_bound) / lower_bound : 0;
  }
};

/// The shortest path found for a disc robot, free in the model used for collision checking.
struct ShortestPath {
  Path path;
  double length = 0;  ///< m; of the exact path the optimum, which its chords exceed by 1e-6
  Certificate certificate;
  std::string planner;      ///< kExactPlanner, "BITstar", ...
  std::string note;         ///< e.g. why the planner's path was not used
  double exact_length = 0;  ///< m, the optimum of the disc, L* in metrics, whatever the planner
  std::optional<double> planner_length = std::nullopt;  ///< m, of the planner's path, used or not
};

/// The path of maximum bottleneck clearance, and among those the shortest on the Voronoi diagram.
struct SafestPath {
  Path path;
  double bottleneck = 0;  ///< m, smallest d(q) along it
  std::string planner = kExactPlanner;
  std::string note = "";
};

/// A position (m) at a time (s) of a plan; in between the motion is straight at constant speed.
struct TimedPoint {
  double t = 0;
  mrpt::math::TPoint2D position;
};

/// The earliest arrival among moving obstacles, by earliest_arrival().
struct EarliestArrival {
  /// Proven bounds of the time of arrival (s).
  Certificate certificate;
  std::vector<TimedPoint> plan;  ///< that arrives at the upper bound; empty if none was found
};

/// Wall-clock times (s) of reference planning; separate from its deterministic results.
struct ReferenceTiming {
  double exact = 0, planner = 0, safest = 0, arrival = 0;
};

/// Both reference paths of a scenario for one robot, or the reasons why there is none. With moving
/// obstacles also the earliest arrival, or the reason; without them neither.
struct References {
  std::optional<ShortestPath> shortest;
  std::optional<SafestPath> safest;
  std::string shortest_reason, safest_reason;
  ReferenceTiming timing = {};
  std::optional<EarliestArrival> arrival = std::nullopt;
  std::string arrival_reason = "";

  /// Why no robot can solve the scenario, which is proved; empty if that is not known.
  const std::string& unsolvable_reason() const {
    return shortest ? arrival_reason : shortest_reason;
  }
};

/// Keeps lengths, bounds and reasons only.
void remove_paths(References& references);

/// The input of a planner.
struct PlanningProblem {
  const World& world;
  double robot_radius = 0.25;  ///< m, disc
  mrpt::math::TPoint2D start, goal;
  double start_heading = 0;  ///< rad, for planners in SE(2)
  /// All that moves, in the earliest arrival; null: the movers of the scenario.
  const Movers* present = nullptr;

  const Movers& movers() const { return present != nullptr ? *present : world.scenario().movers(); }
};

/// A planner of reference paths of a given quality (the interface to OMPL). It may use the exact
/// references as a termination condition and as an initial solution.
class ReferencePlanner {
 public:
  enum class Objective { Length, Clearance };

  virtual ~ReferencePlanner() = default;
  virtual std::string name() const = 0;
  /// The reference that it plans.
  virtual Objective objective() const { return Objective::Length; }
  /// A proven lower bound (m) of the paths of its robot, if that is not the disc: its paths are
  /// longer because of its turning radius or its polygon. `exact` is the disc's.
  virtual std::optional<double> lower_bound(const PlanningProblem& /*problem*/,
                                            const ShortestPath& /*exact*/) const {
    return std::nullopt;
  }
  /// A free path within the gap of the best (length at most (1 + gap) times the certified lower
  /// bound; bottleneck at least (1 - gap) times the widest), or the best found so far; nullopt if
  /// it found none, for which it may state a reason. `exact` has the reference of its objective.
  virtual std::optional<Path> plan(const PlanningProblem& problem, const References& exact,
                                   std::uint64_t seed, std::string& reason) const = 0;
};
constexpr auto enum_names(ReferencePlanner::Objective) {
  return std::array{"length", "clearance"};
}

/// Smallest d(q) along a path (m).
double bottleneck_of(const World& world, const Path& path);

/// The first point of a path, of points a quarter of a cell apart, with the smallest d(q). Requires
/// a path with points.
mrpt::math::TPoint2D narrowest_place(const World& world, const Path& path);

/// Whether every point of the path has a clearance of at least `radius` (less kContactTolerance).
bool is_free(const World& world, const Path& path, double radius);

/// Computes both references by the exact searches, then queries `planner` unless null: its path is
/// used if it is free and within the gap, otherwise the exact one with a note.
References compute_references(const PlanningProblem& problem, const ReferencePlanner* planner,
                              double gap, std::uint64_t seed);

}  // namespace slalom
