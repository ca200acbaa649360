#include "coverage_evaluation.h"

#include <slalom/core/error.h>
#include <slalom/references/exact_shortest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slalom {
namespace {

/// Cells beyond which a scenario is looked at on coarser ones first.
constexpr double kManyCells = 400'000;

int cost_of(const std::string& id) {
  if (id == "density") return 0;
  if (id == "clearness") return 1;
  if (id == "confinement") return 2;
  return 3;
}

PlanningProblem problem_in(const World& world, double robot_radius) {
  const auto& start = world.scenario().start();
  return {world, robot_radius, {start.x, start.y}, world.scenario().goal()};
}

KnownPath find_path(const World& world, double robot_radius) {
  constexpr double kGap = 0.01;  // as in the descriptions of lists
  std::string reason;
  const auto found = exact_shortest_path(problem_in(world, robot_radius), kGap, reason);
  return found ? KnownPath{found->path, found->length, ""} : KnownPath{{}, 0, reason};
}

/// A path for a robot of this radius runs over cells that are free as a whole for the real one;
/// such paths the search never misses.
double roomy_radius(double robot_radius, double resolution) {
  return robot_radius + 1.5 * resolution;
}

}  // namespace

CandidateEvaluation::CandidateEvaluation(const CoveragePlan& plan, const CoverageTask& task,
                                         const CoverageBins& bins)
    : plan_(plan), task_(task), bins_(bins), families_(plan, task.load_map) {
  const CoverageOptions& o = plan.options;
  limits_ = {task.robot_radius, task.resolution, o.min_floor,
             o.max_floor,       o.min_distance,  static_cast<std::size_t>(o.max_obstacles)};
  for (const CoverageAxis& axis : plan.axes) descriptors_.push_back(&descriptor(axis.id));
  order_.resize(plan.axes.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
    return cost_of(plan.axes[a].id) < cost_of(plan.axes[b].id);
  });
}

std::optional<Elite> CandidateEvaluation::evaluate(const Proposal& proposal,
                                                   const CoverageArchive& archive) const {
  RandomEngine engine(proposal.seed);
  const std::optional<Scenario> scenario = make(proposal, engine);
  if (!scenario || !keeps_limits(*scenario)) return std::nullopt;
  const World world(*scenario, task_.resolution);
  if (const double times = coarseness(*scenario); times > 1)
    return evaluate_large(world, times, proposal, archive);
  Elite elite;
  if (!measure({world, world}, proposal, archive, elite) ||
      !is_certified(world, task_.robot_radius))
    return std::nullopt;
  elite.sketch = sketch(world);
  return elite;
}

/// Cells that are a whole number of times as large, on the same corner, hold all the small ones
/// that are occupied: a path that is free among them is free among the small ones. Where it has
/// room to spare, the search among the small ones finds it too; where it has not, that is tried.
std::optional<Elite> CandidateEvaluation::evaluate_large(const World& world, double times,
                                                         const Proposal& proposal,
                                                         const CoverageArchive& archive) const {
  const World coarse(world.scenario(), task_.resolution * times);
  Elite elite;
  if (!measure({world, coarse}, proposal, archive, elite) ||
      !is_certified(coarse, task_.robot_radius))
    return std::nullopt;
  elite.is_exact = false;
  if (!elite.bin || !archive.is_open(*elite.bin)) return elite;
  if (!measure({world, world}, proposal, archive, elite)) return std::nullopt;
  if (!is_certified(coarse, roomy_radius(task_.robot_radius, task_.resolution)) &&
      !is_certified(world, task_.robot_radius))
    return std::nullopt;
  elite.is_exact = true;
  elite.sketch = sketch(world);
  return elite;
}

double CandidateEvaluation::coarseness(const Scenario& scenario) const {
  if (scenario.representation() != Representation::Continuous) return 1;
  const double cells = scenario.bounds().area() / (task_.resolution * task_.resolution);
  return std::ceil(std::sqrt(cells / kManyCells));
}

std::optional<Scenario> CandidateEvaluation::make(const Proposal& proposal,
                                                  RandomEngine& engine) const {
  if (!proposal.parent) {
    const auto generator = families_.draw(engine);
    if (!generator) return std::nullopt;
    return generator->generate("candidate", engine);
  }
  std::optional<Scenario> scenario = *proposal.parent;
  for (const Mutation mutation : proposal.mutations) {
    scenario = mutate(*scenario, mutation, limits_, engine);
    if (!scenario) break;
  }
  return scenario;
}

bool CandidateEvaluation::keeps_limits(const Scenario& scenario) const {
  constexpr double kSlack = 1e-4;  // MRPT keeps the sides of grids in single precision
  const Bounds& b = scenario.bounds();
  if (std::min(b.width(), b.height()) < limits_.min_floor - kSlack ||
      std::max(b.width(), b.height()) > limits_.max_floor + kSlack)
    return false;
  const auto& start = scenario.start();
  if (std::hypot(scenario.goal().x - start.x, scenario.goal().y - start.y) < limits_.min_distance)
    return false;
  if (scenario.representation() == Representation::Grid)
    return scenario.grid_map()->getResolution() <= kCoarsestCell + kSlack;
  if (scenario.representation() == Representation::Points) return true;
  return scenario.primitives().discs.size() + scenario.primitives().polygons.size() <=
         limits_.max_obstacles;
}

bool CandidateEvaluation::measure(const Models& models, const Proposal& proposal,
                                  const CoverageArchive& archive, Elite& elite) const {
  const PathSource path = search_once([&] { return find_path(models.rest, task_.robot_radius); });
  elite.values.resize(order_.size());
  elite.point.resize(order_.size());
  bool may_fit = true;
  double distance = 0;
  for (const std::size_t axis : order_) {
    const bool is_cheap = cost_of(plan_.axes[axis].id) == 0;
    const DescriptorContext context{is_cheap ? models.cells : models.rest,
                                    Footprint::disc(task_.robot_radius), task_.sensor_range, path};
    const Value value = descriptors_[axis]->compute(context);
    if (value.is_na()) return false;
    const QuantityInfo info = descriptors_[axis]->info();
    elite.values[axis] = {info.id, info.version, descriptors_[axis]->parameters(context), value};
    elite.point[axis] = value.number();
    const auto slot = bins_.slot(axis, value.number());
    may_fit = may_fit && slot && archive.is_open(axis, *slot);
    distance += bins_.gap(proposal.target, axis, value.number());
    if (!may_fit && distance >= archive.reach(proposal.target)) return false;
  }
  elite.scenario = std::make_shared<const Scenario>(models.cells.scenario());
  elite.seed = proposal.seed;
  elite.bin = bins_.find(elite.point);
  return (elite.bin && archive.is_open(*elite.bin)) || distance < archive.reach(proposal.target);
}

bool CandidateEvaluation::is_certified(const World& world, double robot_radius) const {
  const PlanningProblem problem = problem_in(world, robot_radius);
  const double roomy = roomy_radius(robot_radius, world.occupancy().resolution());
  if (is_free(world, {problem.start, problem.goal}, roomy)) return true;
  std::string reason;
  return exact_shortest_path(problem, 1, reason).has_value();
}

}  // namespace slalom
