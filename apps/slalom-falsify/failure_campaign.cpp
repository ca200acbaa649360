// SPDX-License-Identifier: BSD-3-Clause
#include "failure_campaign.h"

#include <slalom/app/interrupt.h>
#include <slalom/app/output_folder.h>
#include <slalom/app/program.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/falsification/failure_files.h>
#include <slalom/io/result_file.h>

#include <filesystem>

namespace slalom {
namespace {

/// The campaign's .ini with the list in `list_path` as its only source of scenarios.
IniFile ini_of_list(const FalsifyCampaign& campaign, const std::string& list_path,
                    RecordedRuns rawlogs) {
  IniFile ini = campaign.ini;
  for (const std::string& section : campaign.ini.sections())
    if (section == "scenarios" || starts_with(section, "generator."))
      for (const std::string& key : campaign.ini.keys(section)) ini.remove(section, key);
  const auto list = std::filesystem::absolute(list_path).lexically_normal();
  ini.set("scenarios", "list", list.string());
  ini.set("campaign", "repetitions", std::to_string(campaign.setup.repetition + 1));
  ini.set("record", "rawlog", to_string(rawlogs));
  ini.set("record", "trajectories", to_string(StoredTrajectories::All));
  // Files that were found where the .ini is or in the current folder, where the copy may not be.
  for (const auto& [key, path] : campaign.config.method_files)
    if (std::filesystem::exists(path)) {
      const std::size_t dot = key.rfind('.');
      ini.set(key.substr(0, dot), key.substr(dot + 1), std::filesystem::absolute(path).string());
    }
  return ini;
}

void run_examination(const Examination& examination, const FalsifyCampaign& campaign,
                     const FalsifyArguments& arguments) {
  const std::string list = arguments.output + "/" + kExaminedScenarios;
  write_scenarios(examination, list);
  CampaignConfig config = read_campaign(ini_of_list(campaign, list, RecordedRuns::None));
  config.privileged = campaign.config.privileged;
  config.options.adapt_to(examination.scenarios);
  CampaignArguments run = arguments.campaign;
  run.quiet = true;  // a part of the job, which takes seconds
  run.existing = ExistingResults::Overwrite;
  const std::string results = arguments.output + "/" + kExaminedResults;
  ResultFile file = open_campaign_results(config, run, examination.scenarios, results);
  const CampaignReport report =
      run_campaign_program(config, run, examination.scenarios, std::move(file));
  if (!report.complete || InterruptGuard::raised())
    throw Interrupted("the same command writes the report");
  if (!report.problem.empty()) throw job_error(results, report.problem);
}

}  // namespace

void write_output(const std::vector<Failure>& failures, const FalsifyCampaign& campaign,
                  const std::string& folder, const std::string& search) {
  make_output_folder(folder);
  write_failures(failures, campaign.setup, describe_options(campaign.config.options), folder,
                 search);
  const IniFile ini = ini_of_list(campaign, folder + "/failures.scenarios", RecordedRuns::All);
  write_file_atomically(folder + "/failures.ini", ini.canonical_text());
}

std::vector<ReportedCluster> report_clusters(const std::vector<Failure>& failures,
                                             const FalsifyCampaign& campaign,
                                             const FalsifyArguments& arguments) {
  if (failures.empty()) {
    remove_cluster_report(arguments.output);
    return {};
  }
  const Examination examination = examination_of(failures, campaign.setup, arguments.output);
  run_examination(examination, campaign, arguments);
  return write_cluster_report(examination, arguments.output);
}

}  // namespace slalom
