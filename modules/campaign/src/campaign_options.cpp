#include <slalom/campaign/campaign_options.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/metrics/metric.h>

#include <algorithm>

namespace slalom {
namespace {

template <typename Quantities>
std::vector<std::string> ids_of(const Quantities& quantities) {
  std::vector<std::string> ids;
  for (const auto& quantity : quantities) ids.push_back(quantity->info().id);
  return ids;
}

/// "all" or a list of ids, each of which must be one of `known`.
std::vector<std::string> read_ids(const IniFile& ini, const std::string& key,
                                  const std::string& text, const std::vector<std::string>& known) {
  if (text == "all") return known;
  const std::vector<std::string> ids = split(text, ',');
  for (const std::string& id : ids) {
    if (std::find(known.begin(), known.end(), id) != known.end()) continue;
    const std::string nearest = nearest_name(id, known);
    throw usage_error(
        ini.where("metrics", key), "unknown id '" + id + "'",
        nearest.empty() ? "all, or some of " + join(known, ", ") : "'" + nearest + "'");
  }
  return ids;
}

std::vector<std::string> read_methods(const IniFile& ini, const std::string& text) {
  const std::vector<std::string> names = split(text, ',');
  if (names.empty())
    throw usage_error(ini.where("campaign", "methods"), "names no method",
                      "names of [method.NAME] sections, comma separated");
  for (const std::string& name : names) {
    if (std::count(names.begin(), names.end(), name) > 1)
      throw usage_error(ini.where("campaign", "methods"), "'" + name + "' stands there twice",
                        "each method once");
    if (!ini.has_section("method." + name))
      throw usage_error(ini.where("campaign", "methods"), "no section for method '" + name + "'",
                        "[method." + name + "]");
  }
  return names;
}

}  // namespace

void CampaignSection::visit(OptionVisitor& v) {
  v.option("name", name, "name of the campaign, in tables and reports");
  v.option("seed", seed, "seed from which every random number is derived");
  v.option("repetitions", repetitions, "-", "runs of each method on each scenario",
           Range::between(1, 1e6));
  v.option("methods", methods, "names of [method.NAME] sections, comma separated");
}

void MetricsSection::visit(OptionVisitor& v) {
  v.option("enabled", enabled, "metrics to compute: ids, comma separated, or all");
  v.option("descriptors", descriptors, "scenario descriptors: ids, comma separated, or all");
  v.option("exact_confinement", exact_confinement,
           "confinement from every free cell, without sampling; takes seconds a scenario");
  v.option("safe_distance", safe_distance, "m", "clearance below which time counts as at risk",
           Range::positive());
}

void LimitsSection::visit(OptionVisitor& v) {
  deadline.visit(v);
  v.option("run_wall_time", run_wall_time, "s", "wall-clock time after which a run is ended",
           Range::positive());
  v.option("run_cpu_time", run_cpu_time, "s", "processor time after which a run is ended; 0: any",
           Range::at_least(0));
  v.option("memory_mb", memory_mb, "MiB", "memory that a worker may take for methods; 0: any",
           Range::at_least(0));
  v.option("method_errors", method_errors, "what methods write to standard error is shown");
}

void RecordSection::visit(OptionVisitor& v) {
  v.option("rawlog", rawlog, "runs to record as MRPT rawlogs", {"none", "failures", "all"});
  v.option("trajectories", trajectories, "runs whose trajectories are kept with the results",
           {"all", "none"});
}

bool RecordSection::wants(Outcome outcome) const {
  return rawlog == "all" || (rawlog == "failures" && outcome != Outcome::Success);
}

CampaignOptions read_measuring_options(const IniFile& ini) {
  const auto metrics = read_options<MetricsSection>(ini, "metrics");
  CampaignOptions options;
  options.metrics = read_ids(ini, "enabled", metrics.enabled, ids_of(all_metrics()));
  options.descriptors =
      read_ids(ini, "descriptors", metrics.descriptors, ids_of(all_descriptors()));
  options.exact_confinement = metrics.exact_confinement;
  options.safe_distance = metrics.safe_distance;
  options.setup.robot = read_robot_model(ini);
  options.setup.simulation = read_options<SimulationOptions>(ini, "simulation");
  options.setup.simulation.check(ini, "simulation");
  return options;
}

CampaignOptions read_campaign_options(const IniFile& ini) {
  const auto campaign = read_options<CampaignSection>(ini, "campaign");
  CampaignOptions options = read_measuring_options(ini);
  options.name = campaign.name;
  options.seed = campaign.seed;
  options.repetitions = campaign.repetitions;
  options.methods = read_methods(ini, campaign.methods);
  options.limits = read_options<LimitsSection>(ini, "limits");
  options.record = read_options<RecordSection>(ini, "record");
  options.setup.sensor = read_options<SensorModel>(ini, "sensor");
  options.setup.odometry = read_options<OdometryModel>(ini, "odometry");
  options.setup.deadline = options.limits.deadline;
  return options;
}

}  // namespace slalom
