#include "campaign_recorder.h"

#include <slalom/analysis/analysis_section.h>
#include <slalom/analysis/bins.h>
#include <slalom/app/adapters.h>
#include <slalom/app/campaign_program.h>
#include <slalom/campaign/campaign.h>
#include <slalom/commands/scenario_sources.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/generation/generator.h>
#include <slalom/lcm/lcm_method.h>
#include <slalom/library/library_method.h>
#include <slalom/map_formats/map_import.h>
#include <slalom/metrics/cycle_time.h>
#include <slalom/mrpt_nav/holonomic_method.h>
#include <slalom/mrpt_nav/navigator_method.h>
#include <slalom/ompl/ompl_planner.h>

#include <algorithm>

namespace slalom {
namespace {

template <typename Options>
void list_section(std::string& text, const std::string& section) {
  Options options;
  OptionLister lister;
  options.visit(lister);
  text += (text.empty() ? "[" : "\n[") + section + "]\n" + lister.text();
}

void require_one_of(const std::string& id, const std::vector<std::string>& known,
                    const std::string& where) {
  if (std::find(known.begin(), known.end(), id) != known.end()) return;
  const std::string nearest = nearest_name(id, known);
  throw usage_error(where, "'" + id + "' is not computed by this campaign",
                    nearest.empty() ? "one of " + join(known, ", ") : "'" + nearest + "'");
}

/// What [analysis] asks for must be computed: a wrong id is told before anything runs.
void check_analysis(const IniFile& ini, const CampaignOptions& options) {
  const auto section = read_options<AnalysisSection>(ini, "analysis");
  std::vector<std::string> columns = options.metrics;
  // Success follows from the outcome where it is not among the metrics.
  if (std::find(columns.begin(), columns.end(), "success") == columns.end())
    columns.emplace_back("success");
  for (const auto& [id, value] : cycle_time_statistics({0.0}, 1)) columns.push_back(id);
  for (const std::string& id : split(section.columns, ','))
    require_one_of(id, columns, ini.where("analysis", "columns"));
  if (section.rows.empty()) return;
  for (const BinSpec& spec : parse_bin_specs(section.rows))
    if (spec.kind != BinSpec::Kind::All)
      require_one_of(spec.descriptor, options.descriptors, ini.where("analysis", "rows"));
}

}  // namespace

std::string campaign_options_help() {
  std::string text;
  list_section<CampaignSection>(text, "campaign");
  list_section<ScenariosSection>(text, "scenarios");
  for (const std::string& family : generator_names()) {
    OptionLister lister;
    visit_generator_options(family, lister);
    text += "\n[generator." + family + "]\n" + lister.text();
  }
  list_section<RobotModel>(text, "robot");
  list_section<SensorModel>(text, "sensor");
  list_section<OdometryModel>(text, "odometry");
  list_section<SimulationOptions>(text, "simulation");
  list_section<OmplOptions>(text, "reference");
  list_section<MetricsSection>(text, "metrics");
  list_section<LimitsSection>(text, "limits");
  list_section<RecordSection>(text, "record");
  list_section<AnalysisSection>(text, "analysis");
  list_section<HolonomicOptions>(text, "method.NAME");
  list_section<NavigatorOptions>(text, "method.NAME");
  list_section<LibraryOptions>(text, "method.NAME");
  list_section<LcmOptions>(text, "method.NAME");
  return text;
}

IniFile load_campaign_ini(const CampaignArguments& arguments) {
  IniFile ini = IniFile::load(arguments.config);
  for (const std::string& assignment : arguments.overrides) ini.override_key(assignment);
  if (arguments.seed) ini.set("campaign", "seed", std::to_string(*arguments.seed));
  ini.reject_unknown_sections({"campaign", "scenarios", "generator.*", "robot", "sensor",
                               "odometry", "simulation", "reference", "metrics", "limits", "record",
                               "analysis", "method.*"});
  return ini;
}

std::vector<Scenario> campaign_scenarios(const IniFile& ini, const CampaignArguments& arguments) {
  const CampaignOptions options = read_campaign_options(ini);
  check_analysis(ini, options);
  const MethodRegistry registry = all_adapters();
  check_methods({options, {}, ini, registry});
  const auto progress = make_terminal_progress(arguments.quiet);
  return collect_scenarios(ini,
                           {options.setup.robot.radius, options.setup.simulation.resolution,
                            options.seed, arguments.jobs},
                           load_occupancy_grid, *progress);
}

CampaignReport run_campaign_program(const IniFile& ini, const CampaignArguments& arguments,
                                    std::vector<Scenario> scenarios,
                                    const std::string& results_path) {
  CampaignRecorder recorder(ini, arguments, scenarios, results_path);
  const bool complete = recorder.run(std::move(scenarios));
  return {complete, recorder.problem()};
}

}  // namespace slalom
