// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/ini_file.h>
#include <slalom/core/options.h>
#include <slalom/methods/registry.h>
#include <slalom/metrics/metric.h>
#include <slalom/robot/robot_model.h>
#include <slalom/scenario/scenario.h>
#include <slalom/simulation/simulate.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// Section [campaign].
struct CampaignSection {
  std::string name = "campaign";
  std::uint64_t seed = 1;
  int repetitions = 1;
  std::string methods;  ///< names, comma-separated

  void visit(OptionVisitor& v);
};

/// Section [metrics].
struct MetricsSection {
  std::string enabled = "all";           ///< metric ids, all, movers, comma-separated
  std::string descriptors = "all";       ///< descriptor ids, comma-separated, or all
  bool exact_confinement = false;        ///< confinement over all free cells instead of a sample
  double safe_distance = kSafeDistance;  ///< m; time with less clearance counts as risk time

  void visit(OptionVisitor& v);
};

/// Section [limits], with the keys of DeadlineOptions.
struct LimitsSection {
  double run_wall_time = 60;   ///< s of wall-clock time per run
  double run_cpu_time = 0;     ///< s of CPU time per run; 0: unlimited
  double memory_mb = 2048;     ///< MiB a worker may allocate after its start; 0: unlimited
  bool method_errors = false;  ///< show what methods print, on standard error
  bool sandbox = false;        ///< methods can write only to their folder for temporary files
  bool network = true;         ///< methods can make sockets of networks

  void visit(OptionVisitor& v);
};

enum class RecordedRuns { None, Failures, All };
constexpr auto enum_names(RecordedRuns) {
  return std::array{"none", "failures", "all"};
}

bool is_recorded(RecordedRuns runs, Outcome outcome);

enum class StoredTrajectories {
  All,
  None  ///< for very large campaigns
};
constexpr auto enum_names(StoredTrajectories) {
  return std::array{"all", "none"};
}

/// Section [record].
struct RecordSection {
  RecordedRuns rawlog = RecordedRuns::None;
  RecordedRuns bag = RecordedRuns::None;
  StoredTrajectories trajectories = StoredTrajectories::All;
  int repeated_runs = 5;  ///< runs of each method that are executed a second time

  void visit(OptionVisitor& v);
};

/// The ids behind "all" in static scenarios: without mover_metric_ids(), people_metric_ids(),
/// goal_heading_metric_ids() and mover_descriptor_ids(); and without predicted_difficulty, which
/// repeats two descriptors and was fitted to outcomes.
std::vector<std::string> all_metric_ids();
std::vector<std::string> all_descriptor_ids();

/// All settings of a campaign except its scenarios and methods.
struct CampaignOptions : RunSetup {
  std::string name = "campaign";
  std::uint64_t seed = 1;
  int repetitions = 1;
  /// Ids; checked_options() also takes the groups "all" and "movers".
  std::vector<std::string> metrics = all_metric_ids();
  std::vector<std::string> descriptors = all_descriptor_ids();
  bool all_metrics = false, all_descriptors = false;  ///< requested as "all", see adapt_to()
  bool people_metrics = false;                        ///< requested as "all" or "movers"
  bool exact_confinement = false;
  double safe_distance = kSafeDistance;  ///< m
  LimitsSection limits;
  RecordSection record;
  double reference_gap = 0.01;

  /// If any scenario has movers, people or a heading of its goal, "all" includes the quantities
  /// about them; "movers" those about people likewise. Throws Error (Usage) if there are people and
  /// check_period() refuses theirs.
  void adapt_to(const std::vector<Scenario>& scenarios);
  void add_mover_quantities();
  void add_people_metrics();
  void add_goal_heading_metrics();

  /// The quantities with the ids in `metrics` and in `descriptors`, in the same order.
  std::vector<QuantityInfo> metric_infos() const;
  std::vector<QuantityInfo> descriptor_infos() const;
};

/// The settings needed to compute the metrics of a run: the robot, the simulation limits, people
/// and the enabled metrics, from [robot], [simulation], [people] and [metrics]. Missing sections
/// and keys take their defaults. Throws Error (Usage).
CampaignOptions read_measuring_options(const IniFile& ini);

/// Reads [robot], [sensor], [tracks], [odometry], [simulation], [people] and [limits] into
/// `options`. Throws Error (Usage).
void read_run_options(const IniFile& ini, CampaignOptions& options);

/// Reads [campaign], [robot], [sensor], [tracks], [odometry], [simulation], [people], [metrics] and
/// [limits] and checks them against each other. Throws Error (Usage). Does not set
/// reference_gap, which is part of [reference].
CampaignOptions read_campaign_options(const IniFile& ini);

/// The options of a program, checked in the same way, with the radius of a footprint. Throws Error
/// (Usage), which names a value ORIGIN and SECTION.KEY.
CampaignOptions checked_options(CampaignOptions options, const std::string& origin);

/// Passes the options as texts, by section and key of a campaign's .ini.
using SettingWriter = std::function<void(const std::string& section, const std::string& key,
                                         const std::string& text)>;
void write_settings(const CampaignOptions& options, const SettingWriter& write);

/// The sections from which read_campaign_options() reads the same options. Errors about a value
/// name it ORIGIN SECTION.KEY.
IniFile campaign_ini(const CampaignOptions& options, const std::string& origin);

/// The methods that [campaign] names, in that order, from their sections. Throws Error (Usage) for
/// none, a duplicate, or a section that is missing or invalid.
std::vector<NamedMethod> read_methods(const IniFile& ini, const MethodRegistry& registry);

}  // namespace slalom
