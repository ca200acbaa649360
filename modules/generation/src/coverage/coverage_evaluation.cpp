// SPDX-License-Identifier: BSD-3-Clause
#include "coverage_evaluation.h"
#include "sampling/solvable.h"

#include <slalom/core/distance.h>
#include <slalom/core/error.h>
#include <slalom/references/exact_shortest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slalom {
namespace {

/// Number of cells above which a scenario is evaluated on coarser cells first.
constexpr double kMaxFineCells = 400'000;

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
  std::string reason;
  const auto found = exact_shortest_path(problem_in(world, robot_radius), reason);
  return found ? KnownPath{found->path, found->length, ""} : KnownPath{{}, 0, reason};
}

/// m, of a disc whose paths only cross cells whose centers are free for the robot's disc.
double inflated_radius(double robot_radius, double resolution) {
  return robot_radius + 1.5 * resolution;
}

Footprint shape_of(const CoverageSettings& settings) {
  return settings.footprint ? *settings.footprint : Footprint::disc(settings.robot_radius);
}

}  // namespace

CandidateEvaluation::CandidateEvaluation(const CoveragePlan& plan, const CoverageSettings& settings,
                                         const CoverageBins& bins)
    : plan_(plan),
      settings_(settings),
      bins_(bins),
      shape_(shape_of(settings)),
      generators_(plan, settings.load_map) {
  const CoverageOptions& o = plan.options;
  limits_ = {settings.robot_radius, settings.resolution, o.min_extent,
             o.max_extent,          o.min_distance,      static_cast<std::size_t>(o.max_obstacles)};
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
  if (!scenario || !within_limits(*scenario)) return std::nullopt;
  const World world(*scenario, settings_.resolution);
  if (const double times = coarseness(*scenario); times > 1)
    return evaluate_large(world, times, proposal, archive);
  Elite elite;
  if (!measure({world, world}, proposal, archive, elite) || !is_certified(world))
    return std::nullopt;
  elite.sketch = sketch(world);
  return elite;
}

/// Coarse cells, an integer multiple of the fine ones with the same origin, are a conservative
/// approximation: a path that is free on them is free on the fine ones. With additional clearance
/// the search on fine cells finds it too; otherwise that search is run.
std::optional<Elite> CandidateEvaluation::evaluate_large(const World& world, double times,
                                                         const Proposal& proposal,
                                                         const CoverageArchive& archive) const {
  const World coarse(world.scenario(), settings_.resolution * times);
  Elite elite;
  if (!measure({world, coarse}, proposal, archive, elite) || !is_certified(coarse))
    return std::nullopt;
  elite.is_exact = false;
  if (!elite.bin || !archive.is_open(*elite.bin)) return elite;
  if (!measure({world, world}, proposal, archive, elite)) return std::nullopt;
  const double inflated = inflated_radius(settings_.robot_radius, settings_.resolution);
  std::string reason;
  if (!slalom::is_certified(problem_in(coarse, inflated), reason) && !is_certified(world))
    return std::nullopt;
  elite.is_exact = true;
  elite.sketch = sketch(world);
  return elite;
}

double CandidateEvaluation::coarseness(const Scenario& scenario) const {
  if (scenario.representation() != Representation::Continuous) return 1;
  const double cells = scenario.bounds().area() / (settings_.resolution * settings_.resolution);
  return std::ceil(std::sqrt(cells / kMaxFineCells));
}

std::optional<Scenario> CandidateEvaluation::make(const Proposal& proposal,
                                                  RandomEngine& engine) const {
  if (!proposal.parent) {
    const auto generator = generators_.draw(engine);
    if (!generator) return std::nullopt;
    return populated(generator->generate("candidate", engine), engine);
  }
  std::optional<Scenario> scenario = *proposal.parent;
  for (const Mutation mutation : proposal.mutations) {
    scenario = mutate(*scenario, mutation, limits_, engine);
    if (!scenario) break;
  }
  return scenario;
}

std::optional<Scenario> CandidateEvaluation::populated(Scenario scenario,
                                                       RandomEngine& engine) const {
  if (settings_.walkers.count == 0 && settings_.people.count == 0) return scenario;
  const World world(std::move(scenario), settings_.resolution);
  const double radius = settings_.robot_radius;
  try {
    Scenario walked = with_walkers(world, radius, settings_.walkers, engine);
    return walked.with_people(sample_people(world, radius, settings_.people, engine));
  } catch (const Error&) {
    return std::nullopt;
  }
}

bool CandidateEvaluation::within_limits(const Scenario& scenario) const {
  constexpr double kSlack = 1e-4;  // MRPT stores the extent of grids in single precision
  const Bounds& b = scenario.bounds();
  if (std::min(b.width(), b.height()) < limits_.min_extent - kSlack ||
      std::max(b.width(), b.height()) > limits_.max_extent + kSlack)
    return false;
  const auto& start = scenario.start();
  if (distance_between(scenario.goal(), start) < limits_.min_distance) return false;
  if (scenario.representation() == Representation::Grid)
    return scenario.grid_map()->getResolution() <= kMaxCellSize + kSlack;
  if (scenario.representation() == Representation::Points) return true;
  return scenario.primitives().discs.size() + scenario.primitives().polygons.size() <=
         limits_.max_obstacles;
}

bool CandidateEvaluation::measure(const Models& models, const Proposal& proposal,
                                  const CoverageArchive& archive, Elite& elite) const {
  const PathSource path =
      search_once([&] { return find_path(models.rest, shape_.inscribed_radius()); });
  elite.values.resize(order_.size());
  elite.point.resize(order_.size());
  bool may_fit = true;
  double distance = 0;
  for (const std::size_t axis : order_) {
    const bool is_cheap = cost_of(plan_.axes[axis].id) == 0;
    const DescriptorContext context{is_cheap ? models.cells : models.rest, shape_,
                                    settings_.sensor_range, path};
    const Value value = descriptors_[axis]->compute(context);
    if (value.is_na()) return false;
    elite.values[axis] = {descriptors_[axis]->key(context), value};
    elite.point[axis] = value.number();
    const auto slot = bins_.slot(axis, value.number());
    may_fit = may_fit && slot && archive.is_open(axis, *slot);
    distance += bins_.gap(proposal.target, axis, value.number());
    if (!may_fit && distance >= archive.max_distance(proposal.target)) return false;
  }
  elite.scenario = std::make_shared<const Scenario>(models.cells.scenario());
  elite.seed = proposal.seed;
  elite.bin = bins_.find(elite.point);
  return (elite.bin && archive.is_open(*elite.bin)) ||
         distance < archive.max_distance(proposal.target);
}

bool CandidateEvaluation::is_certified(const World& world) const {
  const PlanningProblem problem = problem_in(world, settings_.robot_radius);
  const double inflated = inflated_radius(settings_.robot_radius, world.occupancy().resolution());
  if (is_free(world, {problem.start, problem.goal}, inflated)) return true;
  std::string reason;
  return slalom::is_certified(world, settings_.robot_radius, settings_.footprint, reason);
}

}  // namespace slalom
