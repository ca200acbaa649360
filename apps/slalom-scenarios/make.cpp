#include "generate.h"
#include "verbs.h"

#include <slalom/commands/list_command.h>
#include <slalom/commands/scenario_sources.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/generation/generator.h>
#include <slalom/io/scenario_list.h>
#include <slalom/io/scenario_yaml.h>
#include <slalom/map_formats/map_import.h>
#include <slalom/references/exact_shortest.h>

#include <iostream>
#include <optional>

namespace slalom {
namespace {

void keep(const std::string& path, std::vector<Scenario> scenarios, const std::string& origin,
          bool quiet) {
  ScenarioList list = ScenarioList::create(path);
  make_add_scenarios(list, std::move(scenarios))->execute();
  list.set_note("origin", origin);
  if (!quiet) std::cerr << path << ": " << list.size() << " scenarios\n";
}

struct ImportArguments {
  std::vector<std::string> files;
  std::string output, start, goal;
  int pairs = 0;
  std::uint64_t seed = 1;
  double robot_radius = 0.25, min_distance = 4, simplemap_resolution = 0.05;
  bool unknown_is_free = false, quiet = false;
};

std::vector<double> numbers_of(const std::string& option, const std::string& text,
                               std::size_t least, std::size_t most) {
  std::vector<double> numbers;
  for (const std::string& part : split(text, ',')) {
    double number = 0;
    if (!parse_number(part, number)) numbers.resize(most + 1);
    numbers.push_back(number);
  }
  if (numbers.size() < least || numbers.size() > most)
    throw usage_error(option + " " + text, "is not a place",
                      most == 3 ? "x,y,phi in m and rad" : "x,y in m");
  numbers.resize(most);
  return numbers;
}

void expect_solvable(const Scenario& scenario, double robot_radius) {
  const World world(scenario, 0.05);
  const auto& start = scenario.start();
  std::string reason;
  const PlanningProblem problem{world, robot_radius, {start.x, start.y}, scenario.goal()};
  if (!exact_shortest_path(problem, 1, reason))
    throw job_error(scenario.name(), "the pair of start and goal is unsolvable: " + reason,
                    "a start and a goal between which the robot fits");
}

bool is_yaml_scenario(const std::string& path) {
  const std::string end = ".scenario.yaml";
  return path.size() > end.size() && path.compare(path.size() - end.size(), end.size(), end) == 0;
}

std::vector<Scenario> import_map(const std::string& path, const ImportArguments& arguments) {
  const MapImportOptions options{arguments.simplemap_resolution, arguments.unknown_is_free};
  const auto grid = load_map(path, options);
  const Scenario map = map_scenario(path, grid);
  if (arguments.pairs > 0) {
    GenerationTask task;
    task.count = arguments.pairs;
    task.seed = arguments.seed;
    task.robot_radius = arguments.robot_radius;
    task.name_prefix = map.name();
    return draw_tasks(map, task, arguments.min_distance);
  }
  const auto s = numbers_of("--start", arguments.start, 2, 3);
  const auto g = numbers_of("--goal", arguments.goal, 2, 2);
  const Scenario scenario = map.with_task({s[0], s[1], s[2]}, {g[0], g[1]});
  expect_solvable(scenario, arguments.robot_radius);
  return {scenario};
}

void import(const ImportArguments& arguments) {
  std::vector<Scenario> scenarios;
  for (const std::string& path : arguments.files) {
    if (is_yaml_scenario(path)) {
      scenarios.push_back(load_scenario_yaml(path));
      continue;
    }
    if (arguments.pairs == 0 && (arguments.start.empty() || arguments.goal.empty()))
      throw usage_error("import " + path, "a map has no start and goal",
                        "--start x,y,phi --goal x,y, or --pairs N");
    for (Scenario& scenario : import_map(path, arguments)) scenarios.push_back(std::move(scenario));
  }
  keep(arguments.output, std::move(scenarios), "imported: " + join(arguments.files, " "),
       arguments.quiet);
}

void add_import(CLI::App& app) {
  static ImportArguments arguments;
  CLI::App* verb = app.add_subcommand(
      "import", "Import maps (.gridmap[.gz], .simplemap[.gz], ROS .yaml) or .scenario.yaml files");
  verb->add_option("files", arguments.files, "Map files")->required();
  verb->add_option("-o,--output", arguments.output, "The list to write (.scenarios)")->required();
  verb->add_option("--start", arguments.start, "Start pose x,y,phi (m, rad)");
  verb->add_option("--goal", arguments.goal, "Goal x,y (m)");
  verb->add_option("--pairs", arguments.pairs, "Draw this many solvable pairs on each map")
      ->check(CLI::PositiveNumber);
  verb->add_option("--seed", arguments.seed, "Seed of the pairs")->capture_default_str();
  verb->add_option("--robot-radius", arguments.robot_radius, "For whom, m")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  verb->add_option("--min-distance", arguments.min_distance, "Straight from start to goal, m")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  verb->add_option("--simplemap-resolution", arguments.simplemap_resolution,
                   "Cell size of grids built from simplemaps, m")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  verb->add_flag("--unknown-free", arguments.unknown_is_free, "What was never seen is free");
  verb->add_flag("--quiet", arguments.quiet, "No messages");
  verb->callback([] { import(arguments); });
}

}  // namespace

void add_make_verbs(CLI::App& app) {
  add_generate_verb(app);
  add_import(app);
}

}  // namespace slalom
