#include "generate.h"
#include "generate_coverage.h"

#include <slalom/commands/keep_generated.h>
#include <slalom/commands/scenario_sources.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/scenario_list.h>
#include <slalom/map_formats/map_import.h>
#include <slalom/robot/robot_model.h>
#include <slalom/simulation/simulate.h>

#include <iostream>

namespace slalom {
namespace {

struct GenerateArguments {
  std::string config, output, descriptors;
  std::vector<std::string> overrides;
  int count = 0, jobs = 1;
  std::uint64_t seed = 1;
  bool quiet = false, json = false;
};

IniFile load_ini(const GenerateArguments& arguments) {
  IniFile ini = IniFile::load(arguments.config);
  for (const std::string& assignment : arguments.overrides) ini.override_key(assignment);
  ini.reject_unknown_sections({"campaign", "scenarios", "coverage", "generator.*", "robot",
                               "sensor", "odometry", "simulation", "reference", "metrics", "limits",
                               "record", "analysis", "method.*"});
  if (arguments.count > 0) {
    const bool fills_bins = ini.has_section("coverage");
    ini.set(fills_bins ? "coverage" : "scenarios", fills_bins ? "per_bin" : "count",
            std::to_string(arguments.count));
  }
  return ini;
}

SourceContext source_context(const GenerateArguments& arguments, const IniFile& ini) {
  const RobotModel robot = read_robot_model(ini);
  SourceContext context;
  context.robot_radius = robot.radius;
  context.resolution = read_options<SimulationOptions>(ini, "simulation").resolution;
  context.seed = arguments.seed;
  context.jobs = arguments.jobs;
  DescribeOptions described;
  described.ids = split(arguments.descriptors, ',');
  for (const std::string& id : described.ids) descriptor(id);  // a wrong one is told at once
  described.robot = robot.shape();
  described.sensor_range = read_options<SensorModel>(ini, "sensor").max_range;
  if (!described.ids.empty())
    context.describe = [described](const World& world) {
      return generated_values(world, described);
    };
  return context;
}

void generate(const GenerateArguments& arguments) {
  const IniFile ini = load_ini(arguments);
  if (ini.has_section("coverage")) {
    if (!arguments.descriptors.empty())
      throw usage_error("--describe", "does not go with [coverage]", "descriptors in that section");
    generate_by_coverage(
        ini, {arguments.output, arguments.seed, arguments.jobs, arguments.quiet, arguments.json});
    return;
  }
  const SourceContext context = source_context(arguments, ini);
  const auto progress = make_terminal_progress(arguments.quiet);
  std::size_t size = 0;
  ScenarioList::write(arguments.output, [&](ScenarioList& list) {
    stream_scenarios(
        ini, context, load_occupancy_grid, *progress,
        [&](std::vector<GeneratedScenario>& part) { return keep_generated(list, part); });
    list.set_note("origin", "seed " + std::to_string(arguments.seed) + "\n" + ini.canonical_text());
    size = list.size();
  });
  if (!arguments.quiet) std::cerr << arguments.output << ": " << size << " scenarios\n";
}

}  // namespace

void add_generate_verb(CLI::App& app) {
  static GenerateArguments arguments;
  CLI::App* verb = app.add_subcommand("generate", "Generate scenarios that the robot can solve");
  verb->add_option("-c,--config", arguments.config,
                   "An .ini with [scenarios] generator = NAME, or several names")
      ->required();
  verb->add_option(
          "-n,--count", arguments.count,
          "How many, instead of [scenarios] count; in each bin, instead of [coverage] per_bin")
      ->check(CLI::PositiveNumber);
  verb->add_option("--seed", arguments.seed, "Seed")->capture_default_str();
  verb->add_option("-j,--jobs", arguments.jobs, "Threads; the list is the same for any number")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  verb->add_option("--describe", arguments.descriptors,
                   "Descriptors to compute and keep at once, comma separated");
  verb->add_option("-o,--output", arguments.output, "The list to write (.scenarios)")->required();
  verb->add_option("--set", arguments.overrides, "Override a key: SECTION.KEY=VALUE")
      ->allow_extra_args(false);
  verb->add_flag("--json", arguments.json, "The table of [coverage] as one JSON object");
  verb->add_flag("--quiet", arguments.quiet, "No progress and no messages");
  verb->callback([] { generate(arguments); });
}

}  // namespace slalom
