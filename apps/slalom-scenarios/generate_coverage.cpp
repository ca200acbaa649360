#include "generate_coverage.h"

#include <slalom/commands/keep_covered.h>
#include <slalom/commands/scenario_sources.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/map_formats/map_import.h>
#include <slalom/robot/robot_model.h>
#include <slalom/simulation/simulate.h>

#include <nlohmann/json.hpp>

#include <iostream>

namespace slalom {
namespace {

using Json = nlohmann::ordered_json;

/// The families of [scenarios]; coverage has no use for the other sources.
std::vector<std::string> families_of(const IniFile& ini) {
  const auto section = read_options<ScenariosSection>(ini, "scenarios");
  for (const char* key : {"list", "maps", "count", "weights", "scale_by_robot", "representation"})
    if (ini.get("scenarios", key))
      throw usage_error(ini.where("scenarios", key), "does not go with [coverage]",
                        "generator only; the bins say how many");
  std::vector<std::string> families;
  for (const std::string& name : split(section.generator, ','))
    if (!name.empty()) families.push_back(name);
  return families;
}

CoverageTask task_of(const IniFile& ini, const CoverageArguments& arguments) {
  CoverageTask task;
  task.seed = arguments.seed;
  task.robot_radius = read_robot_model(ini).radius;
  task.sensor_range = read_options<SensorModel>(ini, "sensor").max_range;
  task.resolution = read_options<SimulationOptions>(ini, "simulation").resolution;
  task.jobs = arguments.jobs;
  task.load_map = load_occupancy_grid;
  return task;
}

Json to_json(const CoveragePlan& plan, const CoverageResult& result) {
  Json bins = Json::array();
  for (const BinReport& bin : result.bins) {
    Json json;
    for (std::size_t i = 0; i < plan.axes.size(); ++i)
      json[plan.axes[i].id] = {bin.intervals[i].first, bin.intervals[i].second};
    json["wanted"] = bin.wanted;
    json["found"] = bin.found;
    json["effort"] = bin.effort;
    json["verdict"] = to_string(bin.verdict);
    if (!bin.why.empty()) json["why"] = bin.why;
    bins.push_back(json);
  }
  return {{"bins", bins},
          {"scenarios", result.scenarios.size()},
          {"evaluations", result.evaluations},
          {"stopped", result.stopped},
          {"repeatable", result.repeatable}};
}

}  // namespace

void generate_by_coverage(const IniFile& ini, const CoverageArguments& arguments) {
  const CoveragePlan plan = read_coverage_plan(ini, families_of(ini));
  const CoverageTask task = task_of(ini, arguments);
  const auto progress = make_terminal_progress(arguments.quiet);
  CoverageResult result;
  ScenarioList::write(arguments.output, [&](ScenarioList& list) {
    result = cover(plan, task, *progress);
    keep_covered(list, plan, result);
    list.set_note("origin", "seed " + std::to_string(arguments.seed) + "\n" + ini.canonical_text());
  });
  if (arguments.json)
    std::cout << to_json(plan, result).dump() << "\n";
  else if (!arguments.quiet)
    std::cout << render_coverage(plan, result);
  if (!arguments.quiet)
    std::cerr << arguments.output << ": " << result.scenarios.size() << " scenarios\n";
}

}  // namespace slalom
