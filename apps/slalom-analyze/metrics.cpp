#include "metrics.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/app/campaign_program.h>
#include <slalom/campaign/measure.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/scenario_yaml.h>
#include <slalom/io/trajectory_file.h>
#include <slalom/metrics/metric.h>
#include <slalom/ompl/ompl_planner.h>
#include <slalom/simulation/judge_trajectory.h>

#include <nlohmann/json.hpp>

#include <iostream>

namespace slalom {
namespace {

using Json = nlohmann::ordered_json;

struct MetricsArguments {
  std::string trajectory, scenario, outcome, radius;
  CampaignArguments campaign;
  bool json = false;
};

/// All that is known of a log when it is measured.
struct MeasuredLog {
  SimulationResult run;
  std::map<std::string, VersionedValue> metrics;
  std::vector<std::string> notes;
};

/// What the command line says, over the campaign's .ini where there is one.
IniFile measuring_ini(const MetricsArguments& arguments) {
  CampaignArguments campaign = arguments.campaign;
  if (!arguments.radius.empty()) campaign.overrides.push_back("robot.radius=" + arguments.radius);
  if (!campaign.config.empty()) return load_campaign_ini(campaign);
  IniFile ini = IniFile::from_text("", "command line");
  ini.set("reference", "planner", "exact");
  for (const std::string& assignment : campaign.overrides) ini.override_key(assignment);
  ini.reject_unknown_sections({"robot", "simulation", "reference", "metrics"});
  return ini;
}

Outcome named_outcome(const std::string& name) {
  std::vector<std::string> names;
  for (const Outcome outcome : all_outcomes()) {
    if (to_string(outcome) == name) return outcome;
    names.push_back(to_string(outcome));
  }
  throw usage_error("--outcome", "'" + name + "' is unknown", "one of " + join(names, ", "));
}

/// As the user says, the log whole; otherwise as the judge of simulations would.
SimulationResult judged(const MetricsArguments& arguments, const CampaignOptions& options,
                        const World& world, const Trajectory& log) {
  if (arguments.outcome.empty())
    return judge_trajectory(world, options.setup.robot, options.setup.simulation, log);
  SimulationResult run;
  run.outcome = named_outcome(arguments.outcome);
  run.detail = "as given";
  run.trajectory = log;
  return run;
}

/// What a user should know about where the log lies in the scenario.
std::vector<std::string> remarks(const World& world, const CampaignOptions& options,
                                 const Trajectory& log, const SimulationResult& run) {
  std::vector<std::string> notes;
  const auto& start = world.scenario().start();
  const auto& first = log.samples.front().pose;
  const double off = length({{start.x, start.y}, {first.x, first.y}});
  if (off > options.setup.simulation.goal_tolerance)
    notes.push_back("the log begins " + format_fixed(off, 2) +
                    " m beside the scenario's start, from which the references lead");
  const double rest = log.duration() - run.trajectory.duration();
  if (rest > 0)
    notes.push_back("the last " + format_fixed(rest, 2) +
                    " s of the log are left out: " + run.detail);
  return notes;
}

MeasuredLog measure(const MetricsArguments& arguments, const CampaignOptions& options,
                    const IniFile& ini, const World& world) {
  const auto planning = read_options<OmplOptions>(ini, "reference");
  const auto planner = make_ompl_planner(planning, options.setup.robot);
  CampaignOptions with_gap = options;
  with_gap.reference_gap = planning.gap;
  TrajectoryFile file = load_trajectory_file(arguments.trajectory, options.setup.robot.holonomic());
  MeasuredLog log;
  log.run = judged(arguments, options, world, file.trajectory);
  log.notes = file.notes;
  for (const std::string& note : remarks(world, options, file.trajectory, log.run))
    log.notes.push_back(note);
  log.metrics = measure_run(with_gap, world, find_references(with_gap, planner.get(), world),
                            log.run.trajectory, log.run.outcome);
  return log;
}

std::string text_of(const MeasuredLog& log, const CampaignOptions& options) {
  const auto line = [](const std::string& name, const std::string& value) {
    return pad_right(name, 28) + "  " + value + "\n";
  };
  std::string text = line("outcome", to_string(log.run.outcome) + " (" + log.run.detail + ")");
  for (const std::string& id : options.metrics) {
    const Value& value = log.metrics.at(id).value;
    const QuantityInfo info = metric(id).info();
    const std::string unit = info.unit == "-" ? "" : " " + info.unit;
    text +=
        line(id + " v" + std::to_string(info.version),
             value.is_na() ? "NA (" + value.reason() + ")" : format_number(value.number()) + unit);
  }
  return text;
}

Json to_json(const MeasuredLog& log, const Scenario& scenario) {
  Json metrics = Json::object();
  for (const auto& [id, versioned] : log.metrics) {
    const Value& value = versioned.value;
    metrics[id] = value.is_na() ? Json{{"na", value.reason()}} : Json{{"value", value.number()}};
    metrics[id]["version"] = versioned.version;
  }
  return {{"scenario", {{"hash", scenario.hash()}, {"name", scenario.name()}}},
          {"outcome", to_string(log.run.outcome)},
          {"outcome_detail", log.run.detail},
          {"trajectory", log.run.trajectory.hash()},
          {"notes", log.notes},
          {"metrics", metrics}};
}

void run(const MetricsArguments& arguments) {
  const IniFile ini = measuring_ini(arguments);
  const CampaignOptions options =
      ini.has_section("campaign") ? read_campaign_options(ini) : read_measuring_options(ini);
  if (!arguments.outcome.empty()) named_outcome(arguments.outcome);
  const World world(load_scenario_yaml(arguments.scenario), options.setup.simulation.resolution);
  const MeasuredLog log = measure(arguments, options, ini, world);
  if (arguments.json)
    std::cout << to_json(log, world.scenario()).dump() << "\n";
  else
    std::cout << text_of(log, options);
  if (arguments.campaign.quiet || arguments.json) return;
  for (const std::string& note : log.notes)
    std::cerr << arguments.trajectory << ": " << note << "\n";
}

}  // namespace

void define_metrics(CLI::App& app) {
  static MetricsArguments arguments;
  CLI::App* verb =
      app.add_subcommand("metrics", "Compute the metrics of a trajectory from any robot's log");
  verb->add_option("--trajectory", arguments.trajectory,
                   "The log: CSV with a header line t,x,y,phi[,v,w,...], or TUM")
      ->required();
  verb->add_option("--scenario", arguments.scenario, "Where it was driven (YAML)")->required();
  verb->add_option("-c,--config", arguments.campaign.config,
                   "A campaign .ini whose robot, rules and reference hold");
  verb->add_option("--set", arguments.campaign.overrides,
                   "Override a key of the .ini: SECTION.KEY=VALUE")
      ->take_all()
      ->allow_extra_args(false);
  verb->add_option("--robot-radius", arguments.radius, "m; short for --set robot.radius=");
  verb->add_option("--outcome", arguments.outcome,
                   "How the run ended, e.g. success; otherwise judged from the log");
  verb->add_flag("--json", arguments.json, "One JSON object");
  verb->add_flag("--quiet", arguments.campaign.quiet, "No remarks on standard error");
  verb->callback([] { run(arguments); });
}

}  // namespace slalom
