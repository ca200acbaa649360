// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/campaign/campaign_options.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/metrics/metric.h>
#include <slalom/metrics/mover_metrics.h>

#include <algorithm>
#include <map>

namespace slalom {
namespace {

void append(std::vector<std::string>& ids, const std::vector<std::string>& more) {
  for (const std::string& id : more)
    if (!contains(ids, id)) ids.push_back(id);
}

std::vector<std::string> without(std::vector<std::string> ids,
                                 const std::vector<std::string>& left_out) {
  const auto is_left_out = [&](const std::string& id) { return contains(left_out, id); };
  ids.erase(std::remove_if(ids.begin(), ids.end(), is_left_out), ids.end());
  return ids;
}

/// The ids of the words, which are ids and the groups "all" and "movers". Throws Error (Usage).
std::vector<std::string> expand_groups(const std::vector<std::string>& words,
                                       const std::vector<std::string>& all,
                                       const std::vector<std::string>& movers,
                                       std::vector<std::string> known, const std::string& where) {
  std::vector<std::string> ids;
  for (const std::string& word : words) {
    if (word == "all")
      append(ids, all);
    else if (word == "movers")
      append(ids, movers);
    else
      ids.push_back(word);
  }
  known.emplace_back("movers");
  for (const std::string& id : ids)
    if (!contains(known, id))
      throw usage_error(where, "unknown id '" + id + "'",
                        expected_name(id, known, "all, or a list of " + join(known, ", ")));
  return ids;
}

/// Replaces the groups among the ids of both kinds of quantities.
void resolve_groups(CampaignOptions& options, const OptionLocation& where) {
  options.all_metrics = options.all_metrics || contains(options.metrics, "all");
  options.people_metrics =
      options.people_metrics || options.all_metrics || contains(options.metrics, "movers");
  options.all_descriptors = options.all_descriptors || contains(options.descriptors, "all");
  options.metrics = expand_groups(options.metrics, all_metric_ids(), mover_metric_ids(),
                                  metric_ids(), where("enabled"));
  options.descriptors =
      expand_groups(options.descriptors, all_descriptor_ids(), mover_descriptor_ids(),
                    descriptor_ids(), where("descriptors"));
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

template <typename Options>
std::map<std::string, std::string> texts_of(const Options& options) {
  std::map<std::string, std::string> texts;
  write_options(options,
                [&](const std::string& key, const std::string& text) { texts[key] = text; });
  return texts;
}

/// All keys of [limits].
struct LimitsKeys {
  DeadlineOptions deadline;
  LimitsSection limits;

  void visit(OptionVisitor& v) {
    deadline.visit(v);
    limits.visit(v);
  }
};

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
  visit("campaign", campaign);
  visit("metrics", metrics);
  visit("limits", LimitsKeys{options.deadline, options.limits});
  visit("record", options.record);
  visit("robot", options.robot);
  visit("sensor", options.sensor);
  for (const LaserModel& laser : options.sensor.lasers) visit("laser." + laser.name, laser);
  visit("odometry", options.odometry);
  visit("simulation", options.simulation);
  // Campaigns without [tracks] and [people] stay the same campaigns.
  if (texts_of(options.tracker) != texts_of(TrackerModel())) visit("tracks", options.tracker);
  if (texts_of(options.people) != texts_of(PeopleSettings())) visit("people", options.people);
}

/// Reads [simulation] and [people].
void read_simulation(const IniFile& ini, RunSetup& setup) {
  setup.simulation = read_options<SimulationOptions>(ini, "simulation");
  setup.people = read_options<PeopleSettings>(ini, "people");
  if (ini.has_section("people"))
    check_period(setup.people, setup.simulation, location_in(ini, "people"));
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
  v.option("enabled", enabled,
           "metrics to compute: ids, comma-separated; all: those about moving obstacles only if a "
           "scenario has some; movers: those about moving obstacles; both contain those about "
           "people only if a scenario has some");
  v.option("descriptors", descriptors, "scenario descriptors: likewise");
  v.option("exact_confinement", exact_confinement,
           "confinement over all free cells instead of a sample; seconds per scenario");
  v.option("safe_distance", safe_distance, "m", "time with less clearance counts as risk time",
           Range::positive());
}

void LimitsSection::visit(OptionVisitor& v) {
  v.option("run_wall_time", run_wall_time, "s", "wall-clock time limit of a run",
           Range::positive());
  v.option("run_cpu_time", run_cpu_time, "s", "CPU time limit of a run; 0: unlimited",
           Range::at_least(0));
  v.option("memory_mb", memory_mb, "MiB", "memory limit of a worker for methods; 0: unlimited",
           Range::at_least(0));
  v.option("method_errors", method_errors,
           "show on standard error what methods print, instead of keeping it with their runs");
  v.option("sandbox", sandbox,
           "methods can write files only to their own folder for temporary files (Linux 5.13)");
  v.option("network", network, "methods can use networks; those over LCM must");
}

void RecordSection::visit(OptionVisitor& v) {
  v.option("rawlog", rawlog, "runs to record as MRPT rawlogs");
  v.option("bag", bag, "runs to record as bags of ROS 2 (MCAP)");
  v.option("trajectories", trajectories, "runs whose trajectories are stored in the results");
  v.option("repeated_runs", repeated_runs, "-",
           "runs of each method that slalom-evaluate executes a second time, to measure whether it "
           "is repeatable; 0: none",
           Range::between(0, 1000));
}

std::vector<std::string> all_metric_ids() {
  return without(without(without(metric_ids(), mover_metric_ids()), people_metric_ids()),
                 goal_heading_metric_ids());
}

std::vector<std::string> all_descriptor_ids() {
  return without(without(descriptor_ids(), mover_descriptor_ids()), {"predicted_difficulty"});
}

void CampaignOptions::adapt_to(const std::vector<Scenario>& scenarios) {
  const auto any = [&](auto condition) {
    return std::any_of(scenarios.begin(), scenarios.end(), condition);
  };
  const bool has_people = any([](const Scenario& one) { return !one.people().empty(); });
  if (has_people || any([](const Scenario& one) { return !one.movers().empty(); }))
    add_mover_quantities();
  if (any([](const Scenario& one) { return one.goal_heading().has_value(); }))
    add_goal_heading_metrics();
  if (!has_people) return;
  add_people_metrics();
  check_period(people, simulation, [](const std::string& key) { return "[people] " + key; });
}

void CampaignOptions::add_goal_heading_metrics() {
  if (all_metrics) append(metrics, goal_heading_metric_ids());
}

void CampaignOptions::add_people_metrics() {
  if (people_metrics) append(metrics, people_metric_ids());
}

void CampaignOptions::add_mover_quantities() {
  if (all_metrics) append(metrics, mover_metric_ids());
  if (all_descriptors) append(descriptors, mover_descriptor_ids());
}

std::vector<QuantityInfo> CampaignOptions::metric_infos() const {
  return infos_of(metrics, metric);
}

std::vector<QuantityInfo> CampaignOptions::descriptor_infos() const {
  return infos_of(descriptors, descriptor);
}

bool is_recorded(RecordedRuns runs, Outcome outcome) {
  return runs == RecordedRuns::All ||
         (runs == RecordedRuns::Failures && outcome != Outcome::Success);
}

CampaignOptions read_measuring_options(const IniFile& ini) {
  const auto metrics = read_options<MetricsSection>(ini, "metrics");
  CampaignOptions options;
  options.metrics = split(metrics.enabled, ',');
  options.descriptors = split(metrics.descriptors, ',');
  resolve_groups(options, location_in(ini, "metrics"));
  options.exact_confinement = metrics.exact_confinement;
  options.safe_distance = metrics.safe_distance;
  options.robot = read_robot_model(ini);
  read_simulation(ini, options);
  options.simulation.check(location_in(ini, "simulation"));
  return options;
}

void read_run_options(const IniFile& ini, CampaignOptions& options) {
  options.robot = read_robot_model(ini);
  read_simulation(ini, options);
  options.sensor = read_sensor_model(ini);
  options.odometry = read_options<OdometryModel>(ini, "odometry");
  options.tracker = read_options<TrackerModel>(ini, "tracks");
  const auto limits = read_options<LimitsKeys>(ini, "limits");
  options.deadline = limits.deadline;
  options.limits = limits.limits;
}

CampaignOptions read_campaign_options(const IniFile& ini) {
  const auto campaign = read_options<CampaignSection>(ini, "campaign");
  check_name(campaign.name, ini.where("campaign", "name"));
  CampaignOptions options = read_measuring_options(ini);
  options.name = campaign.name;
  options.seed = campaign.seed;
  options.repetitions = campaign.repetitions;
  options.record = read_options<RecordSection>(ini, "record");
  read_run_options(ini, options);
  return options;
}

CampaignOptions checked_options(CampaignOptions options, const std::string& origin) {
  const auto keys_of = [&origin](const std::string& section) {
    return location_of(origin + section);
  };
  resolve_groups(options, keys_of("metrics"));
  for_each_section(options, [&](const std::string& section, const auto& values) {
    check_options(values, keys_of(section));
  });
  options.simulation.check(keys_of("simulation"));
  if (texts_of(options.people) != texts_of(PeopleSettings()))
    check_period(options.people, options.simulation, keys_of("people"));
  options.sensor.check_lasers([&](const std::string& name, const std::string& key) {
    return keys_of("laser." + name)(key);
  });
  options.robot.set_radius_of_footprint(keys_of("robot")("footprint"));
  return options;
}

void write_settings(const CampaignOptions& options, const SettingWriter& write) {
  for_each_section(options, [&](const std::string& section, const auto& values) {
    const auto defaults = texts_of(std::decay_t<decltype(values)>());
    write_options(values, [&](const std::string& key, const std::string& text) {
      // Campaigns that do not use these keys stay the same campaigns.
      const bool is_later =
          contains({"record.bag", "simulation.goal_heading_tolerance"}, section + "." + key);
      if (!is_later || text != defaults.at(key)) write(section, key, text);
    });
  });
}

IniFile campaign_ini(const CampaignOptions& options, const std::string& origin) {
  IniFile ini;
  write_settings(options, [&](const std::string& section, const std::string& key,
                              const std::string& text) { ini.set(section, key, text, origin); });
  // A footprint determines the radius.
  ini.remove("robot", options.robot.footprint.empty() ? "footprint" : "radius");
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
