#include "recording.h"

#include <slalom/app/output_folder.h>
#include <slalom/io/rawlog_place.h>
#include <slalom/rawlog/run_recorder.h>

namespace slalom {

void record_rawlogs(Campaign& campaign, const std::string& results_path) {
  if (campaign.options.record.rawlog == "none") return;
  make_output_folder(rawlog_folder(results_path));
  campaign.recorder = [&campaign, results_path](const RunSpec& spec) {
    const Scenario& scenario = campaign.scenarios[spec.scenario];
    return make_rawlog_recorder(
        rawlog_path(results_path, scenario.hash(), spec.method, spec.repetition),
        make_run_manifest(campaign.ini, scenario, spec.method, spec.repetition, spec.seed));
  };
}

}  // namespace slalom
