#include <slalom/campaign/campaign_recorder.h>

namespace slalom {
CampaignRecorder::CampaignRecorder(Campaign campaign, const Manifest& manifest,
                                   const std::string& results_path)
    : campaign_(std::move(campaign)),
      file_(ResultFile::create(results_path, manifest, campaign_.options.descriptor_infos(),
                               campaign_.options.metric_infos())) {}

bool CampaignRecorder::run(std::vector<Scenario> scenarios, const Execution& execution) {
  campaign_.scenarios = std::move(scenarios);
  const CampaignSummary summary = run_campaign(campaign_, *this, execution);
  file_.commit();
  errors_ += summary.infrastructure_errors();
  return summary.complete;
}

std::string CampaignRecorder::problem() const {
  return errors_ == 0 ? "" : std::to_string(errors_) + " runs ended as infrastructure_error";
}

void CampaignRecorder::add_scenario(const ScenarioRecord& record, const Scenario& scenario,
                                    const References& references) {
  file_.add_scenario(record, scenario, references);
  count();
}

void CampaignRecorder::add_run(const RunRecord& run, const RunTiming& timing,
                               const Trajectory& trajectory) {
  file_.add_run(run, timing, trajectory);
  count();
}

void CampaignRecorder::count() {
  constexpr int kRecordsPerCommit = 64;
  if (++pending_ < kRecordsPerCommit) return;
  file_.commit();
  pending_ = 0;
}

}  // namespace slalom
