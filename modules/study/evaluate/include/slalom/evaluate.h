// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/campaign/campaign_options.h>
#include <slalom/core/error.h>
#include <slalom/generation/avoid.h>
#include <slalom/generation/cellular_automaton.h>
#include <slalom/generation/circle.h>
#include <slalom/generation/clutter.h>
#include <slalom/generation/corridor_flow.h>
#include <slalom/generation/crossing.h>
#include <slalom/generation/defined_area.h>
#include <slalom/generation/doorway.h>
#include <slalom/generation/follow_path.h>
#include <slalom/generation/maze.h>
#include <slalom/generation/passage.h>
#include <slalom/generation/people_crossing.h>
#include <slalom/generation/perlin.h>
#include <slalom/generation/poisson_forest.h>
#include <slalom/generation/random_generator.h>
#include <slalom/generation/rooms.h>
#include <slalom/generation/sample_people.h>
#include <slalom/generation/sudden_obstacle.h>
#include <slalom/generation/traps.h>
#include <slalom/generation/walkers.h>
#include <slalom/references/reference.h>
#include <slalom/results/result_table.h>
#include <slalom/scenario/scenario.h>
#include <slalom/trajectory/trajectory.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace slalom {

/// A method as a function: the command of one control cycle. It must not throw; an exception ends
/// its run as method_error. Each run begins with a copy of the function as it was added, so that
/// state that it captures by value does not pass from run to run.
using Controller = std::function<Command(const Observation& observation)>;

/// The methods to evaluate, in the order in which they were added. Throws Error (Usage) for a name
/// that is empty or was added before.
class Methods {
 public:
  void add(const std::string& name, Controller controller);
  /// Factories are returned by the adapters: mrpt_holonomic("CHolonomicND"), plugin("libmine.so"),
  /// or may be any function that returns an object derived from Method.
  void add(const std::string& name, MethodFactory make);

  const std::vector<NamedMethod>& list() const { return methods_; }

 private:
  std::vector<NamedMethod> methods_;
};

/// How methods are evaluated: the settings of a campaign, such as `robot`, `simulation`, `metrics`,
/// `repetitions` and `seed`, and those of this process. The defaults are those of the programs,
/// except for the planner.
struct Options : CampaignOptions {
  Options() { metrics = descriptors = {"all"}; }

  WalkerOptions walkers;           ///< of generate(): added to each scenario
  PeopleOptions generated_people;  ///< likewise
  bool goal_headings = false;      ///< of generate(): goals have random headings
  /// An additional planner of the references, such as make_ompl_planner(); null: exact search only.
  std::shared_ptr<const ReferencePlanner> planner = nullptr;
  int workers = 1;          ///< processes, 0: one per core; results do not depend on them
  bool in_process = false;  ///< without workers and limits, to debug a method
  /// A result file that is written as well, with all trajectories; it replaces one. Empty: none.
  std::string output = "";
  /// Called with the current phase, and the number of its steps that are done and in total.
  std::function<void(const std::string& phase, std::size_t done, std::size_t total)> progress = {};
  /// Called with each run and its trajectory, in an order that may depend on the workers; null:
  /// trajectories stay in the workers.
  std::function<void(const RunRecord& run, const Trajectory& trajectory)> observer = {};
  /// Polled; when it returns true the evaluation ends, and finished runs are returned.
  std::function<bool()> cancel = {};
};

/// Generates `count` distinct scenarios, each solvable for the robot: the same as a program does
/// for this family as the only one, with this seed. Throws Error (Usage) for invalid options, Error
/// (Job) if too few are solvable.
std::vector<Scenario> generate(std::shared_ptr<const Generator> family, int count,
                               std::uint64_t seed, const Options& options = {});

template <typename FamilyOptions>
std::vector<Scenario> generate(const FamilyOptions& family, int count, std::uint64_t seed,
                               const Options& options = {}) {
  return generate(std::shared_ptr<const Generator>(make_generator(family)), count, seed, options);
}

/// Runs every method in every scenario (duplicates once) and computes the metrics of each run, the
/// descriptors of each scenario. The values are those of slalom-evaluate with the same scenarios,
/// methods and options. Throws Error: Usage for no methods, no scenarios, unknown ids, options out
/// of range and methods that cannot be built; File for an output that is no result file; Job for
/// failures of the machine.
ResultTable evaluate(const Methods& methods, const std::vector<Scenario>& scenarios,
                     const Options& options = {});

/// The values of `columns` (metrics) in bins of a descriptor, one table per method, as text: `rows`
/// is "all", "density:4" (bins of equal width), "density:q4" (with equal numbers of scenarios) or
/// "density:0,0.1,0.2" (edges). Throws Error (Usage) for unknown ids.
std::string cross_table(const ResultTable& table, const std::string& rows,
                        const std::vector<std::string>& columns, double confidence = 0.95);

}  // namespace slalom
