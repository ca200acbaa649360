// SPDX-License-Identifier: BSD-3-Clause
#include "planning_space.h"
#include "pose_roadmap.h"
#include "pose_smoothing.h"

#include <slalom/ompl/ompl_planner.h>
#include <slalom/references/footprint_path.h>
#include <slalom/references/turning_bound.h>

#include <fmt/format.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/config.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
#include <ompl/geometric/planners/informedtrees/AITstar.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <chrono>
#include <functional>
#include <map>

namespace slalom {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

/// The planner of poses where none is named and the lattice does not serve.
constexpr char kPosePlanner[] = "RRTstar";

using PlannerMaker = std::function<ob::PlannerPtr(const ob::SpaceInformationPtr&)>;

template <typename Planner>
ob::PlannerPtr make(const ob::SpaceInformationPtr& space) {
  return std::make_shared<Planner>(space);
}

/// Makers of the planners in kOmplPlanners.
const std::map<std::string, PlannerMaker>& planners() {
  static const std::map<std::string, PlannerMaker> makers = {
      {"ABITstar", make<og::ABITstar>},
      {"AITstar", make<og::AITstar>},
      {"BITstar", make<og::BITstar>},
      {"FMT", make<og::FMT>},
      {"InformedRRTstar", make<og::InformedRRTstar>},
      {"PRMstar", make<og::PRMstar>},
      {"RRTstar", make<og::RRTstar>},
  };
  return makers;
}

/// For clearance the cost is the bottleneck of a path, which is maximized.
ob::OptimizationObjectivePtr make_objective(const PlanningSpace& space, const OmplOptions& options,
                                            const References& exact) {
  ob::OptimizationObjectivePtr objective;
  if (options.objective == ReferencePlanner::Objective::Clearance) {
    objective = std::make_shared<ob::MaximizeMinClearanceObjective>(space.information);
    objective->setCostThreshold(ob::Cost((1 - options.gap) * exact.safest->bottleneck));
  } else {
    objective = std::make_shared<ob::PathLengthOptimizationObjective>(space.information);
    objective->setCostThreshold(
        ob::Cost((1 + options.gap) * exact.shortest->certificate.lower_bound));
  }
  return objective;
}

/// Limits the number of evaluations of the condition, so that the same seed gives the same path on
/// any machine; the time limit is only a safeguard.
ob::PlannerTerminationCondition make_termination_condition(int iterations, double max_time) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(max_time);
  auto evaluations = std::make_shared<int>(0);
  return ob::PlannerTerminationCondition([evaluations, deadline, iterations] {
    return ++*evaluations > iterations || std::chrono::steady_clock::now() > deadline;
  });
}

/// The planner's exact solution in a space; null if it has none.
ob::PathPtr solve(const PlanningSpace& space, const ob::OptimizationObjectivePtr& objective,
                  const std::string& planner_name, const ob::PlannerTerminationCondition& stop) {
  const auto definition = std::make_shared<ob::ProblemDefinition>(space.information);
  ob::ScopedState<> start(space.information);
  space.set_start(start.get());
  if (!space.information->isValid(start.get())) return nullptr;
  definition->addStartState(start);
  definition->setGoal(space.goal);
  definition->setOptimizationObjective(objective);
  const ob::PlannerPtr planner = planners().at(planner_name)(space.information);
  planner->setProblemDefinition(definition);
  planner->setup();
  planner->solve(stop);
  return definition->hasExactSolution() ? definition->getSolutionPath() : nullptr;
}

void prepare_ompl(std::uint64_t seed) {
  ompl::msg::noOutputHandler();
  // OMPL seeds have 32 bits, and 0 means a seed from the clock.
  ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed % 0xfffffffeU) + 1);
}

/// For a disc that can rotate in place.
class OmplPlanner : public ReferencePlanner {
 public:
  explicit OmplPlanner(OmplOptions options) : options_(std::move(options)) {}

  std::string name() const override { return options_.planner; }
  Objective objective() const override { return options_.objective; }

  std::optional<Path> plan(const PlanningProblem& problem, const References& exact,
                           std::uint64_t seed, std::string& /*reason*/) const override {
    prepare_ompl(seed);
    const PlanningSpace space = make_point_space(problem);
    const ob::PathPtr path =
        solve(space, make_objective(space, options_, exact), options_.planner,
              make_termination_condition(options_.max_iterations, options_.max_time));
    if (!path) return std::nullopt;
    return space.to_path(path);
  }

 private:
  OmplOptions options_;
};

/// For robots whose heading matters: of polygons that turn in place find_footprint_path(); if that
/// is not within the gap, from the roadmap along exact shortest paths of discs; then by OMPL, which
/// polygons need for clearance, or if a planner is named. All are smoothed.
class PosePlanner : public ReferencePlanner {
 public:
  PosePlanner(OmplOptions options, RobotModel robot)
      : options_(std::move(options)), robot_(std::move(robot)) {
    is_sampled_ = options_.planner != kExactPlanner || robot_.min_turning_radius > 0 ||
                  options_.objective == Objective::Clearance;
    if (options_.planner == kExactPlanner) options_.planner = kPosePlanner;
  }

  std::string name() const override { return is_sampled_ ? options_.planner : "lattice"; }
  Objective objective() const override { return options_.objective; }

  std::optional<double> lower_bound(const PlanningProblem& problem,
                                    const ShortestPath& exact) const override {
    if (robot_.min_turning_radius == 0) return exact.certificate.lower_bound;
    return turning_lower_bound(problem, exact, robot_.min_turning_radius, !robot_.forward_only);
  }

  std::optional<Path> plan(const PlanningProblem& problem, const References& exact,
                           std::uint64_t seed, std::string& reason) const override {
    const auto motions = make_pose_motions(problem.world, robot_);
    std::vector<TPose2D> poses;
    if (options_.objective == Objective::Length) {
      const double enough = (1 + options_.gap) * exact.shortest->certificate.lower_bound;
      const auto is_enough = [&] { return !poses.empty() && length(*motions, poses) <= enough; };
      const auto improve = [&](std::vector<TPose2D> others) {
        others = smooth(*motions, std::move(others));
        if (poses.empty() ||
            (!others.empty() && length(*motions, others) < length(*motions, poses)))
          poses = std::move(others);
      };
      if (robot_.min_turning_radius == 0) improve(path_on_lattice(problem, reason));
      if (!is_enough()) improve(path_on_roadmap(problem, *motions));
      if (is_sampled_ && !is_enough()) improve(planned(problem, exact, seed, *motions, poses));
    } else {
      poses = planned(problem, exact, seed, *motions, {});
    }
    if (poses.empty()) return std::nullopt;
    return positions_along(*motions, poses);
  }

 private:
  /// Empty with a reason if none is found.
  std::vector<TPose2D> path_on_lattice(const PlanningProblem& problem, std::string& reason) const {
    const PolygonMotion motion = robot_.holonomic()     ? PolygonMotion::Holonomic
                                 : !robot_.forward_only ? PolygonMotion::Reversing
                                                        : PolygonMotion::Forward;
    // All are tried, as the note names them.
    const auto path = find_footprint_path(
        problem.world, robot_.shape(), {problem.start.x, problem.start.y, problem.start_heading},
        problem.goal, 0, reason, SearchEffort::Thorough, PolygonMotion::Holonomic);
    if (!path) return {};
    const bool arrives = TPoint2D(path->poses.back()) == problem.goal;
    if (path->motion <= motion && arrives) return path->poses;
    const bool reverses = path->motion == PolygonMotion::Reversing;
    reason = path->motion <= motion
                 ? "the path that was found ends beside the goal"
                 : fmt::format("a robot that {} has one of {:.4g} m{}{}",
                               reverses ? "reverses" : "moves sideways", path->length,
                               arrives ? "" : ", which ends beside the goal",
                               reverses ? ""
                                        : "; if it touches nothing, one that reverses can follow "
                                          "it as closely as it likes");
    return {};
  }

  /// Runs OMPL's planner; empty if it finds no path.
  std::vector<TPose2D> planned(const PlanningProblem& problem, const References& exact,
                               std::uint64_t seed, const PoseMotions& motions,
                               const std::vector<TPose2D>& seeds) const {
    prepare_ompl(seed);
    const PlanningSpace space =
        make_pose_space(problem, motions, goal_poses(problem, motions), seeds);
    const ob::PathPtr path =
        solve(space, make_objective(space, options_, exact), options_.planner,
              make_termination_condition(options_.max_pose_iterations, options_.max_time));
    return path ? poses_of(path) : std::vector<TPose2D>();
  }

  OmplOptions options_;
  RobotModel robot_;
  bool is_sampled_;  ///< by OMPL's planner
};

}  // namespace

std::unique_ptr<ReferencePlanner> make_ompl_planner(const OmplOptions& options,
                                                    const RobotModel& robot) {
  if (robot.min_turning_radius > 0 || !robot.shape().is_disc())
    return std::make_unique<PosePlanner>(options, robot);
  if (options.planner == kExactPlanner) return nullptr;
  return std::make_unique<OmplPlanner>(options);
}
}  // namespace slalom
