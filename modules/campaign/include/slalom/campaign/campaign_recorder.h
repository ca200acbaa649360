#pragma once

#include <slalom/campaign/campaign.h>
#include <slalom/io/result_file.h>

#include <string>
#include <vector>

namespace slalom {

/// Runs a campaign into one result file, in one or several batches of scenarios. Results are
/// committed often, so that little work is lost if the program is killed.
class CampaignRecorder : private CampaignSink {
 public:
  /// Creates the result file; the scenarios of `campaign` are not used. Throws Error (Job) when the
  /// file cannot be written.
  CampaignRecorder(Campaign campaign, const Manifest& manifest, const std::string& results_path);

  /// Runs every method in these scenarios; false if interrupted. Finished runs are kept.
  bool run(std::vector<Scenario> scenarios, const Execution& execution);

  /// One line about failures of the infrastructure; "" if there are none.
  std::string problem() const;

  const CampaignOptions& options() const { return campaign_.options; }
  const ResultFile& file() const { return file_; }

 private:
  void add_scenario(const ScenarioRecord& record, const Scenario& scenario,
                    const References& references) override;
  void add_run(const RunRecord& run, const RunTiming& timing,
               const Trajectory& trajectory) override;
  void count();

  Campaign campaign_;
  ResultFile file_;
  int pending_ = 0;  ///< records since the last commit
  std::size_t errors_ = 0;
};

}  // namespace slalom
