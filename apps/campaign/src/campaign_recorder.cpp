#include "campaign_recorder.h"
#include "interrupt.h"
#include "manifest.h"
#include "recording.h"

#include <slalom/app/adapters.h>
#include <slalom/ompl/ompl_planner.h>

namespace slalom {
namespace {

/// The quantities with these ids, in that order.
template <typename Find>
std::vector<QuantityInfo> infos(const std::vector<std::string>& ids, Find find) {
  std::vector<QuantityInfo> infos;
  for (const std::string& id : ids) infos.push_back(find(id).info());
  return infos;
}

std::unique_ptr<ReferencePlanner> planner_of(const IniFile& ini) {
  return make_ompl_planner(read_options<OmplOptions>(ini, "reference"),
                           read_campaign_options(ini).setup.robot);
}

Campaign campaign_of(const IniFile& ini, const MethodRegistry& registry,
                     const ReferencePlanner* planner, const std::vector<Scenario>& scenarios) {
  Campaign campaign{read_campaign_options(ini), scenarios, ini, registry, planner};
  campaign.options.reference_gap = read_options<OmplOptions>(ini, "reference").gap;
  return campaign;
}

ResultFile create_file(const std::string& path, const Campaign& campaign, const Manifest& notes) {
  Manifest manifest = make_manifest(campaign);
  manifest.insert(notes.begin(), notes.end());
  return ResultFile::create(path, manifest, infos(campaign.options.descriptors, descriptor),
                            infos(campaign.options.metrics, metric));
}

}  // namespace

CampaignRecorder::CampaignRecorder(const IniFile& ini, const CampaignArguments& arguments,
                                   const std::vector<Scenario>& scenarios,
                                   const std::string& results_path, const Manifest& notes)
    : registry_(all_adapters()),
      planner_(planner_of(ini)),
      campaign_(campaign_of(ini, registry_, planner_.get(), scenarios)),
      file_(create_file(results_path, campaign_, notes)),
      sink_(file_),
      progress_(make_terminal_progress(arguments.quiet)),
      jobs_(arguments.jobs) {
  record_rawlogs(campaign_, results_path);
}

CampaignRecorder::~CampaignRecorder() = default;

bool CampaignRecorder::run(std::vector<Scenario> scenarios) {
  const InterruptGuard guard;
  campaign_.scenarios = std::move(scenarios);
  const CampaignSummary summary =
      run_campaign(campaign_, sink_, {jobs_, *progress_, InterruptGuard::raised});
  file_.commit();
  errors_ += summary.infrastructure_errors();
  return summary.complete;
}

std::string CampaignRecorder::problem() const {
  return errors_ == 0 ? "" : std::to_string(errors_) + " runs ended as infrastructure_error";
}

}  // namespace slalom
