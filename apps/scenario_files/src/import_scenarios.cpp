// SPDX-License-Identifier: BSD-3-Clause
#include "import_problems.h"

#include <slalom/campaign/scenario_sources.h>
#include <slalom/core/distance.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/scenario_yaml.h>
#include <slalom/map_formats/map_task.h>
#include <slalom/rawlog/log_map.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

std::vector<double> numbers_of(const std::string& option, const std::string& text,
                               std::size_t min_count, std::size_t max_count) {
  std::vector<double> numbers;
  for (const std::string& part : split(text, ',')) {
    double number = 0;
    if (!parse_number(part, number)) numbers.resize(max_count + 1);
    numbers.push_back(number);
  }
  if (numbers.size() < min_count || numbers.size() > max_count)
    throw usage_error(option + " " + text,
                      "invalid " + std::string(max_count == 3 ? "pose" : "position"),
                      max_count == 3 ? "x,y,phi in m and rad" : "x,y in m");
  numbers.resize(max_count);
  return numbers;
}

void require_solvable(const Scenario& scenario, double robot_radius) {
  std::string reason;
  if (!is_solvable(scenario, robot_radius, reason))
    throw job_error(scenario.name(), "unsolvable pair of start and goal: " + reason,
                    "a start and a goal with a collision-free path");
}

std::vector<Scenario> sample_pairs(const Scenario& map, const ImportRequest& request) {
  GenerationSettings task;
  task.count = request.pairs;
  task.seed = request.seed;
  task.robot_radius = request.robot_radius;
  task.name_prefix = map.name();
  return sample_tasks(map, task, request.limits);
}

/// The map with the start and goal that Slalom exported with it.
Scenario with_stored_task(const Scenario& map, const std::string& path) {
  const auto task = read_map_task(path);
  if (!task)
    throw usage_error("import " + path, "the map has no start and goal",
                      "--start x,y,phi --goal x,y, or --pairs N");
  return map.with_start_goal(task->start, task->goal).renamed(task->name);
}

/// The map with the start and goal of the command line.
Scenario with_given_task(const Scenario& map, const ImportRequest& request) {
  const auto s = numbers_of("--start", request.start, 2, 3);
  const auto g = numbers_of("--goal", request.goal, 2, 2);
  return map.with_start_goal({s[0], s[1], s[2]}, {g[0], g[1]});
}

ImportedFile import_map(const std::string& path, const ImportRequest& request) {
  const bool has_points = is_point_map(path) && request.problems.empty();
  const Scenario map = has_points ? point_map_scenario(path, request.points)
                                  : map_scenario(path, load_map(path, request.map));
  if (!request.problems.empty()) return import_problems(map, request);
  if (request.pairs > 0) return {sample_pairs(map, request)};
  if (request.start.empty() || request.goal.empty()) return {{with_stored_task(map, path)}};
  const Scenario scenario = with_given_task(map, request);
  require_solvable(scenario, request.robot_radius);
  return {{scenario}};
}

/// From where a drive began to where it ended, unless there is another start and goal.
ImportedFile import_log(const std::string& path, const ImportRequest& request) {
  const LogMap log = load_log_map(path, {request.map.simplemap_resolution, request.robot_radius,
                                         request.map.unknown_is_free, request.topics});
  ImportedFile imported;
  for (const std::string& note : log.notes) imported.messages.push_back(path + ": " + note);
  const Scenario map = map_scenario(path, log.grid);
  if (request.pairs > 0) {
    imported.scenarios = sample_pairs(map, request);
    return imported;
  }
  const bool is_given = !request.start.empty() && !request.goal.empty();
  constexpr double kMinDistance = 1;  // m
  const double distance = distance_between(TPoint2D(log.start), log.goal);
  if (!is_given && distance < kMinDistance)
    throw usage_error("import " + path,
                      "the drive ends " + format_fixed(distance, 2) + " m from its start",
                      "--start x,y,phi --goal x,y, or --pairs N");
  imported.scenarios = {is_given ? with_given_task(map, request)
                                 : map.with_start_goal(log.start, log.goal)};
  require_solvable(imported.scenarios[0], request.robot_radius);
  return imported;
}

ImportedFile import_file(const std::string& path, const ImportRequest& request) {
  if (ends_with(path, ".scenario.yaml")) return {{load_scenario_yaml(path)}};
  if (is_barn(path)) {
    BarnOptions options = request.barn;
    options.representation =
        request.barn_as_grid ? Representation::Grid : Representation::Continuous;
    return {import_barn(path, options)};
  }
  return is_log(path) ? import_log(path, request) : import_map(path, request);
}

}  // namespace

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
