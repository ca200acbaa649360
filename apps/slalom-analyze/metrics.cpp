// SPDX-License-Identifier: BSD-3-Clause
#include "log_table.h"
#include "metrics.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/app/campaign_program.h>
#include <slalom/app/checks.h>
#include <slalom/bags/bag.h>
#include <slalom/bags/bag_trajectory.h>
#include <slalom/campaign/evaluate_log.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/scenario_yaml.h>
#include <slalom/io/trajectory_file.h>
#include <slalom/metrics/metric.h>
#include <slalom/ompl/ompl_planner.h>

#include <iostream>

namespace slalom {
namespace {

struct MetricsArguments {
  std::string trajectory, topic, outcome, radius;
  CampaignArguments campaign;
  LogSelection selection;
  LogTableArguments table;
  bool json = false;
};

/// The campaign's .ini, if given, overridden by the command line.
IniFile metrics_ini(const MetricsArguments& arguments) {
  CampaignArguments campaign = arguments.campaign;
  if (!arguments.radius.empty()) campaign.overrides.push_back("robot.radius=" + arguments.radius);
  if (!campaign.config.empty()) return load_campaign_ini(campaign);
  IniFile ini = IniFile::from_text("", "command line");
  ini.set("reference", "planner", "exact");
  for (const std::string& assignment : campaign.overrides) ini.override_key(assignment);
  ini.reject_unknown_sections({"robot", "simulation", "reference", "metrics"});
  return ini;
}

Outcome parse_outcome(const std::string& name) {
  if (const auto outcome = from_name<Outcome>(name)) return *outcome;
  throw usage_error("--outcome", "unknown outcome '" + name + "'",
                    "one of " + join(names_of<Outcome>(), ", "));
}

/// The planner and its gap are those of [reference].
EvaluatedLog measure(CampaignOptions options, const IniFile& ini, const World& world,
                     const Trajectory& log, const std::string& outcome) {
  const auto planning = read_options<OmplOptions>(ini, "reference");
  const auto planner = make_ompl_planner(planning, options.robot);
  options.reference_gap = planning.gap;
  return evaluate_log(options, planner.get(), world, log,
                      outcome.empty() ? std::nullopt : std::optional(parse_outcome(outcome)));
}

std::string text_of(const EvaluatedLog& log, const CampaignOptions& options) {
  const auto line = [](const std::string& name, const std::string& value) {
    return pad_right(name, 28) + "  " + value + "\n";
  };
  std::string text = line("outcome", to_string(log.run.outcome) + " (" + log.run.detail + ")");
  for (const std::string& id : options.metrics) {
    const QuantityInfo& info = metric(id).info;
    text += line(id + " v" + std::to_string(info.version),
                 format_value(log.metrics.at(id).value, info.unit));
  }
  return text;
}

void refuse_topic(const MetricsArguments& arguments, const std::string& log) {
  if (!arguments.topic.empty())
    throw usage_error("--topic", log + " is not a bag of ROS", "a log without --topic, or a bag");
}

TrajectoryFile load_log(const MetricsArguments& arguments, const std::string& log, bool sideways) {
  if (is_bag(log)) return load_bag_trajectory(log, arguments.topic, sideways, arguments.selection);
  refuse_topic(arguments, log);
  return load_trajectory_file(log, sideways, arguments.selection);
}

std::vector<TrajectoryFile> load_runs(const MetricsArguments& arguments, const std::string& log,
                                      bool sideways) {
  if (!arguments.table.split || is_bag(log)) return {load_log(arguments, log, sideways)};
  refuse_topic(arguments, log);
  return load_trajectory_runs(log, sideways, arguments.selection);
}

/// One log, as text or JSON.
void print_log(const MetricsArguments& arguments, const IniFile& ini, CampaignOptions options) {
  const World world(load_scenario_yaml(arguments.table.scenario), options.simulation.resolution);
  options.adapt_to({world.scenario()});
  TrajectoryFile file = load_log(arguments, arguments.trajectory, options.robot.holonomic());
  EvaluatedLog log = measure(options, ini, world, file.trajectory, arguments.outcome);
  log.notes.insert(log.notes.begin(), file.notes.begin(), file.notes.end());
  if (arguments.json)
    std::cout << render_json(log, world.scenario()) << "\n";
  else
    std::cout << text_of(log, options);
  if (arguments.campaign.quiet || arguments.json) return;
  for (const std::string& note : log.notes)
    std::cerr << arguments.trajectory << ": " << note << "\n";
}

void require_arguments(const MetricsArguments& arguments) {
  const LogTableArguments& table = arguments.table;
  if (arguments.trajectory.empty() == table.logs.empty())
    throw usage_error("metrics", table.logs.empty() ? "no log" : "logs and --trajectory",
                      "--trajectory LOG for one log, or LOG... or FOLDER for a table");
  if (!table.logs.empty() && arguments.json)
    throw usage_error("--json", "with a table of logs", "--trajectory LOG");
  if (table.logs.empty() && (!table.name_pattern.empty() || !table.scenarios.empty() ||
                             !table.output.empty() || table.split))
    throw usage_error("--trajectory", "with an option for a table of logs",
                      "the log without --trajectory");
  if (table.logs.empty() && table.scenario.empty())
    throw usage_error("--scenario", "missing", "the scenario of the log (YAML)");
}

void run(const MetricsArguments& arguments) {
  require_arguments(arguments);
  const IniFile ini = metrics_ini(arguments);
  CampaignOptions options =
      ini.has_section("campaign") ? read_campaign_options(ini) : read_measuring_options(ini);
  if (!arguments.outcome.empty()) parse_outcome(arguments.outcome);
  if (arguments.table.logs.empty()) return print_log(arguments, ini, std::move(options));
  LogTableArguments table = arguments.table;
  table.quiet = arguments.campaign.quiet;
  print_log_table(
      table, options.simulation.resolution,
      [&](const std::string& log) { return load_runs(arguments, log, options.robot.holonomic()); },
      [&](const World& world, const Trajectory& log) {
        CampaignOptions adapted = options;
        adapted.adapt_to({world.scenario()});
        return measure(std::move(adapted), ini, world, log, arguments.outcome);
      });
}

void add_table_options(CLI::App& verb, LogTableArguments& table) {
  verb.add_option("logs", table.logs,
                  "Logs, or folders with logs: prints one table (CSV) with a row per run, for "
                  "slalom-analyze table");
  verb.add_option("--name-pattern", table.name_pattern,
                  "What the names of logs say, such as {method}_{scenario}_{repetition}.csv or "
                  "{method}/{scenario}.csv");
  verb.add_option("--scenarios", table.scenarios,
                  "Scenarios of the logs by {scenario}: a folder with NAME.yaml, or a list");
  verb.add_flag("--split", table.split,
                "A log whose time goes back is several runs: repetitions 1, 2, ...");
  verb.add_option("-o,--output", table.output, "File of the table instead of standard output");
}

}  // namespace

void define_metrics(CLI::App& app) {
  static MetricsArguments arguments;
  CLI::App* verb =
      app.add_subcommand("metrics", "Compute the metrics of a trajectory from any robot's log");
  verb->add_option("--trajectory", arguments.trajectory,
                   "The log: CSV with a header line t,x,y[,phi,v,w,...], TUM, or a bag of ROS");
  add_table_options(*verb, arguments.table);
  verb->add_option("--topic", arguments.topic,
                   "Topic of a bag with Odometry or poses (default: the only one), or frames: "
                   "/tf:map.base_link");
  verb->add_option("--columns", arguments.selection.columns,
                   "Columns of the log with other names or units, NAME=COLUMN[*FACTOR],..., e.g. "
                   "t=%time*1e-9,x=field.pose.pose.position.x");
  verb->add_option("--scenario", arguments.table.scenario,
                   "Scenario of the log, or of all logs (YAML)");
  verb->add_option("-c,--config", arguments.campaign.config,
                   "Campaign .ini for the robot, termination conditions and reference");
  verb->add_option("--set", arguments.campaign.overrides,
                   "Override a key of the .ini: SECTION.KEY=VALUE")
      ->take_all()
      ->allow_extra_args(false);
  verb->add_option("--robot-radius", arguments.radius,
                   "Radius of the robot, m; the same as --set robot.radius=");
  verb->add_option(
          "--rate", arguments.selection.rate,
          "Poses per second of a log without times (12 numbers a line, KITTI; 6, MRPT), Hz")
      ->check(above_zero());
  verb->add_option("--from", arguments.selection.from,
                   "Time in the log at which the run begins, s (default: its first)");
  verb->add_option("--to", arguments.selection.to,
                   "Time in the log at which the run ends, s (default: its last); a log whose time "
                   "goes back ends there");
  verb->add_option("--outcome", arguments.outcome,
                   "Outcome of the run, e.g. success (default: evaluated from the log)");
  verb->add_flag("--json", arguments.json, "Print a JSON object");
  verb->add_flag("--quiet", arguments.campaign.quiet, "No messages");
  verb->callback([] { run(arguments); });
}

}  // namespace slalom
