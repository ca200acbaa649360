#pragma once

#include "result_sink.h"

#include <slalom/app/campaign_program.h>
#include <slalom/campaign/campaign.h>
#include <slalom/core/progress.h>

#include <memory>
#include <string>
#include <vector>

namespace slalom {

/// A campaign whose runs go to one result file, scenarios in one batch or in several.
class CampaignRecorder {
 public:
  /// Makes the result file. `scenarios` (all that may be run) and `notes` stand in its manifest.
  CampaignRecorder(const IniFile& ini, const CampaignArguments& arguments,
                   const std::vector<Scenario>& scenarios, const std::string& results_path,
                   const Manifest& notes = {});
  ~CampaignRecorder();

  const CampaignOptions& options() const { return campaign_.options; }

  /// Runs every method in these scenarios; false when interrupted. What is there is kept.
  bool run(std::vector<Scenario> scenarios);

  /// One line when something of the job itself failed; "" otherwise.
  std::string problem() const;

  const ResultFile& file() const { return file_; }

 private:
  MethodRegistry registry_;
  std::unique_ptr<ReferencePlanner> planner_;
  Campaign campaign_;
  ResultFile file_;
  ResultSink sink_;
  std::unique_ptr<Progress> progress_;
  int jobs_;
  std::size_t errors_ = 0;
};

}  // namespace slalom
