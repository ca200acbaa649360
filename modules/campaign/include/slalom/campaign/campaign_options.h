#pragma once

#include <slalom/core/ini_file.h>
#include <slalom/core/options.h>
#include <slalom/metrics/metric.h>
#include <slalom/robot/robot_model.h>
#include <slalom/simulation/simulate.h>

#include <cstdint>
#include <string>
#include <vector>

namespace slalom {

/// Section [campaign].
struct CampaignSection {
  std::string name = "campaign";
  std::uint64_t seed = 1;
  int repetitions = 1;
  std::string methods;  ///< names, comma separated

  void visit(OptionVisitor& v);
};

/// Section [metrics].
struct MetricsSection {
  std::string enabled = "all";           ///< metric ids, comma separated, or all
  std::string descriptors = "all";       ///< descriptor ids, comma separated, or all
  bool exact_confinement = false;        ///< confinement from every free cell, not sampled
  double safe_distance = kSafeDistance;  ///< m, clearance below which time is time at risk

  void visit(OptionVisitor& v);
};

/// Section [limits].
struct LimitsSection {
  DeadlineOptions deadline;
  double run_wall_time = 60;   ///< s of wall-clock time for one run
  double run_cpu_time = 0;     ///< s of processor time for one run; 0: any
  double memory_mb = 2048;     ///< MiB that a worker may take beyond what it starts with; 0: any
  bool method_errors = false;  ///< what methods write to standard error is shown

  void visit(OptionVisitor& v);
};

/// Section [record].
struct RecordSection {
  std::string rawlog = "none";       ///< none, failures or all runs
  std::string trajectories = "all";  ///< none: results without them, for very large campaigns

  void visit(OptionVisitor& v);
  bool wants(Outcome outcome) const;
};

/// Everything of a campaign's .ini that is not about where scenarios come from or how tables look.
struct CampaignOptions {
  std::string name;
  std::uint64_t seed = 1;
  int repetitions = 1;
  std::vector<std::string> methods;      ///< in the order of the .ini
  std::vector<std::string> metrics;      ///< ids
  std::vector<std::string> descriptors;  ///< ids
  bool exact_confinement = false;
  double safe_distance = kSafeDistance;  ///< m
  RunSetup setup;
  LimitsSection limits;
  RecordSection record;
  double reference_gap = 0.01;
};

/// What a run is measured with: the robot, the simulation's limits, every metric or those enabled,
/// from [robot], [simulation] and [metrics], each with its defaults. Throws Error (Usage).
CampaignOptions read_measuring_options(const IniFile& ini);

/// Reads [campaign], [robot], [sensor], [odometry], [simulation], [metrics] and [limits] and checks
/// them against each other. Throws Error (Usage). reference_gap is left for the reader of
/// [reference].
CampaignOptions read_campaign_options(const IniFile& ini);

}  // namespace slalom
