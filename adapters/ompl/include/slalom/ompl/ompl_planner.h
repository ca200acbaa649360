#pragma once

#include <slalom/core/options.h>
#include <slalom/references/reference.h>

#include <memory>
#include <string>

namespace slalom {

/// Section [reference].
struct OmplOptions {
  std::string planner = "InformedRRTstar";  ///< or exact: the exact search alone
  double gap = 0.01;                        ///< relative to the certified lower bound
  int max_iterations = 20000;               ///< of the planner, after which it gives up
  double max_time = 10;  ///< s, a guard: a planner stopped by it is noted, not repeatable

  void visit(OptionVisitor& v);
};

/// OMPL's planner of that name on R^2 for the disc robot: states and motions are tested exactly
/// against the occupancy, the objective is path length, it stops when its path is within the gap of
/// the certified lower bound. Null for "exact". Repeatable when each plan() is called in a process
/// that has not used OMPL before: its random generators are seeded once per process.
std::unique_ptr<ReferencePlanner> make_ompl_planner(const OmplOptions& options);

std::string ompl_version();

}  // namespace slalom
