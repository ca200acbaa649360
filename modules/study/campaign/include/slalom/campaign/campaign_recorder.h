// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/campaign/run_campaign.h>
#include <slalom/core/wall_clock.h>
#include <slalom/io/result_file.h>
#include <slalom/results/method_failures.h>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace slalom {

struct RecorderOptions {
  WallClock clock = steady_seconds;
  /// Receives one line when another program that reads the file delays storing; null: ignored.
  std::function<void(const std::string&)> notify = nullptr;
  std::function<void(const std::string&)> warn = nullptr;  ///< likewise CampaignSink::warn()
};

/// Finished results are on disk after this time (s), also while further runs take long.
constexpr double kCommitInterval = 2;

/// Runs a campaign into one result file, in one or several batches of scenarios. Runs that the file
/// already holds are not repeated. Results are stored as they are obtained.
class CampaignRecorder : private CampaignSink {
 public:
  /// The scenarios of `campaign` are not used.
  CampaignRecorder(Campaign campaign, ResultFile file, RecorderOptions options = {});

  /// Runs every method in these scenarios; false if interrupted. Finished runs are kept.
  bool run(std::vector<Scenario> scenarios, const Execution& execution);

  /// One line about failures of the infrastructure; "" if there are none.
  std::string problem() const;

  /// The runs that methods ended by errors of their own, also those that the file held before.
  const MethodFailures& method_failures() const { return failures_; }

  /// The runs that the file held before the first call of run().
  std::size_t known_runs() const { return known_runs_.size(); }
  const CampaignOptions& options() const { return campaign_.options; }
  const ResultFile& file() const { return file_; }

 private:
  std::optional<References> known_references(const Scenario& scenario) override;
  bool has_run(const Scenario& scenario, const RunSpec& spec) override;
  void warn(const std::string& line) override;
  void add_scenario(const ScenarioRecord& record, const References& references,
                    const PackedScenario& packed) override;
  void add_run(const RunRecord& run, const RunTiming& timing,
               const PackedTrajectory& trajectory) override;
  void count_known_run(const std::string& hash, const std::string& method, int repetition,
                       const std::string& outcome);
  void expect_commit();
  void commit_when_due();
  void commit_finally(const Execution& execution);

  Campaign campaign_;
  ResultFile file_;
  RecorderOptions recording_;
  std::set<std::string> known_runs_;                      ///< "HASH/METHOD/REPETITION"
  std::map<std::string, std::size_t> known_by_scenario_;  ///< number of runs by hash
  std::optional<double> commit_at_;  ///< s, of the clock; none if everything is on disk
  bool delayed_ = false;             ///< and a notice was given
  MethodFailures failures_;
  std::size_t added_runs_ = 0;
  std::size_t errors_ = 0;
  std::string first_error_;      ///< of these, with its run
  std::size_t output_size_ = 0;  ///< of what methods printed
};

}  // namespace slalom
