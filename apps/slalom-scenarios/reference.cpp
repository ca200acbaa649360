// SPDX-License-Identifier: BSD-3-Clause
#include "verbs.h"

#include <slalom/app/checks.h>
#include <slalom/app/program.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/reference_text.h>
#include <slalom/io/scenario_list.h>
#include <slalom/ompl/ompl_planner.h>
#include <slalom/references/earliest_arrival.h>
#include <slalom/references/footprint_path.h>
#include <slalom/workers/worker_pool.h>

#include <iostream>

namespace slalom {
namespace {

struct ReferenceArguments {
  ListArguments list;
  RobotModel robot;
  OmplOptions planner;
  ArrivalLimits arrival;
  std::uint64_t seed = 1;
  std::string picture;
};

std::string compute(const ReferenceArguments& arguments, const ScenarioList::Entry& entry,
                    const Scenario& scenario) {
  const World world(scenario, arguments.list.resolution);
  const auto& start = scenario.start();
  const PlanningProblem problem{world,
                                arguments.robot.shape().inscribed_radius(),
                                {start.x, start.y},
                                scenario.goal(),
                                start.phi};
  const auto planner = make_ompl_planner(arguments.planner, arguments.robot);
  References references =
      compute_references(problem, planner.get(), arguments.planner.gap, arguments.seed);
  refuse_obstructed(problem, arguments.robot.shape(), arguments.arrival.goal_tolerance, references);
  add_earliest_arrival(problem, arguments.arrival, references);
  if (!arguments.picture.empty())
    write_picture(scenario, references, arguments.robot.radius, 800, arguments.picture);
  return arguments.list.json ? render_json(references, entry.id, entry.name, &world)
                             : render_text(references, entry.id, entry.name, &world);
}

/// Each scenario in a new process, since OMPL's random generators are seeded once per process.
void run(ReferenceArguments arguments) {
  RobotModel& robot = arguments.robot;
  robot.radius = robot.footprint.empty()
                     ? arguments.list.robot_radius
                     : Footprint::parse(robot.footprint, "--footprint").enclosing_radius();
  const ScenarioList list = ScenarioList::open(arguments.list.list);
  std::vector<ScenarioList::Entry> entries = list.entries();
  if (!arguments.list.id.empty()) entries = {list.find_entry(arguments.list.id)};
  if (!arguments.picture.empty()) require_picture(arguments.picture);
  if (!arguments.picture.empty() && entries.size() != 1)
    throw usage_error("-o", "a picture of " + count_text(entries.size(), "scenario"),
                      "the name or --id of one scenario");
  std::vector<Scenario> scenarios;
  for (const auto& entry : entries) scenarios.push_back(list.read(entry.hash));
  PoolOptions pool;
  pool.schedule.process_per_item = true;
  pool.schedule.trusted = true;
  run_in_workers(
      entries.size(), pool,
      [&](std::size_t i, SharedTaskLog&) { return compute(arguments, entries[i], scenarios[i]); },
      [&](std::size_t i, WorkResult&& result) {
        if (result.status != WorkResult::Status::Done)
          throw job_error(entries[i].name, "cannot compute references: " + result.detail);
        std::cout << result.payload << "\n";
      },
      nullptr);
}

}  // namespace

void add_reference_verb(CLI::App& app) {
  static ReferenceArguments arguments;
  CLI::App* verb = add_list_verb(app, "reference",
                                 "Print the length of the shortest path with its certificate, the "
                                 "safest path, and with moving "
                                 "obstacles the earliest arrival",
                                 arguments.list);
  add_scenario_argument(*verb, arguments.list, false);
  add_robot_options(*verb, arguments.list);
  verb->add_option("--planner", arguments.planner.planner,
                   "exact, or an OMPL planner, which must come within the gap")
      ->check(CLI::IsMember(planner_names()))
      ->capture_default_str();
  add_choice(*verb, "--objective", arguments.planner.objective,
             "Reference computed by the planner: length (shortest) or clearance (safest)")
      ->default_str(to_string(arguments.planner.objective));
  verb->add_option("--footprint", arguments.robot.footprint,
                   "Polygon x,y; x,y; ... (m) instead of the disc");
  verb->add_option("--min-turning-radius", arguments.robot.min_turning_radius,
                   "Minimum turning radius of a car-like robot, m: Dubins curves")
      ->check(not_negative())
      ->capture_default_str();
  verb->add_flag_callback(
      "--reverse", [] { arguments.robot.forward_only = false; },
      "Allow reverse motion: Reeds-Shepp curves");
  verb->add_option("--gap", arguments.planner.gap, "Relative gap to the lower bound")
      ->check(above_zero())
      ->capture_default_str();
  verb->add_option("--max-speed", arguments.arrival.max_speed,
                   "Maximum speed of the robot, m/s, for the earliest arrival")
      ->check(above_zero())
      ->capture_default_str();
  verb->add_option("--goal-tolerance", arguments.arrival.goal_tolerance,
                   "Distance from the goal within which the robot has arrived, m")
      ->check(not_negative())
      ->capture_default_str();
  verb->add_option("--max-time", arguments.arrival.max_time, "Latest arrival, s")
      ->check(above_zero())
      ->capture_default_str();
  verb->add_option("--seed", arguments.seed, "Seed of the planner")->capture_default_str();
  verb->add_option("-o,--output", arguments.picture,
                   "With one scenario: a picture of both paths, .png or .svg");
  verb->add_flag("--json", arguments.list.json, "One JSON object per scenario");
  verb->callback([] { run(arguments); });
}

}  // namespace slalom
