#pragma once

#include <slalom/core/value.h>
#include <slalom/scenario/world.h>
#include <slalom/trajectory/path.h>

#include <cstdint>
#include <optional>
#include <string>

namespace slalom {

/// Proof about the shortest path: lower_bound <= L* <= upper_bound (m).
struct Certificate {
  double lower_bound = 0;
  double upper_bound = 0;
  double gap() const { return (upper_bound - lower_bound) / lower_bound; }  ///< relative
};

/// The shortest path that was found for a disc robot, free in the model in which collisions are
/// judged.
struct ShortestPath {
  Path path;
  double length = 0;        ///< m, >= certificate.lower_bound
  Certificate certificate;  ///< upper_bound is the length of the best path known
  std::string planner;      ///< who found it: "exact", "BITstar", ...
  std::string note;         ///< e.g. why the named planner's path was not used
  double exact_length = 0;  ///< m, of the exact search's path, the same whichever planner is asked
  std::optional<double> planner_length = std::nullopt;  ///< m, of the planner's, used or not
};

/// The path of largest bottleneck clearance, then shortest on the Voronoi diagram.
struct SafestPath {
  Path path;
  double bottleneck = 0;  ///< m, smallest d(q) along it
  std::string planner = "exact";
  std::string note = "";
};

/// Wall-clock times (s) of finding references; kept apart from what is found.
struct ReferenceTiming {
  double exact = 0, planner = 0, safest = 0;
};

/// Both reference paths of a scenario for one robot; where there is none, the reason.
struct References {
  std::optional<ShortestPath> shortest;
  std::optional<SafestPath> safest;
  std::string shortest_reason, safest_reason;
  ReferenceTiming timing = {};
};

/// What a planner may use.
struct PlanningProblem {
  const World& world;
  double robot_radius = 0.25;  ///< m, disc
  mrpt::math::TPoint2D start, goal;
  double start_heading = 0;  ///< rad, for planners among poses
};

/// Finds a reference path when it is told how good it must be (the seam for OMPL). It may use the
/// exact references: to know when to stop, and as a first solution.
class ReferencePlanner {
 public:
  enum class Objective { Length, Clearance };

  virtual ~ReferencePlanner() = default;
  virtual std::string name() const = 0;
  /// Which of the two references it is asked for.
  virtual Objective objective() const { return Objective::Length; }
  /// A free path within the gap of the best (length at most (1 + gap) times the certified lower
  /// bound; bottleneck at least (1 - gap) times the widest), or the best found when it gives up;
  /// nullopt when it found none. `exact` has the reference of its objective.
  virtual std::optional<Path> plan(const PlanningProblem& problem, const References& exact,
                                   std::uint64_t seed) const = 0;
};

/// Smallest d(q) along a path (m).
double bottleneck_of(const World& world, const Path& path);

/// Whether every point of the path keeps at least `radius` (less 1e-9 m) from what is occupied.
bool is_free(const World& world, const Path& path, double radius);

/// Both references by the exact searches, then `planner` if there is one: its path is used when it
/// is free and within the gap, otherwise the exact one with a note.
References compute_references(const PlanningProblem& problem, const ReferencePlanner* planner,
                              double gap, std::uint64_t seed);

}  // namespace slalom
