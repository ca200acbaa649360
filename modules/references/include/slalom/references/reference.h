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
};

/// The path of largest bottleneck clearance, then shortest on the Voronoi diagram.
struct SafestPath {
  Path path;
  double bottleneck = 0;  ///< m, smallest d(q) along it
};

/// Both reference paths of a scenario for one robot; where there is none, the reason.
struct References {
  std::optional<ShortestPath> shortest;
  std::optional<SafestPath> safest;
  std::string shortest_reason, safest_reason;
};

/// What a planner may use.
struct PlanningProblem {
  const World& world;
  double robot_radius = 0.25;  ///< m, disc
  mrpt::math::TPoint2D start, goal;
};

/// Finds a shortest path when it is told how good it must be (the seam for OMPL). It may use the
/// exact path and its certificate: to know when to stop, and as a first solution.
class ReferencePlanner {
 public:
  virtual ~ReferencePlanner() = default;
  virtual std::string name() const = 0;
  /// A free path whose length is at most (1 + gap) certificate.lower_bound, or the best found when
  /// it gives up; nullopt when it found none.
  virtual std::optional<Path> plan(const PlanningProblem& problem, const ShortestPath& exact,
                                   std::uint64_t seed) const = 0;
};

/// Whether every point of the path keeps at least `radius` (less 1e-9 m) from what is occupied.
bool is_free(const World& world, const Path& path, double radius);

/// Both references: the exact search, then `planner` if there is one (its path is used when it is
/// free and not longer than (1 + gap) times the lower bound, otherwise the exact one with a note),
/// and the safest path.
References compute_references(const PlanningProblem& problem, const ReferencePlanner* planner,
                              double gap, std::uint64_t seed);

}  // namespace slalom
