#include "planning_space.h"

#include <slalom/ompl/ompl_planner.h>

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

using PlannerMaker = std::function<ob::PlannerPtr(const ob::SpaceInformationPtr&)>;

template <typename Planner>
ob::PlannerPtr make(const ob::SpaceInformationPtr& space) {
  return std::make_shared<Planner>(space);
}

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

class OmplPlanner : public ReferencePlanner {
 public:
  OmplPlanner(OmplOptions options, RobotModel robot)
      : options_(std::move(options)), robot_(std::move(robot)) {}

  std::string name() const override { return options_.planner; }
  Objective objective() const override { return options_.objective; }

  std::optional<Path> plan(const PlanningProblem& problem, const References& exact,
                           std::uint64_t seed) const override {
    ompl::msg::noOutputHandler();
    // OMPL seeds have 32 bits, and 0 means a seed from the clock.
    ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed % 0xfffffffeU) + 1);
    const PlanningSpace space =
        plans_poses(robot_) ? make_pose_space(problem, robot_) : make_point_space(problem);
    const auto definition = std::make_shared<ob::ProblemDefinition>(space.information);
    ob::ScopedState<> start(space.information);
    space.set_start(start.get());
    if (!space.information->isValid(start.get())) return std::nullopt;
    definition->addStartState(start);
    definition->setGoal(space.goal);
    definition->setOptimizationObjective(make_objective(space, options_, exact));
    const ob::PlannerPtr planner = planners().at(options_.planner)(space.information);
    planner->setProblemDefinition(definition);
    planner->setup();
    planner->solve(make_termination_condition(
        plans_poses(robot_) ? options_.max_pose_iterations : options_.max_iterations,
        options_.max_time));
    if (!definition->hasExactSolution()) return std::nullopt;
    return space.to_path(definition->getSolutionPath());
  }

 private:
  static bool plans_poses(const RobotModel& robot) {
    return robot.min_turning_radius > 0 || !robot.shape().is_disc();
  }

  OmplOptions options_;
  RobotModel robot_;
};

}  // namespace

void OmplOptions::visit(OptionVisitor& v) {
  v.option("planner", planner, "planner of the reference path; exact: only the exact search",
           planner_names());
  v.option("objective", objective, "reference provided by the planner: shortest or safest path");
  v.option("gap", gap, "-", "relative gap to the certified lower bound", Range::positive());
  v.option("max_iterations", max_iterations, "-", "maximum iterations of the planner",
           Range::at_least(1));
  v.option("max_pose_iterations", max_pose_iterations, "-",
           "the same for planning poses: polygons and car-like robots", Range::at_least(1));
  v.option("max_time", max_time, "s", "wall-clock limit of the planner", Range::positive());
}

std::vector<std::string> planner_names() {
  std::vector<std::string> names = {kExactPlanner};
  for (const auto& [name, maker] : planners()) names.push_back(name);
  return names;
}

std::unique_ptr<ReferencePlanner> make_ompl_planner(const OmplOptions& options,
                                                    const RobotModel& robot) {
  if (options.planner == kExactPlanner) return nullptr;
  return std::make_unique<OmplPlanner>(options, robot);
}

/// Composed of its parts, because OMPL_VERSION is empty in Debian's package.
std::string ompl_version() {
  return std::to_string(OMPL_MAJOR_VERSION) + "." + std::to_string(OMPL_MINOR_VERSION) + "." +
         std::to_string(OMPL_PATCH_VERSION);
}

}  // namespace slalom
