// SPDX-License-Identifier: BSD-3-Clause
#include "import_problems.h"

#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/text.h>
#include <slalom/map_formats/moving_ai.h>
#include <slalom/references/exact_shortest.h>

#include <cmath>

namespace slalom {

bool is_solvable(const Scenario& scenario, double robot_radius, std::string& reason) {
  const World world(scenario, 0.05);
  const auto& start = scenario.start();
  const PlanningProblem problem{world, robot_radius, {start.x, start.y}, scenario.goal()};
  return exact_shortest_path(problem, reason).has_value();
}

namespace {

/// "3" or "3-10".
ProblemSelection problem_choice(const ImportRequest& request) {
  ProblemSelection choice;
  choice.count = sampled_pairs(request);
  if (choice.count == 0 && !request.pairs.empty())
    throw usage_error("--pairs", request.problems + " has the pairs", "how many of them");
  if (request.buckets.empty()) return choice;
  const std::size_t dash = request.buckets.find('-');
  const std::string first = request.buckets.substr(0, dash),
                    last = dash == std::string::npos ? first : request.buckets.substr(dash + 1);
  long long low = 0, high = 0;
  if (!parse_integer(first, low) || !parse_integer(last, high) || low < 0 || high < low ||
      high > 1'000'000'000)
    throw usage_error("--buckets " + request.buckets, "invalid range of difficulties",
                      "such as 3 or 0-10");
  choice.first_bucket = static_cast<int>(low);
  choice.last_bucket = static_cast<int>(high);
  return choice;
}

/// The initial heading is towards the goal, since the file does not specify it.
Scenario problem_scenario(const Scenario& map, const MovingAiProblem& problem, double cell_size,
                          const std::string& where) {
  if (problem.map_width != static_cast<int>(map.grid_map()->getSizeX()) ||
      problem.map_height != static_cast<int>(map.grid_map()->getSizeY()))
    throw file_error(where,
                     "belongs to a map of " + std::to_string(problem.map_width) + " x " +
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
  return map
      .with_start_goal({start.x, start.y, math::atan2(goal.y - start.y, goal.x - start.x)}, goal)
      .renamed(map.name() + "_bucket" + std::to_string(problem.bucket) + "_line" +
               std::to_string(problem.line));
}

}  // namespace

ImportedFile import_problems(const Scenario& map, const ImportRequest& request) {
  const std::string& path = request.problems;
  const double cell_size = map.grid_map()->getResolution();
  const auto problems = select_problems(read_moving_ai_problems(path), problem_choice(request));
  if (problems.empty())
    throw usage_error("--scen " + path, "no problems of that difficulty", "--buckets of the file");
  ImportedFile imported;
  std::string reason;
  for (const MovingAiProblem& problem : problems) {
    const Scenario scenario =
        problem_scenario(map, problem, cell_size, path + ":" + std::to_string(problem.line));
    if (!is_solvable(scenario, request.robot_radius, reason)) continue;
    imported.scenarios.push_back(scenario);
    imported.published_lengths +=
        scenario.name() + " " + format_number(problem.published_length) + " cells, 8-connected\n";
  }
  const std::size_t left_out = problems.size() - imported.scenarios.size();
  if (imported.scenarios.empty())
    throw job_error(path,
                    "no problem is solvable for a robot of radius " +
                        format_number(request.robot_radius) + " m (" + reason + ")",
                    "a smaller --robot-radius or a larger --cell-size");
  if (left_out > 0)
    imported.messages.push_back(path + ": left out " + std::to_string(left_out) +
                                " problems that are unsolvable for the robot");
  return imported;
}

}  // namespace slalom
