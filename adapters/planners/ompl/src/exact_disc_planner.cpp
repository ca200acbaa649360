// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/distance.h>
#include <slalom/ompl/exact_disc_planner.h>
#include <slalom/references/disc_path.h>

#include <ompl/base/PlannerData.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace slalom {
namespace {

namespace ob = ompl::base;
using mrpt::math::TPoint2D;

void set_position(const ob::StateSpace& space, ob::State* state, const TPoint2D& p) {
  if (space.getType() == ob::STATE_SPACE_REAL_VECTOR) {
    auto* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
    values[0] = p.x;
    values[1] = p.y;
  } else {
    state->as<ob::SE2StateSpace::StateType>()->setXY(p.x, p.y);
  }
}

/// From `start` to `goal` over the points; headings turn evenly along their length.
ob::PathPtr make_path(const ob::SpaceInformationPtr& space, const Path& points,
                      const ob::State* start, const ob::State* goal) {
  auto path = std::make_shared<ompl::geometric::PathGeometric>(space, start);
  const double total = length(points);
  ob::ScopedState<> state(space);
  double traveled = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    traveled += distance_between(points[i - 1], points[i]);
    space->getStateSpace()->interpolate(start, goal, traveled / total, state.get());
    set_position(*space->getStateSpace(), state.get(), points[i]);
    path->append(state.get());
  }
  path->append(goal);
  return path;
}

std::vector<const ob::State*> start_states(const ob::ProblemDefinition& problem) {
  std::vector<const ob::State*> states;
  for (unsigned i = 0; i < problem.getStartStateCount(); ++i)
    states.push_back(problem.getStartState(i));
  return states;
}

/// nullopt for goals that are not a known set of states. The states of lazy samples may increase
/// while planning.
std::optional<std::vector<const ob::State*>> goal_states(const ob::Goal& goal) {
  if (const auto* state = dynamic_cast<const ob::GoalState*>(&goal))
    return std::vector<const ob::State*>{state->getState()};
  if (goal.getType() != ob::GOAL_STATES) return std::nullopt;
  const auto& several = dynamic_cast<const ob::GoalStates&>(goal);
  std::vector<const ob::State*> states;
  for (unsigned i = 0; i < several.getStateCount(); ++i) states.push_back(several.getState(i));
  return states;
}

std::vector<const ob::State*> valid_states(const ob::SpaceInformation& space,
                                           std::vector<const ob::State*> states) {
  const auto is_invalid = [&](const ob::State* state) {
    return !space.satisfiesBounds(state) || !space.isValid(state);
  };
  states.erase(std::remove_if(states.begin(), states.end(), is_invalid), states.end());
  return states;
}

ob::OptimizationObjectivePtr objective_of(const ob::ProblemDefinition& problem) {
  if (!problem.getOptimizationObjective())
    return std::make_shared<ob::PathLengthOptimizationObjective>(problem.getSpaceInformation());
  return problem.getOptimizationObjective();
}

}  // namespace

ExactDiscPlanner::ExactDiscPlanner(const ob::SpaceInformationPtr& space)
    : ob::Planner(space, "ExactDiscPlanner") {
  specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
  specs_.optimizingPaths = true;
  specs_.provingSolutionNonExistence = true;
  declareParam<double>("max_excess", this, &ExactDiscPlanner::set_max_excess,
                       &ExactDiscPlanner::max_excess, "1e-9:1e-9:1e-2");
}

const DiscValidityChecker& ExactDiscPlanner::disc() const {
  const auto* checker =
      dynamic_cast<const DiscValidityChecker*>(si_->getStateValidityChecker().get());
  if (checker == nullptr)
    throw ompl::Exception(getName(),
                          "the checks of the space information are not those of "
                          "slalom::set_disc_checks(), by which it knows the world");
  return *checker;
}

void ExactDiscPlanner::setup() {
  ob::Planner::setup();
  disc();
}

void ExactDiscPlanner::checkValidity() {
  ob::Planner::checkValidity();
  disc();
  const auto& objective = pdef_->getOptimizationObjective();
  if (objective != nullptr &&
      dynamic_cast<const ob::PathLengthOptimizationObjective*>(objective.get()) == nullptr)
    throw ompl::Exception(getName(), "the objective is '" + objective->getDescription() +
                                         "'; expected the path length");
}

ob::PlannerStatus ExactDiscPlanner::solve(const ob::PlannerTerminationCondition& stop) {
  checkValidity();
  const auto all_goals = goal_states(*pdef_->getGoal());
  if (!all_goals) return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
  const auto starts = valid_states(*si_, start_states(*pdef_));
  if (starts.empty()) return ob::PlannerStatus::INVALID_START;
  const auto goals = valid_states(*si_, *all_goals);
  if (goals.empty()) return ob::PlannerStatus::INVALID_GOAL;

  const ob::OptimizationObjectivePtr objective = objective_of(*pdef_);
  ob::Cost best = objective->infiniteCost();
  solution_.reset();
  for (const ob::State* start : starts)
    for (const ob::State* goal : goals) {
      if (stop()) return ob::PlannerStatus::TIMEOUT;
      const ob::PathPtr path = find_path(start, goal);
      if (!path || !objective->isCostBetterThan(path->cost(objective), best)) continue;
      best = path->cost(objective);
      solution_ = path;
    }
  if (!solution_) return ob::PlannerStatus::ABORT;
  ob::PlannerSolution solution(solution_);
  solution.setPlannerName(getName());
  solution.setOptimized(objective, best, objective->isSatisfied(best));
  pdef_->addSolutionPath(solution);
  return ob::PlannerStatus::EXACT_SOLUTION;
}

ob::PathPtr ExactDiscPlanner::find_path(const ob::State* start, const ob::State* goal) const {
  const ob::StateSpace& space = *si_->getStateSpace();
  const Occupancy& cells = disc().world().occupancy();
  std::string reason;
  const auto path = shortest_disc_path(cells, disc().radius(), position_of(space, start),
                                       position_of(space, goal), reason);
  if (!path) {
    OMPL_INFORM("%s: %s", getName().c_str(), reason.c_str());
    return nullptr;
  }
  return make_path(si_, to_polyline(*path, cells, max_excess_), start, goal);
}

void ExactDiscPlanner::clear() {
  ob::Planner::clear();
  solution_.reset();
}

void ExactDiscPlanner::getPlannerData(ob::PlannerData& data) const {
  ob::Planner::getPlannerData(data);
  if (!solution_) return;
  const auto& states = solution_->as<ompl::geometric::PathGeometric>()->getStates();
  data.addStartVertex(ob::PlannerDataVertex(states.front()));
  data.addGoalVertex(ob::PlannerDataVertex(states.back()));
  for (std::size_t i = 1; i < states.size(); ++i)
    data.addEdge(ob::PlannerDataVertex(states[i - 1]), ob::PlannerDataVertex(states[i]));
}

}  // namespace slalom
