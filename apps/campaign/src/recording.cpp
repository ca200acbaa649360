#include "recording.h"

#include <slalom/app/output_folder.h>
#include <slalom/rawlog/run_recorder.h>

#include <filesystem>

namespace slalom {

void record_rawlogs(Campaign& campaign, const std::string& results_path) {
  if (campaign.options.record.rawlog == "none") return;
  const std::string folder =
      std::filesystem::path(results_path).replace_extension(".rawlogs").string();
  make_output_folder(folder);
  campaign.recorder = [&campaign, folder](const RunSpec& spec) {
    const Scenario& scenario = campaign.scenarios[spec.scenario];
    const std::string name = scenario.hash().substr(0, 8) + "_" + spec.method + "_" +
                             std::to_string(spec.repetition) + ".rawlog";
    return make_rawlog_recorder(
        folder + "/" + name,
        make_run_manifest(campaign.ini, scenario, spec.method, spec.repetition, spec.seed));
  };
}

}  // namespace slalom
