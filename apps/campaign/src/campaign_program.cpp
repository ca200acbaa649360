// SPDX-License-Identifier: BSD-3-Clause
#include "manifest.h"

#include <slalom/analysis/bins.h>
#include <slalom/app/adapters.h>
#include <slalom/app/campaign_program.h>
#include <slalom/app/external_options.h>
#include <slalom/app/interrupt.h>
#include <slalom/app/method_dependencies.h>
#include <slalom/app/output_folder.h>
#include <slalom/app/program.h>
#include <slalom/campaign/scenario_sources.h>
#include <slalom/core/available_cores.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/io/campaign_identity.h>
#include <slalom/io/merge_results.h>
#include <slalom/io/rawlog_path.h>
#include <slalom/map_formats/map_import.h>
#include <slalom/metrics/cycle_time.h>
#include <slalom/metrics/mover_metrics.h>
#include <slalom/rawlog/bag_recorder.h>
#include <slalom/ros_parameters/resolve.h>

#include <algorithm>
#include <iostream>

namespace slalom {
namespace {

void require_one_of(const std::string& id, const std::vector<std::string>& known,
                    const std::string& where) {
  if (contains(known, id)) return;
  throw usage_error(where, "'" + id + "' is not computed by this campaign",
                    expected_name(id, known));
}

/// The descriptors in the rows of [analysis].
std::vector<std::string> row_descriptors(const IniFile& ini, const AnalysisSection& section) {
  std::vector<std::string> ids;
  if (section.rows.empty()) return ids;
  for (const BinSpec& spec : parse_bin_specs(section.rows, ini.where("analysis", "rows")))
    if (spec.kind != BinSpec::Kind::All) ids.push_back(spec.descriptor);
  return ids;
}

void require_network(const IniFile& ini, const CampaignConfig& config) {
  if (config.options.limits.network) return;
  for (const std::string& section : method_sections(ini, config.methods))
    if (uses_network(ini.get(section, "adapter").value_or("")))
      throw usage_error(ini.where("limits", "network"),
                        "[" + section + "] communicates over the network",
                        "true, or methods with other adapters");
}

/// Whether a method communicates with a running process.
bool has_running_process(const IniFile& ini, const CampaignConfig& config) {
  const std::vector<std::string> sections = method_sections(ini, config.methods);
  return std::any_of(sections.begin(), sections.end(), [&](const std::string& section) {
    return uses_network(ini.get(section, "adapter").value_or("")) &&
           ini.get(section, "launch").value_or("").empty();
  });
}

bool have_common(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  return std::any_of(a.begin(), a.end(), [&](const std::string& id) { return contains(b, id); });
}

/// Checks the ids of [analysis], so that errors are reported before any run. If they are about
/// movers, people or headings, "all" includes those even if there is none: the tables then say why
/// there is no value.
void check_analysis(const IniFile& ini, const AnalysisSection& section, CampaignOptions& options) {
  const std::vector<std::string> columns = split(section.columns, ','),
                                 rows = row_descriptors(ini, section);
  if (have_common(columns, mover_metric_ids()) || have_common(rows, mover_descriptor_ids()))
    options.add_mover_quantities();
  if (have_common(columns, people_metric_ids())) options.add_people_metrics();
  if (have_common(columns, goal_heading_metric_ids())) options.add_goal_heading_metrics();
  std::vector<std::string> known = options.metrics;
  // Success is derived from the outcome if it is not among the metrics.
  if (!contains(known, "success")) known.emplace_back("success");
  for (const auto& [id, value] : cycle_time_statistics({0.0}, 1)) known.push_back(id);
  for (const std::string& id : columns) require_one_of(id, known, ini.where("analysis", "columns"));
  for (const std::string& id : rows)
    require_one_of(id, options.descriptors, ini.where("analysis", "rows"));
  const std::vector<std::string> methods = split(ini.get("campaign", "methods").value_or(""), ',');
  if (!section.focus.empty() && !contains(methods, section.focus))
    throw usage_error(ini.where("analysis", "focus"), "no method '" + section.focus + "'",
                      expected_name(section.focus, methods));
}

/// Refuses a library that stops where no run succeeds.
void check_goal_tolerances(const IniFile& ini, const CampaignConfig& config) {
  const double tolerance = config.options.simulation.goal_tolerance;
  for (const std::string& section : method_sections(ini, config.methods)) {
    double own = 0;
    const bool is_library = ini.get(section, "adapter") == "library";
    if (is_library && parse_number(ini.get(section, "xy_goal_tolerance").value_or(""), own) &&
        own > tolerance)
      throw usage_error(ini.where(section, "xy_goal_tolerance"),
                        format_number(own) + " is larger than [simulation] goal_tolerance " +
                            format_number(tolerance),
                        "at most that tolerance");
  }
}

/// The recorders of [record], which write beside the result file: for runs.results to
/// runs.rawlogs/HASH8_METHOD_REPETITION.rawlog and runs.bags/HASH8_METHOD_REPETITION.mcap.
std::vector<RunRecorder> recorders_of(const CampaignConfig& config,
                                      const std::string& results_path) {
  const auto manifest_of = [ini_text = config.ini_text](const Scenario& scenario,
                                                        const RunSpec& spec) {
    return make_run_manifest(ini_text, scenario, spec.method, spec.repetition, spec.seed);
  };
  const RecordSection& record = config.options.record;
  std::vector<RunRecorder> recorders;
  if (record.rawlog != RecordedRuns::None)
    recorders.push_back(
        {record.rawlog, rawlog_folder(results_path),
         [manifest_of, results_path](const Scenario& scenario, const RunSpec& spec) {
           return make_rawlog_recorder(
               rawlog_path(results_path, scenario.hash(), spec.method, spec.repetition),
               manifest_of(scenario, spec));
         }});
  if (record.bag != RecordedRuns::None)
    recorders.push_back({record.bag, bag_folder(results_path),
                         [manifest_of, results_path, setup = RunSetup(config.options)](
                             const Scenario& scenario, const RunSpec& spec) {
                           return make_bag_recorder(bag_path(results_path, scenario.hash(),
                                                             spec.method, spec.repetition),
                                                    manifest_of(scenario, spec), scenario, setup);
                         }});
  return recorders;
}

/// The problem of the campaign in `file`, if files of methods were replaced while it ran: its runs
/// were made with both.
std::string replacement_problem(const CampaignConfig& config, const ResultFile& file) {
  try {
    const Manifest stored = file.read_manifest();
    std::vector<IdentityDifference> replaced;
    for (const auto& [key, hash] : hash_method_files(config)) {
      const auto found = stored.find(key);
      if (found != stored.end() && found->second != hash)
        replaced.push_back({key, hash, found->second});
    }
    if (replaced.empty()) return "";
    return "files of methods were replaced while the campaign ran: " +
           enumerate(replaced, file.path());
  } catch (const Error& error) {
    return std::string("a file of a method was removed while the campaign ran: ") + error.what();
  }
}

/// Says how much of the campaign an earlier execution has done.
void notify_known_runs(std::size_t known, std::size_t total, bool sequential,
                       const std::function<void(const std::string&)>& notify) {
  if (known == 0) return;
  const std::string count = std::to_string(known), all = std::to_string(total);
  if (known == total) return notify("all " + all + " runs are there");
  // How many runs a stopping rule requires is not known.
  notify("continues: " + count + (sequential ? "" : " of " + all) + " runs are there");
}

/// "gap 40/200, nd 80/200"; "" for one method and before the first run.
std::string runs_by_method(const MethodFailures& runs, const std::vector<NamedMethod>& methods,
                           std::size_t runs_of_each) {
  std::string text;
  bool begun = false;
  for (const NamedMethod& method : methods) {
    const std::size_t done = runs.runs_of(method.name);
    begun = begun || done > 0;
    text += (text.empty() ? "" : ", ") + method.name + " " + std::to_string(done) + "/" +
            std::to_string(runs_of_each);
  }
  return begun && methods.size() > 1 ? text : "";
}

}  // namespace

IniFile load_campaign_ini(const CampaignArguments& arguments) {
  return with_overrides(IniFile::load(arguments.config), arguments);
}

IniFile with_overrides(IniFile ini, const CampaignArguments& arguments) {
  for (const std::string& assignment : arguments.overrides) ini.override_key(assignment);
  if (arguments.seed) ini.set("campaign", "seed", std::to_string(*arguments.seed));
  ini.reject_unknown_sections(campaign_sections());
  for (const RosParameterReport& report : resolve_ros_parameters(ini))
    if (!arguments.quiet) std::cerr << report.summary() << "\n";
  const std::string warning = sensor_warning(ini);
  if (!warning.empty() && !arguments.quiet) std::cerr << "warning: " << warning << "\n";
  return ini;
}

void require_method(const IniFile& ini, const std::string& option, const std::string& name) {
  if (ini.has_section("method." + name)) return;
  std::vector<std::string> known;
  for (const std::string& section : ini.sections())
    if (starts_with(section, "method.")) known.push_back(section.substr(7));
  throw usage_error(option + " " + name, "no section [method." + name + "] in " + ini.name(),
                    expected_name(name, known));
}

CampaignConfig read_campaign(const IniFile& ini) {
  CampaignConfig config;
  config.ini_name = ini.name();
  config.ini_text = ini.canonical_text();
  config.options = read_campaign_options(ini);
  config.reference = read_options<OmplOptions>(ini, "reference");
  config.options.reference_gap = config.reference.gap;
  config.analysis = read_options<AnalysisSection>(ini, "analysis");
  check_analysis(ini, config.analysis, config.options);
  config.methods = read_methods(ini, all_adapters());
  check_goal_tolerances(ini, config);
  require_network(ini, config);
  config.one_worker = has_running_process(ini, config);
  config.method_files = files_of_methods(ini, method_sections(ini, config.methods));
  config.effective_ini = effective_ini(ini, config);
  const RunSetup& setup = config.options;
  config.sources = read_scenario_sources(
      ini, source_context(setup.robot, setup.simulation.resolution, config.options.seed),
      load_occupancy_grid);
  return config;
}

int campaign_workers(const CampaignConfig& config, const CampaignArguments& arguments) {
  return arguments.jobs == 0 && config.one_worker ? 1 : worker_count(arguments.jobs);
}

void check_campaign(CampaignConfig& config) {
  config.privileged = check_methods({config.options, {}, config.methods});
  const IniFile ini = IniFile::from_text(config.ini_text, config.ini_name);
  config.dependencies =
      dependencies_of_methods(ini, method_sections(ini, config.methods), config.method_files);
}

std::vector<Scenario> campaign_scenarios(CampaignConfig& config,
                                         const CampaignArguments& arguments) {
  check_campaign(config);
  const auto progress = make_interruptible_progress(arguments.quiet);
  ScenarioSources sources = config.sources;
  sources.context.jobs = worker_count(arguments.jobs);
  std::vector<Scenario> scenarios = collect_scenarios(sources, load_occupancy_grid, *progress);
  config.options.adapt_to(scenarios);
  config.effective_ini = effective_ini(IniFile::from_text(config.ini_text), config);
  return scenarios;
}

ResultFile open_campaign_results(const CampaignConfig& config, const CampaignArguments& arguments,
                                 const std::vector<Scenario>& scenarios,
                                 const std::string& results_path,
                                 const std::optional<StoppingRule>& rule) {
  Manifest manifest = make_manifest(config, scenarios, rule);
  if (arguments.shard.count > 1) manifest[kShardKey] = to_string(arguments.shard);
  return open_results(results_path, std::move(manifest),
                      scenarios_of_shard(scenarios, arguments.shard), config.options,
                      arguments.existing);
}

CampaignReport run_campaign_program(const CampaignConfig& config,
                                    const CampaignArguments& arguments,
                                    std::vector<Scenario> scenarios, ResultFile results,
                                    const std::optional<StoppingRule>& rule) {
  scenarios = scenarios_of_shard(std::move(scenarios), arguments.shard);
  const auto planner = make_ompl_planner(config.reference, config.options.robot);
  Campaign campaign{config.options, {}, config.methods, planner.get()};
  const std::string results_path = results.path();
  campaign.recorders = recorders_of(config, results_path);
  const auto notify = [&arguments](const std::string& line) {
    if (!arguments.quiet) std::cerr << line << std::endl;
  };
  const std::size_t runs_of_each =
      scenarios.size() * static_cast<std::size_t>(config.options.repetitions);
  const std::size_t total = runs_of_each * config.methods.size();
  const std::vector<RunRecorder> recorders = campaign.recorders;
  const auto warn = [](const std::string& line) { std::cerr << line << std::endl; };
  CampaignRecorder recorder(std::move(campaign), std::move(results),
                            {steady_seconds, notify, warn});
  notify_known_runs(recorder.known_runs(), total, rule.has_value(), notify);
  const int workers = campaign_workers(config, arguments);
  if (arguments.jobs == 0 && (rule || recorder.known_runs() < total))
    notify(count_text(static_cast<std::size_t>(workers), "worker"));
  for (const RunRecorder& one : recorders) make_output_folder(one.folder);
  const auto progress = make_terminal_progress(arguments.quiet);
  if (!rule)  // how many runs each method will have is not known with one
    progress->set_detail(
        [&] { return runs_by_method(recorder.method_failures(), config.methods, runs_of_each); });
  const InterruptGuard guard;
  const Execution execution{workers, *progress, InterruptGuard::raised};
  SequentialReport report;
  if (rule)
    report =
        run_until(recorder, *rule, std::move(scenarios), config.analysis.confidence, execution);
  else
    report.complete = recorder.run(std::move(scenarios), execution);
  std::string problem = recorder.problem();
  if (problem.empty()) problem = replacement_problem(config, recorder.file());
  return {report.complete, problem, recorder.method_failures(), report.text};
}

void print_method_failures(const CampaignReport& report, const std::string& results_path) {
  const std::vector<std::string> lines = report.failures.lines();
  for (const std::string& line : lines) std::cerr << line << "\n";
  if (!lines.empty())
    std::cerr << "With what the method printed: slalom-analyze show " << results_path
              << " --run RUN\n";
}

void require_valid_runs(const CampaignReport& report, const std::string& results_path) {
  if (!report.problem.empty()) throw job_error(results_path, report.problem);
  const std::vector<std::string> methods = report.failures.methods_without_a_sound_run();
  if (!methods.empty())
    throw job_error(results_path, join(methods, ", ") + (methods.size() == 1 ? " has" : " have") +
                                      " ended every run by an error of its own");
}

}  // namespace slalom
