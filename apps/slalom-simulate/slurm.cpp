// SPDX-License-Identifier: BSD-3-Clause
#include "verbs.h"

#include <slalom/app/campaign_arguments.h>
#include <slalom/app/checks.h>
#include <slalom/app/output_folder.h>
#include <slalom/app/program.h>
#include <slalom/campaign/campaign_folder.h>
#include <slalom/core/error.h>
#include <slalom/core/program_path.h>
#include <slalom/core/read_file.h>
#include <slalom/io/merge_results.h>
#include <slalom/io/result_file.h>
#include <slalom/io/scenario_list.h>
#include <slalom/slurm/slurm_scripts.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <numeric>
#include <sys/wait.h>

namespace slalom {
namespace {

namespace fs = std::filesystem;

struct SlurmArguments {
  CampaignArguments campaign;
  std::string scenarios, output, template_path;
  std::size_t shards = 0;
  bool submit = false;
};

std::string absolute(const std::string& path) {
  return fs::absolute(path).lexically_normal().string();
}

/// The exit status and the output of a shell command, errors included.
std::pair<int, std::string> execute(const std::string& command) {
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) throw job_error(command, "cannot be started");
  std::string output;
  std::array<char, 4096> part{};
  for (std::size_t size = 1; size > 0;) {
    size = fread(part.data(), 1, part.size(), pipe);
    output.append(part.data(), size);
  }
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, output};
}

std::string submit(const std::string& folder, const std::string& command) {
  const auto [status, output] = execute("cd " + shell_word(folder) + " && " + command);
  if (status != 0)
    throw job_error(command, "failed with exit status " + std::to_string(status) + ": " + output,
                    "the id of a job");
  return parse_job_id(output);
}

/// Options for `slalom-simulate run`, from those of this verb.
std::vector<std::string> campaign_options(const SlurmArguments& arguments) {
  std::vector<std::string> options = {"-c", absolute(arguments.campaign.config), "--scenarios",
                                      absolute(arguments.scenarios)};
  if (arguments.campaign.seed)
    options.insert(options.end(), {"--seed", std::to_string(*arguments.campaign.seed)});
  for (const std::string& assignment : arguments.campaign.overrides)
    options.insert(options.end(), {"--set", assignment});
  return options;
}

std::string resubmit_command(const SlurmArguments& arguments, const SlurmCampaign& campaign) {
  std::string command =
      "cd " + shell_word(campaign.work_folder) + " && " + shell_word(campaign.program) + " slurm";
  for (const std::string& word : campaign.run_options) command += " " + shell_word(word);
  command += " -o " + shell_word(campaign.folder) + " --shards " + std::to_string(campaign.shards) +
             " -j " + std::to_string(campaign.jobs);
  if (!arguments.template_path.empty())
    command += " --template " + shell_word(absolute(arguments.template_path));
  return command + " --submit";
}

SlurmCampaign slurm_campaign(const SlurmArguments& arguments) {
  SlurmCampaign campaign;
  campaign.program = program_path();
  campaign.run_options = campaign_options(arguments);
  campaign.work_folder = fs::current_path().string();
  campaign.folder = absolute(arguments.output);
  campaign.shards = arguments.shards;
  campaign.jobs = arguments.campaign.jobs;
  if (!arguments.template_path.empty())
    campaign.template_text = read_text(arguments.template_path, "a template", kMaxConfigSize);
  campaign.resubmit_command = resubmit_command(arguments, campaign);
  return campaign;
}

/// The shards that are neither done nor running.
std::vector<std::size_t> shards_to_run(const SlurmCampaign& campaign) {
  std::vector<std::size_t> shards(campaign.shards);
  std::iota(shards.begin(), shards.end(), std::size_t{1});
  if (campaign_files(campaign.folder).empty()) return shards;
  const CampaignStatus status = read_campaign_status(campaign.folder);
  if (status.plan.shard.count != campaign.shards)
    throw usage_error("--shards " + std::to_string(campaign.shards),
                      campaign.folder + " contains another number of shards",
                      std::to_string(status.plan.shard.count) + ", or another folder");
  return status.unfinished();
}

void submit_all(const SlurmCampaign& campaign, const std::vector<std::size_t>& shards,
                std::size_t max_array_size) {
  std::vector<std::string> ids;
  for (const ArrayChunk& chunk : array_chunks(shards, max_array_size)) {
    ids.push_back(submit(campaign.folder, submit_command(chunk)));
    std::cout << "submitted job " << ids.back() << ": " << chunk.indexes
              << (chunk.offset > 0 ? " + " + std::to_string(chunk.offset) : "") << "\n";
  }
  std::cout << "submitted job " << submit(campaign.folder, submit_merge_command(ids))
            << ": merge\n";
}

void write_slurm(const SlurmArguments& arguments) {
  if (arguments.campaign.jobs == 0)
    throw usage_error("-j 0", "a task of Slurm has a fixed number of cores", "1 to 1024");
  // Errors are found here, not in a thousand tasks.
  const IniFile ini = load_campaign_ini(arguments.campaign);
  for (const char* name : {"/job.sbatch", "/merge.sbatch", "/README.txt"})
    refuse_output_over_inputs(arguments.output + name, ini);
  read_campaign(ini);
  ScenarioList::open(arguments.scenarios);
  make_output_folder(arguments.output);
  const SlurmCampaign campaign = slurm_campaign(arguments);
  const std::vector<std::size_t> shards = shards_to_run(campaign);
  const std::size_t max_array_size =
      parse_max_array_size(execute("scontrol show config").second).value_or(kDefaultMaxArraySize);
  write_file_atomically(campaign.folder + "/job.sbatch", job_script(campaign));
  write_file_atomically(campaign.folder + "/merge.sbatch", merge_script(campaign));
  write_file_atomically(campaign.folder + "/README.txt", slurm_readme(campaign, max_array_size));
  if (arguments.submit) return submit_all(campaign, shards, max_array_size);
  if (!arguments.campaign.quiet)
    std::cerr << arguments.output << ": job.sbatch, merge.sbatch and README.txt for "
              << arguments.shards << " shards; nothing was submitted\n";
}

}  // namespace

void define_slurm(CLI::App& app) {
  static SlurmArguments arguments;
  CLI::App* verb = app.add_subcommand("slurm", "Write the scripts of a job array for Slurm");
  add_argument(*verb, {"campaign", "-c,--config", "The campaign's .ini"},
               arguments.campaign.config);
  verb->add_option("--scenarios", arguments.scenarios, "A scenario list (.scenarios)")->required();
  verb->add_option("-o,--output", arguments.output,
                   "Folder for scripts, logs and result files; tasks write to it")
      ->required();
  verb->add_option("--shards", arguments.shards, "Number of shards, one task each")
      ->required()
      ->check(in_range(1, kMaxShards));
  verb->add_option("--template", arguments.template_path,
                   "Lines for both scripts: more #SBATCH options, commands such as module load");
  verb->add_flag("--submit", arguments.submit,
                 "Submit the shards that are neither done nor running, and the merge");
  add_campaign_options(*verb, arguments.campaign);
  verb->get_option("--jobs")->description("Cores and worker processes of each task");
  verb->callback([] { write_slurm(arguments); });
}

}  // namespace slalom
