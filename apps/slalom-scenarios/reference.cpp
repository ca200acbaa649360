#include "verbs.h"

#include <slalom/campaign/worker_pool.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/scenario_list.h>
#include <slalom/ompl/ompl_planner.h>
#include <slalom/references/reference.h>

#include <nlohmann/json.hpp>

#include <iostream>
#include <stdexcept>

namespace slalom {
namespace {

using Json = nlohmann::ordered_json;

struct ReferenceArguments {
  ListArguments list;
  RobotModel robot;
  OmplOptions planner;
  std::uint64_t seed = 1;
};

Json to_json(const Path& path) {
  Json json = Json::array();
  for (const auto& p : path) json.push_back({p.x, p.y});
  return json;
}

Json to_json(const ScenarioList::Entry& entry, const References& references) {
  Json json = {{"id", entry.id}, {"name", entry.name}};
  if (references.shortest) {
    const ShortestPath& s = *references.shortest;
    json["shortest_length"] = s.length;
    json["lower_bound"] = s.certificate.lower_bound;
    json["upper_bound"] = s.certificate.upper_bound;
    json["gap"] = s.certificate.gap();
    json["planner"] = s.planner;
    json["exact_length"] = s.exact_length;
    if (s.planner_length) json["planner_length"] = *s.planner_length;
    if (!s.note.empty()) json["note"] = s.note;
    json["shortest_path"] = to_json(s.path);
  } else {
    json["shortest_length"] = nullptr;
    json["shortest_reason"] = references.shortest_reason;
  }
  if (references.safest) {
    const SafestPath& s = *references.safest;
    json["safest_length"] = length(s.path);
    json["safest_bottleneck"] = s.bottleneck;
    json["safest_planner"] = s.planner;
    if (!s.note.empty()) json["safest_note"] = s.note;
    json["safest_path"] = to_json(s.path);
  } else {
    json["safest_length"] = nullptr;
    json["safest_reason"] = references.safest_reason;
  }
  const ReferenceTiming& timing = references.timing;
  json["time_seconds"] = timing.exact + timing.planner + timing.safest;
  json["exact_seconds"] = timing.exact;
  json["planner_seconds"] = timing.planner;
  json["safest_seconds"] = timing.safest;
  return json;
}

/// For people, without the points of the paths.
std::string text_of(const Json& json) {
  std::string text;
  for (const auto& [key, value] : json.items()) {
    if (value.is_array()) continue;
    text +=
        "  " + key + " = " + (value.is_string() ? value.get<std::string>() : value.dump()) + "\n";
  }
  return text;
}

Json compute(const ReferenceArguments& arguments, const ScenarioList::Entry& entry,
             const Scenario& scenario) {
  const World world(scenario, arguments.list.resolution);
  const auto& start = scenario.start();
  const PlanningProblem problem{world,
                                arguments.robot.shape().inscribed_radius(),
                                {start.x, start.y},
                                scenario.goal(),
                                start.phi};
  const auto planner = make_ompl_planner(arguments.planner, arguments.robot);
  return to_json(entry,
                 compute_references(problem, planner.get(), arguments.planner.gap, arguments.seed));
}

/// The robot of the command line, checked.
RobotModel robot_of(const ReferenceArguments& arguments) {
  RobotModel robot = arguments.robot;
  robot.radius = arguments.list.robot_radius;
  try {
    robot.radius = robot.shape().enclosing_radius();
  } catch (const std::invalid_argument& expected) {
    throw usage_error("--footprint", "'" + robot.footprint + "' is no footprint", expected.what());
  }
  return robot;
}

/// Each scenario in a fresh process: OMPL's random generators are seeded once per process.
void run(ReferenceArguments arguments) {
  arguments.robot = robot_of(arguments);
  const ScenarioList list = ScenarioList::open(arguments.list.list);
  std::vector<ScenarioList::Entry> entries = list.entries();
  if (!arguments.list.id.empty()) entries = {list.find_entry(arguments.list.id)};
  std::vector<Scenario> scenarios;
  for (const auto& entry : entries) scenarios.push_back(list.read(entry.hash));
  PoolOptions pool;
  pool.fresh_process = true;
  run_in_workers(
      entries.size(), pool,
      [&](std::size_t i, TaskNotes&) {
        return compute(arguments, entries[i], scenarios[i]).dump();
      },
      [&](std::size_t i, TaskResult&& result) {
        if (result.status != TaskResult::Status::Done)
          throw job_error(entries[i].name, "no references: " + result.detail);
        std::cout << (arguments.list.json ? result.payload + "\n"
                                          : text_of(Json::parse(result.payload)) + "\n");
      },
      nullptr);
}

}  // namespace

void add_reference_verb(CLI::App& app) {
  static ReferenceArguments arguments;
  arguments.planner.planner = "exact";
  CLI::App* verb = add_list_verb(
      app, "reference",
      "Print the shortest path's length with its certificate, and the safest path", arguments.list);
  verb->add_option("--id", arguments.list.id, "Only this one: id, beginning of it, or name");
  add_robot_options(*verb, arguments.list);
  verb->add_option("--planner", arguments.planner.planner,
                   "exact, or an OMPL planner that must come within the gap")
      ->check(CLI::IsMember({"exact", "ABITstar", "AITstar", "BITstar", "FMT", "InformedRRTstar",
                             "PRMstar", "RRTstar"}))
      ->capture_default_str();
  verb->add_option("--objective", arguments.planner.objective,
                   "Which reference the planner provides: length (shortest) or clearance (safest)")
      ->check(CLI::IsMember({"length", "clearance"}))
      ->capture_default_str();
  verb->add_option("--footprint", arguments.robot.footprint,
                   "Convex polygon x,y; x,y; ... in m instead of the disc");
  verb->add_option("--min-turning-radius", arguments.robot.min_turning_radius,
                   "Of a robot that steers like a car, m: planned with Dubins curves")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  verb->add_flag_callback(
      "--reverse", [] { arguments.robot.forward_only = false; },
      "The robot may drive backwards: Reeds-Shepp curves");
  verb->add_option("--gap", arguments.planner.gap, "Relative gap to the lower bound")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  verb->add_option("--seed", arguments.seed, "Seed of the planner")->capture_default_str();
  verb->add_flag("--json", arguments.list.json, "One JSON object per scenario");
  verb->callback([] { run(arguments); });
}

}  // namespace slalom
