#include "import_problems.h"

#include <slalom/commands/scenario_sources.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/scenario_yaml.h>
#include <slalom/map_formats/map_task.h>

namespace slalom {
namespace {

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
  std::string reason;
  if (!is_solvable(scenario, robot_radius, reason))
    throw job_error(scenario.name(), "the pair of start and goal is unsolvable: " + reason,
                    "a start and a goal between which the robot fits");
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::vector<Scenario> draw_pairs(const Scenario& map, const ImportRequest& request) {
  GenerationTask task;
  task.count = request.pairs;
  task.seed = request.seed;
  task.robot_radius = request.robot_radius;
  task.name_prefix = map.name();
  return draw_tasks(map, task, request.limits);
}

/// What Slalom exported has its task beside it.
Scenario with_task_of(const Scenario& map, const std::string& path) {
  const auto task = read_map_task(path);
  if (!task)
    throw usage_error("import " + path, "a map has no start and goal",
                      "--start x,y,phi --goal x,y, or --pairs N");
  return map.with_task(task->start, task->goal).renamed(task->name);
}

ImportedFile import_map(const std::string& path, const ImportRequest& request) {
  const bool has_points = is_point_map(path) && request.problems.empty();
  const Scenario map = has_points ? point_map_scenario(path, request.points)
                                  : map_scenario(path, load_map(path, request.map));
  if (!request.problems.empty()) return import_problems(map, request);
  if (request.pairs > 0) return {draw_pairs(map, request)};
  if (request.start.empty() || request.goal.empty()) return {{with_task_of(map, path)}};
  const auto s = numbers_of("--start", request.start, 2, 3);
  const auto g = numbers_of("--goal", request.goal, 2, 2);
  const Scenario scenario = map.with_task({s[0], s[1], s[2]}, {g[0], g[1]});
  expect_solvable(scenario, request.robot_radius);
  return {{scenario}};
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

ImportedScenarios import_scenarios(const ImportRequest& request, Progress& progress) {
  ImportedScenarios all;
  std::string published_lengths;
  progress.start("Importing files", request.files.size());
  for (std::size_t i = 0; i < request.files.size(); ++i) {
    progress.advance(i);
    ImportedFile imported = import_file(request.files[i], request);
    for (Scenario& scenario : imported.scenarios) all.scenarios.push_back(std::move(scenario));
    for (std::string& message : imported.messages) all.messages.push_back(std::move(message));
    published_lengths += imported.published_lengths;
  }
  progress.finish();
  all.notes.emplace_back("origin", "imported: " + join(request.files, " "));
  if (!published_lengths.empty()) all.notes.emplace_back("published_lengths", published_lengths);
  return all;
}

}  // namespace slalom
