// SPDX-License-Identifier: BSD-3-Clause
#include "import_problems.h"

#include <slalom/campaign/scenario_sources.h>
#include <slalom/core/distance.h>
#include <slalom/core/error.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/io/scenario_yaml.h>
#include <slalom/map_formats/arena_scenario.h>
#include <slalom/map_formats/map_pairs.h>
#include <slalom/map_formats/map_task.h>
#include <slalom/map_formats/world_import.h>
#include <slalom/rawlog/log_map.h>

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// x, y and, if it is given, phi.
std::vector<double> pose_numbers(const std::string& option, const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& part : split(text, ',')) {
    numbers.emplace_back();
    if (!parse_number(part, numbers.back())) numbers.clear();
  }
  if (numbers.size() < 2 || numbers.size() > 3)
    throw usage_error(option + " " + text, "invalid pose", "x,y or x,y,phi in m and rad");
  return numbers;
}

void require_solvable(const Scenario& scenario, double robot_radius, const std::string& where) {
  std::string reason;
  if (!is_solvable(scenario, robot_radius, reason))
    throw job_error(where, "unsolvable pair of start and goal: " + reason,
                    "a start and a goal with a collision-free path");
}

std::vector<Scenario> sample_pairs(const Scenario& map, const ImportRequest& request) {
  GenerationSettings task;
  task.count = sampled_pairs(request);
  task.seed = request.seed;
  task.robot_radius = request.robot_radius;
  task.name_prefix = map.name();
  return sample_tasks(map, task, request.limits);
}

/// The map with the start and goal that Slalom exported with it.
Scenario with_stored_task(const ImportedWorld& map, const std::string& path) {
  const auto task = read_map_task(path);
  if (task)
    return map.scenario.with_start_goal(task->start, task->goal)
        .with_goal_heading(task->goal_heading)
        .renamed(task->name);
  if (map.start && map.goal) return map.scenario;
  throw usage_error("import " + path,
                    map.start ? "the map has a start and no goal" : "the map has no start and goal",
                    map.start ? "--goal x,y" : "--start x,y,phi --goal x,y, or --pairs N");
}

/// The surroundings of a drive, from where it began to where it ended.
ImportedWorld read_log(const std::string& path, const ImportRequest& request) {
  LogMap log = load_log_map(path, {request.map.simplemap_resolution, request.robot_radius,
                                   request.map.unknown_is_free, request.topics});
  ImportedWorld world{map_scenario(path, log.grid).with_start_goal(log.start, log.goal)};
  world.start = log.start;
  constexpr double kMinDistance = 1;  // m
  const double distance = distance_between(TPoint2D(log.start), log.goal);
  if (distance >= kMinDistance)
    world.goal = log.goal;
  else
    log.notes.push_back("it ends " + format_fixed(distance, 2) +
                        " m from its start, too near to be a goal");
  world.message = path + ": " + join(log.notes, "; ");
  return world;
}

ImportedWorld read_map(const std::string& path, const ImportRequest& request) {
  if (is_log(path)) return read_log(path, request);
  if (is_arena_scenario(path)) return import_arena_scenario(path, request.map);
  if (is_world(path)) {
    WorldOptions options;
    options.margin = request.points.margin;
    if (std::isfinite(request.points.z_min)) options.z_min = request.points.z_min;
    if (std::isfinite(request.points.z_max)) options.z_max = request.points.z_max;
    return import_world(path, options);
  }
  if (is_point_map(path) && request.problems.empty())
    return {point_map_scenario(path, request.points)};
  std::vector<std::string> notes;
  MapImportOptions options = request.map;
  options.notes = &notes;
  ImportedWorld world{map_scenario(path, load_map(path, options))};
  if (!notes.empty()) world.message = path + ": " + join(notes, "; ");
  return world;
}

/// The pose of --start, if it is given.
std::optional<mrpt::math::TPose2D> requested_start(const ImportRequest& request) {
  if (request.start.empty()) return std::nullopt;
  const std::vector<double> s = pose_numbers("--start", request.start);
  return mrpt::math::TPose2D(s[0], s[1], s.size() > 2 ? s[2] : 0);
}

/// The map with each pair of a file.
std::vector<Scenario> with_pairs_of_file(const ImportedWorld& map, const ImportRequest& request) {
  if (!request.goal.empty())
    throw usage_error("--goal", request.pairs + " has the goals", "either of them");
  std::optional<mrpt::math::TPose2D> start = requested_start(request);
  if (!start) start = map.start;
  std::vector<Scenario> scenarios;
  for (const MapPair& pair : read_map_pairs(request.pairs, start)) {
    Scenario scenario = map.scenario.with_start_goal(pair.start, pair.goal)
                            .with_goal_heading(pair.goal_heading)
                            .renamed(map.scenario.name() + "_line" + std::to_string(pair.line));
    require_solvable(scenario, request.robot_radius,
                     request.pairs + ":" + std::to_string(pair.line));
    scenarios.push_back(std::move(scenario));
  }
  return scenarios;
}

/// The map with the pose and the position of the request; what is missing there, the map states.
Scenario with_task(const ImportedWorld& map, const ImportRequest& request) {
  const auto requested = requested_start(request);
  const auto start = requested ? requested : map.start;
  auto goal = map.goal;
  std::optional<double> heading;
  if (!request.goal.empty()) {
    const auto g = pose_numbers("--goal", request.goal);
    goal = {g[0], g[1]};
    if (g.size() > 2) heading = g[2];
  }
  Scenario scenario = map.scenario.with_start_goal(start.value(), goal.value());
  if (heading) scenario = scenario.with_goal_heading(heading);
  require_solvable(scenario, request.robot_radius, scenario.name());
  return scenario;
}

ImportedFile import_map(const std::string& path, const ImportRequest& request) {
  const ImportedWorld map = read_map(path, request);
  if (!request.problems.empty()) return import_problems(map.scenario, request);
  ImportedFile file;
  if (!map.message.empty()) file.messages.push_back(map.message);
  const bool has_start = !request.start.empty(), has_goal = !request.goal.empty();
  if (sampled_pairs(request) > 0)
    file.scenarios = sample_pairs(map.scenario, request);
  else if (!request.pairs.empty())
    file.scenarios = with_pairs_of_file(map, request);
  else if ((has_start || has_goal) && (has_start || map.start) && (has_goal || map.goal))
    file.scenarios = {with_task(map, request)};
  else
    file.scenarios = {with_stored_task(map, path)};
  return file;
}

ImportedFile import_file(const std::string& path, const ImportRequest& request) {
  if (ends_with(path, ".scenario.yaml")) return {{load_scenario_yaml(path)}};
  if (is_barn(path)) {
    BarnOptions options = request.barn;
    options.representation =
        request.barn_as_grid ? Representation::Grid : Representation::Continuous;
    return {import_barn(path, options)};
  }
  return import_map(path, request);
}

}  // namespace

int sampled_pairs(const ImportRequest& request) {
  long long count = 0;
  if (request.pairs.empty()) return 0;
  if (!parse_integer(request.pairs, count)) {
    require_regular_file(request.pairs, "pairs of start and goal");
    return 0;
  }
  if (count < 1 || count > 1'000'000)
    throw usage_error("--pairs", request.pairs + " is out of range",
                      "1 to 1000000, or a file of pairs");
  return static_cast<int>(count);
}

ImportedScenarios import_scenarios(const ImportRequest& request, Progress& progress) {
  ImportedScenarios all;
  std::string published_lengths;
  progress.start("Importing files", request.files.size());
  for (std::size_t i = 0; i < request.files.size(); ++i) {
    ImportedFile imported = import_file(request.files[i], request);
    for (Scenario& scenario : imported.scenarios) all.scenarios.push_back(std::move(scenario));
    for (std::string& message : imported.messages) all.messages.push_back(std::move(message));
    published_lengths += imported.published_lengths;
    progress.advance(i + 1);
  }
  progress.finish();
  all.notes.emplace_back("origin", "imported: " + join(request.files, " "));
  if (!published_lengths.empty()) all.notes.emplace_back("published_lengths", published_lengths);
  return all;
}

}  // namespace slalom
