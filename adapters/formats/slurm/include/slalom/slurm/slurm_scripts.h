// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// A campaign in shards as a job array of Slurm: the texts of its scripts and commands. Nothing is
/// executed here.
struct SlurmCampaign {
  std::string program;                   ///< slalom-simulate, absolute
  std::vector<std::string> run_options;  ///< of `slalom-simulate run`, without shard, output, jobs
  std::string work_folder;               ///< in which the program runs, absolute
  std::string folder;                    ///< of scripts, logs and result files, absolute
  std::size_t shards = 1;
  int jobs = 1;                  ///< worker processes, and processors of a task
  std::string template_text;     ///< lines for both scripts: `#SBATCH` options, modules to load
  std::string resubmit_command;  ///< the command that submits what is missing
};

/// Slurm's limit if it cannot be asked: indexes of array tasks are below.
constexpr std::size_t kDefaultMaxArraySize = 1001;

/// MaxArraySize in the output of `scontrol show config`; none if it is not in it.
std::optional<std::size_t> parse_max_array_size(const std::string& config);

/// Some shards as one job array: shard = offset + index of the task.
struct ArrayChunk {
  std::size_t offset = 0;
  std::string indexes;  ///< "1-1000", "3,7,12-15"
};

/// Divides shard numbers, in increasing order, into arrays whose indexes are below
/// `max_array_size`.
std::vector<ArrayChunk> array_chunks(const std::vector<std::size_t>& shards,
                                     std::size_t max_array_size);

std::string job_script(const SlurmCampaign& campaign);    ///< job.sbatch, one task per shard
std::string merge_script(const SlurmCampaign& campaign);  ///< merge.sbatch
std::string slurm_readme(const SlurmCampaign& campaign, std::size_t max_array_size);

/// Command lines to be executed in the folder of the campaign, which print the id of the job. The
/// merge waits for the jobs.
std::string submit_command(const ArrayChunk& chunk);
std::string submit_merge_command(const std::vector<std::string>& job_ids);

/// The id in the output of these commands, "4711" or "4711;cluster". Throws Error (Job) with the
/// output if there is none.
std::string parse_job_id(const std::string& output);

/// `text` as one word of a shell command.
std::string shell_word(const std::string& text);

}  // namespace slalom
