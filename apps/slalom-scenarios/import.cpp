#include "make_list.h"

#include <slalom/commands/scenario_sources.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/generation/generator.h>
#include <slalom/io/scenario_yaml.h>
#include <slalom/map_formats/barn.h>
#include <slalom/map_formats/map_import.h>
#include <slalom/map_formats/map_task.h>
#include <slalom/map_formats/moving_ai.h>
#include <slalom/map_formats/point_map.h>
#include <slalom/references/exact_shortest.h>

#include <cmath>
#include <iostream>

namespace slalom {
namespace {

struct ImportArguments {
  std::vector<std::string> files;
  std::string output, start, goal;
  int pairs = 0;
  std::uint64_t seed = 1;
  double robot_radius = 0.25;
  TaskLimits limits;
  MapImportOptions map;
  PointMapOptions points;
  BarnOptions barn;
  bool barn_as_grid = false;
  std::string problems, buckets;  ///< MovingAI
  bool quiet = false;
};

/// What one file gives: scenarios, and what else its source says about them.
struct Imported {
  std::vector<Scenario> scenarios;
  std::string published_lengths;
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

bool is_solvable(const Scenario& scenario, double robot_radius, std::string& reason) {
  const World world(scenario, 0.05);
  const auto& start = scenario.start();
  const PlanningProblem problem{world, robot_radius, {start.x, start.y}, scenario.goal()};
  return exact_shortest_path(problem, 1, reason).has_value();
}

void expect_solvable(const Scenario& scenario, double robot_radius) {
  std::string reason;
  if (!is_solvable(scenario, robot_radius, reason))
    throw job_error(scenario.name(), "the pair of start and goal is unsolvable: " + reason,
                    "a start and a goal between which the robot fits");
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::vector<Scenario> draw_pairs(const Scenario& map, const ImportArguments& arguments) {
  GenerationTask task;
  task.count = arguments.pairs;
  task.seed = arguments.seed;
  task.robot_radius = arguments.robot_radius;
  task.name_prefix = map.name();
  return draw_tasks(map, task, arguments.limits);
}

/// "3" or "3-10".
ProblemChoice problem_choice(const ImportArguments& arguments) {
  ProblemChoice choice;
  choice.count = arguments.pairs;
  if (arguments.buckets.empty()) return choice;
  const std::size_t dash = arguments.buckets.find('-');
  const std::string first = arguments.buckets.substr(0, dash),
                    last = dash == std::string::npos ? first : arguments.buckets.substr(dash + 1);
  long long low = 0, high = 0;
  if (!parse_integer(first, low) || !parse_integer(last, high) || low < 0 || high < low ||
      high > 1'000'000'000)
    throw usage_error("--buckets " + arguments.buckets, "is no range of difficulties",
                      "such as 3 or 0-10");
  choice.first_bucket = static_cast<int>(low);
  choice.last_bucket = static_cast<int>(high);
  return choice;
}

/// The robot looks towards the goal: the file says nothing about it.
Scenario problem_scenario(const Scenario& map, const MovingAiProblem& problem, double cell_size,
                          const std::string& where) {
  if (problem.map_width != static_cast<int>(map.grid_map()->getSizeX()) ||
      problem.map_height != static_cast<int>(map.grid_map()->getSizeY()))
    throw file_error(where,
                     "is of a map of " + std::to_string(problem.map_width) + " x " +
                         std::to_string(problem.map_height) + " cells",
                     "the problems of this map");
  const int top = problem.map_height - 1;
  const auto center = [&](int x, int y) {
    if (map.grid_map()->getCell(x, top - y) < 0.5F)
      throw file_error(where, "start or goal lies on an occupied cell", "free cells");
    return mrpt::math::TPoint2D((x + 0.5) * cell_size, (top - y + 0.5) * cell_size);
  };
  const auto start = center(problem.start_x, problem.start_y),
             goal = center(problem.goal_x, problem.goal_y);
  return map.with_task({start.x, start.y, std::atan2(goal.y - start.y, goal.x - start.x)}, goal)
      .renamed(map.name() + "_bucket" + std::to_string(problem.bucket) + "_line" +
               std::to_string(problem.line));
}

/// Problems that the robot cannot solve are left out, with a message.
Imported import_problems(const Scenario& map, const ImportArguments& arguments) {
  const std::string& path = arguments.problems;
  const double cell_size = map.grid_map()->getResolution();
  const auto problems = choose_problems(read_moving_ai_problems(path), problem_choice(arguments));
  if (problems.empty())
    throw usage_error("--scen " + path, "has no problems of that difficulty",
                      "--buckets that are in the file");
  Imported imported;
  std::string reason;
  for (const MovingAiProblem& problem : problems) {
    const Scenario scenario =
        problem_scenario(map, problem, cell_size, path + ":" + std::to_string(problem.line));
    if (!is_solvable(scenario, arguments.robot_radius, reason)) continue;
    imported.scenarios.push_back(scenario);
    imported.published_lengths +=
        scenario.name() + " " + format_number(problem.published_length) + " cells, 8-connected\n";
  }
  const std::size_t left_out = problems.size() - imported.scenarios.size();
  if (imported.scenarios.empty())
    throw job_error(path,
                    "no problem is solvable for a robot of radius " +
                        format_number(arguments.robot_radius) + " m (" + reason + ")",
                    "a smaller --robot-radius or a larger --cell-size");
  if (left_out > 0 && !arguments.quiet)
    std::cerr << path << ": left out " << left_out << " problems that the robot cannot solve\n";
  return imported;
}

/// What Slalom exported has its task beside it.
Scenario with_task_of(const Scenario& map, const std::string& path) {
  const auto task = read_map_task(path);
  if (!task)
    throw usage_error("import " + path, "a map has no start and goal",
                      "--start x,y,phi --goal x,y, or --pairs N");
  return map.with_task(task->start, task->goal).renamed(task->name);
}

Imported import_map(const std::string& path, const ImportArguments& arguments) {
  const bool has_points = is_point_map(path) && arguments.problems.empty();
  const Scenario map = has_points ? point_map_scenario(path, arguments.points)
                                  : map_scenario(path, load_map(path, arguments.map));
  if (!arguments.problems.empty()) return import_problems(map, arguments);
  if (arguments.pairs > 0) return {draw_pairs(map, arguments), ""};
  if (arguments.start.empty() || arguments.goal.empty()) return {{with_task_of(map, path)}, ""};
  const auto s = numbers_of("--start", arguments.start, 2, 3);
  const auto g = numbers_of("--goal", arguments.goal, 2, 2);
  const Scenario scenario = map.with_task({s[0], s[1], s[2]}, {g[0], g[1]});
  expect_solvable(scenario, arguments.robot_radius);
  return {{scenario}, ""};
}

Imported import_file(const std::string& path, const ImportArguments& arguments) {
  if (ends_with(path, ".scenario.yaml")) return {{load_scenario_yaml(path)}, ""};
  if (is_barn(path)) {
    BarnOptions options = arguments.barn;
    options.representation =
        arguments.barn_as_grid ? Representation::Grid : Representation::Continuous;
    return {import_barn(path, options), ""};
  }
  return import_map(path, arguments);
}

void import(const ImportArguments& arguments) {
  Imported all;
  for (const std::string& path : arguments.files) {
    Imported imported = import_file(path, arguments);
    for (Scenario& scenario : imported.scenarios) all.scenarios.push_back(std::move(scenario));
    all.published_lengths += imported.published_lengths;
  }
  std::vector<std::pair<std::string, std::string>> notes = {
      {"origin", "imported: " + join(arguments.files, " ")}};
  if (!all.published_lengths.empty())
    notes.emplace_back("published_lengths", all.published_lengths);
  keep_scenarios(arguments.output, std::move(all.scenarios), notes, arguments.quiet);
}

void add_pair_options(CLI::App& verb, ImportArguments& arguments) {
  verb.add_option("--start", arguments.start, "Start pose x,y,phi (m, rad)");
  verb.add_option("--goal", arguments.goal, "Goal x,y (m)");
  verb.add_option("--pairs", arguments.pairs, "Draw this many solvable pairs on each map")
      ->check(CLI::PositiveNumber);
  verb.add_option("--seed", arguments.seed, "Seed of the pairs")->capture_default_str();
  verb.add_option("--robot-radius", arguments.robot_radius, "For whom, m")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

/// Which pairs are drawn.
void add_limit_options(CLI::App& verb, TaskLimits& limits) {
  verb.add_option("--min-distance", limits.min_distance, "Straight from start to goal, m")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  verb.add_option("--max-distance", limits.max_distance, "Straight from start to goal, m")
      ->check(CLI::PositiveNumber);
  verb.add_option("--min-path", limits.min_length, "Length of the shortest path, m")
      ->check(CLI::NonNegativeNumber);
  verb.add_option("--max-path", limits.max_length, "Length of the shortest path, m")
      ->check(CLI::PositiveNumber);
  verb.add_option("--min-detour", limits.min_detour, "Length of the shortest path / distance")
      ->check(CLI::PositiveNumber);
  verb.add_option("--max-detour", limits.max_detour, "Length of the shortest path / distance")
      ->check(CLI::PositiveNumber);
}

void add_map_options(CLI::App& verb, ImportArguments& arguments) {
  MapImportOptions& map = arguments.map;
  verb.add_option("--simplemap-resolution", map.simplemap_resolution,
                  "Cell size of grids built from simplemaps, m")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  verb.add_flag("--unknown-free", map.unknown_is_free, "What was never seen is free");
  verb.add_option("--image-resolution", map.image.resolution, "Size of an image's pixels, m")
      ->check(CLI::PositiveNumber);
  verb.add_option("--image-threshold", map.image.threshold,
                  "Grey value below which a pixel is an obstacle")
      ->check(CLI::Range(1, 255))
      ->capture_default_str();
  PointMapOptions& points = arguments.points;
  verb.add_option("--margin", points.margin, "Of workspaces around point maps, m")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  verb.add_option("--z-min", points.z_min, "Lowest points of point maps that count, m");
  verb.add_option("--z-max", points.z_max, "Highest points of point maps that count, m");
  verb.add_flag("--image-negate", map.image.negate, "Light pixels are obstacles, not dark ones");
}

void add_data_set_options(CLI::App& verb, ImportArguments& arguments) {
  verb.add_option("--worlds", arguments.barn.worlds,
                  "BARN: which worlds of a folder, such as 0-9,20 or 0-299/even (default: all)");
  verb.add_flag("--barn-grid", arguments.barn_as_grid,
                "BARN: cells of 0.15 m instead of cylinders");
  verb.add_option("--cell-size", arguments.map.cell_size, "MovingAI: size of the map's cells, m")
      ->check(CLI::PositiveNumber);
  verb.add_option("--scen", arguments.problems,
                  "MovingAI: the pairs of this file; --pairs then says how many of them");
  verb.add_option("--buckets", arguments.buckets,
                  "MovingAI: only pairs of these difficulties, such as 3 or 0-10");
}

}  // namespace

void add_import_verb(CLI::App& app) {
  static ImportArguments arguments;
  CLI::App* verb = app.add_subcommand(
      "import", "Import maps (MRPT, ROS, MovingAI, images), BARN worlds or .scenario.yaml files");
  verb->add_option("files", arguments.files, "Map files, .scenario.yaml, grids or folders of BARN")
      ->required();
  verb->add_option("-o,--output", arguments.output, "The list to write (.scenarios)")->required();
  add_pair_options(*verb, arguments);
  add_limit_options(*verb, arguments.limits);
  add_map_options(*verb, arguments);
  add_data_set_options(*verb, arguments);
  verb->add_flag("--quiet", arguments.quiet, "No messages");
  verb->callback([] { import(arguments); });
}

}  // namespace slalom
