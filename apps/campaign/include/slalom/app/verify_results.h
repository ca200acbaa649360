// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/app/campaign_program.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The part of the scenarios that is run again, or one run.
struct VerifySample {
  double fraction = 0.05;             ///< at least one scenario
  std::optional<std::uint64_t> seed;  ///< of the choice of scenarios; none: 0
  std::string run;     ///< HASH8/METHOD/REPETITION; empty: all runs of the scenarios of the sample
  bool trust = false;  ///< execute and load what the methods in the file name
  bool scenarios = true;  ///< make generated scenarios again and compare them
};

/// Runs of a method that were executed again, and those of them that have the same values.
struct VerifiedRuns {
  std::size_t runs = 0, identical = 0;
};

struct VerifyReport {
  bool complete = false;                            ///< false if interrupted
  std::size_t scenarios = 0, runs = 0;              ///< that were executed again
  std::size_t total_scenarios = 0, total_runs = 0;  ///< of the file; 0 for one run
  std::map<std::string, VerifiedRuns> methods;      ///< by name
  /// "200 scenarios of hash 0123..., those of slalom-small"; "" if they were not compared.
  std::string scenario_set;
  /// One line per run or scenario that is not the same, for missing runs, and for each statement of
  /// the manifest that its campaign does not make.
  std::vector<std::string> differences;
  std::vector<std::string> environment;  ///< as the EnvironmentHandler receives it
  /// One line per run that is not verifiable since a limit of time ended it here or in the file: it
  /// took long enough here that such a limit may end it on another machine.
  std::vector<std::string> time_limits;
  /// One line per run that is not verifiable since its method is not repeatable, as it showed when
  /// it was executed once more.
  std::vector<std::string> not_repeatable;

  std::vector<std::string> unchecked;  ///< what of the file cannot be verified

  std::size_t identical_runs() const;
};

/// Receives what differs from the programs, files of methods and machine that made the file.
using EnvironmentHandler = std::function<void(const std::vector<std::string>& differences)>;

/// Runs a sample of the scenarios of a result file or bundle again, all methods and repetitions, or
/// one run, and compares descriptors, references, outcomes, metrics and trajectories bit by bit;
/// unless it is one run also whether the file contains all runs of its campaign, undamaged, and the
/// scenarios that this generates. Calls `on_environment` before. The campaign is the one in the
/// file, or `arguments.config` if it is not empty. Throws Error, also for the former if it names
/// foreign code, see require_no_foreign_code().
VerifyReport verify_results(const std::string& path, const CampaignArguments& arguments,
                            const VerifySample& sample, const EnvironmentHandler& on_environment);

/// "3 of 40 runs in 1 of 20 scenarios are identical; 2 runs cannot be verified". Throws Error if a
/// run differs, or if no run could be verified since time limits ended them, and Interrupted if the
/// report is not complete.
std::string verdict(const VerifyReport& report, const std::string& path);

/// The least number of changed scenarios of which a random sample of `sampled` of `all` contains
/// one with a probability of at least 0.95.
std::size_t detectable_changes(std::size_t sampled, std::size_t all);

}  // namespace slalom
