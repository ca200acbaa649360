#include <slalom/campaign/campaign_options.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/metrics/metric.h>
#include <slalom/metrics/mover_metrics.h>

#include <algorithm>

namespace slalom {
namespace {

template <typename Quantities>
std::vector<std::string> ids_of(const Quantities& quantities) {
  std::vector<std::string> ids;
  for (const auto& quantity : quantities) ids.push_back(quantity.info.id);
  return ids;
}

void check_ids(const std::vector<std::string>& ids, const std::vector<std::string>& known,
               const std::string& where) {
  for (const std::string& id : ids)
    if (!contains(known, id))
      throw usage_error(where, "unknown id '" + id + "'",
                        expected_name(id, known, "all, or a list of " + join(known, ", ")));
}

/// Parses "all" or a list of ids from `known`.
std::vector<std::string> parse_ids(const std::string& text, const std::vector<std::string>& known,
                                   const std::string& where) {
  if (text == "all") return known;
  std::vector<std::string> ids = split(text, ',');
  check_ids(ids, known, where);
  return ids;
}

std::vector<std::string> known_metric_ids() {
  return ids_of(all_metrics());
}

void append(std::vector<std::string>& ids, const std::vector<std::string>& more) {
  for (const std::string& id : more)
    if (!contains(ids, id)) ids.push_back(id);
}

/// The same ids, with those of a group, "all" or "movers", instead of its name.
std::vector<std::string> without_groups(const std::vector<std::string>& words) {
  std::vector<std::string> ids;
  for (const std::string& word : words) {
    if (word == "all")
      append(ids, all_metric_ids());
    else if (word == "movers")
      append(ids, mover_metric_ids());
    else
      ids.push_back(word);
  }
  return ids;
}

void check_metrics(const std::vector<std::string>& ids, const std::string& where) {
  std::vector<std::string> known = known_metric_ids();
  known.emplace_back("movers");
  check_ids(ids, known, where);
}

std::vector<std::string> parse_metrics(const std::string& text, const std::string& where) {
  std::vector<std::string> ids = without_groups(split(text, ','));
  check_metrics(ids, where);
  return ids;
}

/// Names of campaigns and methods become parts of file names.
void check_name(const std::string& name, const std::string& where) {
  constexpr std::size_t kMaxLength = 100;
  const bool plain = name.find_first_not_of(
                         "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                         "0123456789_.+-") == std::string::npos;
  if (!plain || name.empty() || name[0] == '.' || name.size() > kMaxLength)
    throw usage_error(where, "invalid name '" + name.substr(0, kMaxLength) + "'",
                      "at most 100 letters, digits, '_', '.', '+' and '-', not beginning with '.'");
}

template <typename Find>
std::vector<QuantityInfo> infos_of(const std::vector<std::string>& ids, Find find) {
  std::vector<QuantityInfo> infos;
  for (const std::string& id : ids) infos.push_back(find(id).info);
  return infos;
}

/// Calls visit(name, values) for each section of a campaign's .ini with these options.
template <typename Visit>
void for_each_section(const CampaignOptions& options, Visit visit) {
  CampaignSection campaign;
  campaign.name = options.name;
  campaign.seed = options.seed;
  campaign.repetitions = options.repetitions;
  MetricsSection metrics;
  metrics.enabled = join(options.metrics, ",");
  metrics.descriptors = join(options.descriptors, ",");
  metrics.exact_confinement = options.exact_confinement;
  metrics.safe_distance = options.safe_distance;
  LimitsSection limits = options.limits;
  limits.deadline = options.setup.deadline;
  visit("campaign", campaign);
  visit("metrics", metrics);
  visit("limits", limits);
  visit("record", options.record);
  visit("robot", options.setup.robot);
  visit("sensor", options.setup.sensor);
  visit("odometry", options.setup.odometry);
  visit("simulation", options.setup.simulation);
}

}  // namespace

void CampaignSection::visit(OptionVisitor& v) {
  v.option("name", name, "name of the campaign, in tables and reports");
  v.option("seed", seed, "seed of all random numbers");
  v.option("repetitions", repetitions, "-", "runs of each method on each scenario",
           Range::between(1, 1e6));
  v.option("methods", methods, "names of [method.NAME] sections, comma-separated");
}

void MetricsSection::visit(OptionVisitor& v) {
  v.option(
      "enabled", enabled,
      "metrics to compute: ids, comma-separated; all: those that are not about movers; movers: "
      "those that are");
  v.option("descriptors", descriptors, "scenario descriptors: ids, comma-separated, or all");
  v.option("exact_confinement", exact_confinement,
           "confinement over all free cells instead of a sample; seconds per scenario");
  v.option("safe_distance", safe_distance, "m", "time with less clearance counts as risk time",
           Range::positive());
}

void LimitsSection::visit(OptionVisitor& v) {
  deadline.visit(v);
  v.option("run_wall_time", run_wall_time, "s", "wall-clock time limit of a run",
           Range::positive());
  v.option("run_cpu_time", run_cpu_time, "s", "CPU time limit of a run; 0: unlimited",
           Range::at_least(0));
  v.option("memory_mb", memory_mb, "MiB", "memory limit of a worker for methods; 0: unlimited",
           Range::at_least(0));
  v.option("method_errors", method_errors, "show the standard error output of methods");
  v.option("sandbox", sandbox,
           "methods can write files only to their own folder for temporary files (Linux 5.13)");
}

void RecordSection::visit(OptionVisitor& v) {
  v.option("rawlog", rawlog, "runs to record as MRPT rawlogs");
  v.option("trajectories", trajectories, "runs whose trajectories are stored in the results");
}

std::vector<std::string> all_metric_ids() {
  std::vector<std::string> ids = known_metric_ids();
  const auto is_of_movers = [](const std::string& id) { return contains(mover_metric_ids(), id); };
  ids.erase(std::remove_if(ids.begin(), ids.end(), is_of_movers), ids.end());
  return ids;
}

std::vector<std::string> all_descriptor_ids() {
  return ids_of(all_descriptors());
}

std::vector<QuantityInfo> CampaignOptions::metric_infos() const {
  return infos_of(metrics, metric);
}

std::vector<QuantityInfo> CampaignOptions::descriptor_infos() const {
  return infos_of(descriptors, descriptor);
}

bool RecordSection::wants(Outcome outcome) const {
  return rawlog == RecordedRuns::All ||
         (rawlog == RecordedRuns::Failures && outcome != Outcome::Success);
}

CampaignOptions read_measuring_options(const IniFile& ini) {
  const auto metrics = read_options<MetricsSection>(ini, "metrics");
  CampaignOptions options;
  options.metrics = parse_metrics(metrics.enabled, ini.where("metrics", "enabled"));
  options.descriptors =
      parse_ids(metrics.descriptors, all_descriptor_ids(), ini.where("metrics", "descriptors"));
  options.exact_confinement = metrics.exact_confinement;
  options.safe_distance = metrics.safe_distance;
  options.setup.robot = read_robot_model(ini);
  options.setup.simulation = read_options<SimulationOptions>(ini, "simulation");
  options.setup.simulation.check(location_in(ini, "simulation"));
  return options;
}

CampaignOptions read_campaign_options(const IniFile& ini) {
  const auto campaign = read_options<CampaignSection>(ini, "campaign");
  check_name(campaign.name, ini.where("campaign", "name"));
  CampaignOptions options = read_measuring_options(ini);
  options.name = campaign.name;
  options.seed = campaign.seed;
  options.repetitions = campaign.repetitions;
  options.limits = read_options<LimitsSection>(ini, "limits");
  options.record = read_options<RecordSection>(ini, "record");
  options.setup.sensor = read_options<SensorModel>(ini, "sensor");
  options.setup.odometry = read_options<OdometryModel>(ini, "odometry");
  options.setup.deadline = options.limits.deadline;
  return options;
}

CampaignOptions checked_options(CampaignOptions options, const std::string& origin) {
  const auto keys_of = [&origin](const char* section) { return location_of(origin + section); };
  options.metrics = without_groups(options.metrics);
  check_metrics(options.metrics, keys_of("metrics")("enabled"));
  check_ids(options.descriptors, all_descriptor_ids(), keys_of("metrics")("descriptors"));
  for_each_section(options, [&](const char* section, const auto& values) {
    check_options(values, keys_of(section));
  });
  options.setup.simulation.check(keys_of("simulation"));
  options.setup.robot.set_radius_of_footprint(keys_of("robot")("footprint"));
  return options;
}

void write_settings(const CampaignOptions& options, const SettingWriter& write) {
  for_each_section(options, [&](const char* section, const auto& values) {
    write_options(values, [&](const std::string& key, const std::string& text) {
      write(section, key, text);
    });
  });
}

IniFile campaign_ini(const CampaignOptions& options, const std::string& origin) {
  IniFile ini;
  write_settings(options, [&](const std::string& section, const std::string& key,
                              const std::string& text) { ini.set(section, key, text, origin); });
  // A footprint determines the radius.
  ini.remove("robot", options.setup.robot.footprint.empty() ? "footprint" : "radius");
  return ini;
}

std::vector<NamedMethod> read_methods(const IniFile& ini, const MethodRegistry& registry) {
  const std::string where = ini.where("campaign", "methods");
  const std::vector<std::string> names =
      split(read_options<CampaignSection>(ini, "campaign").methods, ',');
  if (names.empty())
    throw usage_error(where, "no method given", "names of [method.NAME] sections, comma-separated");
  std::vector<NamedMethod> methods;
  for (const std::string& name : names) {
    check_name(name, where);
    if (std::count(names.begin(), names.end(), name) > 1)
      throw usage_error(where, "duplicate method '" + name + "'", "each method once");
    if (!ini.has_section("method." + name))
      throw usage_error(where, "no section for method '" + name + "'", "[method." + name + "]");
    methods.push_back(registry.read(ini, name));
  }
  return methods;
}

}  // namespace slalom
