#include <slalom/ompl/ompl_planner.h>

#include <ompl/base/MotionValidator.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/config.h>
#include <ompl/geometric/PathGeometric.h>
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

TPoint2D point_of(const ob::State* state) {
  const auto* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
  return {values[0], values[1]};
}

/// States and straight motions are free in the model that judges collisions, with no sampling of
/// motions.
class ExactValidity : public ob::StateValidityChecker {
 public:
  ExactValidity(const ob::SpaceInformationPtr& space, const PlanningProblem& problem)
      : ob::StateValidityChecker(space), problem_(problem) {}
  bool isValid(const ob::State* state) const override {
    return is_free(problem_.world, {point_of(state)}, problem_.robot_radius);
  }

 private:
  const PlanningProblem& problem_;
};

class ExactMotions : public ob::MotionValidator {
 public:
  ExactMotions(const ob::SpaceInformationPtr& space, const PlanningProblem& problem)
      : ob::MotionValidator(space), problem_(problem) {}
  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    return is_free(problem_.world, {point_of(a), point_of(b)}, problem_.robot_radius);
  }
  /// With the last valid state on the way: found by halving.
  bool checkMotion(const ob::State* a, const ob::State* b,
                   std::pair<ob::State*, double>& last_valid) const override {
    if (checkMotion(a, b)) return true;
    const TPoint2D from = point_of(a), to = point_of(b);
    double low = 0, high = 1;
    for (int i = 0; i < 20; ++i) {
      const double middle = 0.5 * (low + high);
      const bool free =
          is_free(problem_.world, {from, from + (to - from) * middle}, problem_.robot_radius);
      (free ? low : high) = middle;
    }
    last_valid.second = low;
    if (last_valid.first != nullptr) si_->getStateSpace()->interpolate(a, b, low, last_valid.first);
    return false;
  }

 private:
  const PlanningProblem& problem_;
};

ob::SpaceInformationPtr make_space(const PlanningProblem& problem) {
  auto space = std::make_shared<ob::RealVectorStateSpace>(2);
  const Bounds bounds = problem.world.occupancy().bounds();
  ob::RealVectorBounds limits(2);
  limits.setLow(0, bounds.x_min);
  limits.setHigh(0, bounds.x_max);
  limits.setLow(1, bounds.y_min);
  limits.setHigh(1, bounds.y_max);
  space->setBounds(limits);
  auto information = std::make_shared<ob::SpaceInformation>(space);
  information->setStateValidityChecker(std::make_shared<ExactValidity>(information, problem));
  information->setMotionValidator(std::make_shared<ExactMotions>(information, problem));
  information->setup();
  return information;
}

ob::ProblemDefinitionPtr make_definition(const ob::SpaceInformationPtr& space,
                                         const PlanningProblem& problem, double good_enough) {
  const auto state = [&space](const TPoint2D& p) {
    ob::ScopedState<ob::RealVectorStateSpace> scoped(space);
    scoped->values[0] = p.x;
    scoped->values[1] = p.y;
    return scoped;
  };
  auto definition = std::make_shared<ob::ProblemDefinition>(space);
  definition->setStartAndGoalStates(state(problem.start), state(problem.goal));
  auto objective = std::make_shared<ob::PathLengthOptimizationObjective>(space);
  objective->setCostThreshold(ob::Cost(good_enough));
  definition->setOptimizationObjective(objective);
  return definition;
}

/// Stops by a count of how often the planner asks, so that the same seed gives the same path
/// however fast the machine is; the clock is only a guard.
ob::PlannerTerminationCondition stop_after(const OmplOptions& options) {
  const auto deadline =
      std::chrono::steady_clock::now() + std::chrono::duration<double>(options.max_time);
  auto asked = std::make_shared<int>(0);
  return ob::PlannerTerminationCondition([asked, deadline, most = options.max_iterations] {
    return ++*asked > most || std::chrono::steady_clock::now() > deadline;
  });
}

Path path_of(const ob::PathPtr& solution) {
  Path path;
  for (const ob::State* state : solution->as<og::PathGeometric>()->getStates())
    path.push_back(point_of(state));
  return path;
}

class OmplPlanner : public ReferencePlanner {
 public:
  explicit OmplPlanner(OmplOptions options) : options_(std::move(options)) {}

  std::string name() const override { return options_.planner; }

  std::optional<Path> plan(const PlanningProblem& problem, const ShortestPath& exact,
                           std::uint64_t seed) const override {
    ompl::msg::noOutputHandler();
    // OMPL takes 32 bits and treats 0 as "from the clock".
    ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed % 0xfffffffeU) + 1);
    const ob::SpaceInformationPtr space = make_space(problem);
    const double good_enough = (1 + options_.gap) * exact.certificate.lower_bound;
    const ob::ProblemDefinitionPtr definition = make_definition(space, problem, good_enough);
    const ob::PlannerPtr planner = planners().at(options_.planner)(space);
    planner->setProblemDefinition(definition);
    planner->setup();
    planner->solve(stop_after(options_));
    if (!definition->hasExactSolution()) return std::nullopt;
    return path_of(definition->getSolutionPath());
  }

 private:
  OmplOptions options_;
};

}  // namespace

void OmplOptions::visit(OptionVisitor& v) {
  std::vector<std::string> names = {"exact"};
  for (const auto& [name, maker] : planners()) names.push_back(name);
  v.option("planner", planner, "who provides the shortest path within the certificate's gap",
           names);
  v.option("gap", gap, "-", "relative gap to the certified lower bound", Range::positive());
  v.option("max_iterations", max_iterations, "-", "iterations after which the planner gives up",
           Range::at_least(1));
  v.option("max_time", max_time, "s", "wall-clock guard of the planner", Range::positive());
}

std::unique_ptr<ReferencePlanner> make_ompl_planner(const OmplOptions& options) {
  if (options.planner == "exact") return nullptr;
  return std::make_unique<OmplPlanner>(options);
}

/// From its parts: OMPL_VERSION is an empty text in Debian's package.
std::string ompl_version() {
  return std::to_string(OMPL_MAJOR_VERSION) + "." + std::to_string(OMPL_MINOR_VERSION) + "." +
         std::to_string(OMPL_PATCH_VERSION);
}

}  // namespace slalom
