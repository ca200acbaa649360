// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/campaign/shards.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/slurm/slurm_scripts.h>

#include <algorithm>

namespace slalom {
namespace {

std::string shell_words(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += " " + shell_word(word);
  return text;
}

std::string header(const std::string& name, const std::string& log, const std::string& options,
                   const SlurmCampaign& campaign) {
  std::string text = "#!/bin/bash\n#SBATCH --job-name=" + name + "\n#SBATCH --output=" + log +
                     "\n#SBATCH --open-mode=append\n#SBATCH --requeue\n" + options +
                     campaign.template_text;
  if (text.back() != '\n') text += '\n';
  return text;
}

}  // namespace

std::string shell_word(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::optional<std::size_t> parse_max_array_size(const std::string& config) {
  for (const std::string& line : split(config, '\n')) {
    const std::vector<std::string> parts = split(line, '=');
    long long size = 0;
    if (parts.size() == 2 && parts[0] == "MaxArraySize" && parse_integer(parts[1], size) &&
        size > 1)
      return static_cast<std::size_t>(size);
  }
  return std::nullopt;
}

std::vector<ArrayChunk> array_chunks(const std::vector<std::size_t>& shards,
                                     std::size_t max_array_size) {
  const std::size_t chunk_size = max_array_size - 1;  // indexes from 1
  std::vector<ArrayChunk> chunks;
  for (std::size_t first = 0; first < shards.size();) {
    const std::size_t offset = (shards[first] - 1) / chunk_size * chunk_size;
    std::vector<std::size_t> indexes;
    for (; first < shards.size() && shards[first] <= offset + chunk_size; ++first)
      indexes.push_back(shards[first] - offset);
    chunks.push_back({offset, number_ranges(indexes)});
  }
  return chunks;
}

std::string job_script(const SlurmCampaign& campaign) {
  const std::string count = std::to_string(campaign.shards);
  return header("slalom", "log-%A_%a.txt",
                "#SBATCH --signal=B:TERM@120\n#SBATCH --cpus-per-task=" +
                    std::to_string(campaign.jobs) + "\n",
                campaign) +
         "# Runs shard OFFSET + SLURM_ARRAY_TASK_ID of " + count +
         ": sbatch --array=INDEXES job.sbatch OFFSET [OPTION]...\n"
         "# A task that is started again continues its file. Before the time limit, and when it "
         "is\n"
         "# requeued, the task gets SIGTERM: it keeps its finished runs and ends.\n"
         "shard=$((SLURM_ARRAY_TASK_ID + ${1:-0}))\n"
         "cd -- " +
         shell_word(campaign.work_folder) +
         " || exit\n"
         "output=" +
         shell_word(campaign.folder) + "/$(printf 'shard-%05d.results' \"$shard\")\n" +
         shell_word(campaign.program) + " run" + shell_words(campaign.run_options) + " -j " +
         std::to_string(campaign.jobs) + " --shard \"$shard/" + count +
         "\" -o \"$output\" \"${@:2}\" &\n"
         "run=$!\n"
         "trap 'stopped=1; kill -TERM \"$run\"' TERM\n"
         "stopped=1\n"
         "while [ \"$stopped\" = 1 ]; do  # the signal interrupts wait\n"
         "  stopped=0\n"
         "  wait \"$run\"\n"
         "  status=$?\n"
         "done\n"
         "exit \"$status\"\n";
}

std::string merge_script(const SlurmCampaign& campaign) {
  const std::string folder = shell_word(campaign.folder);
  return header("slalom-merge", "log-merge-%j.txt", "", campaign) + "cd -- " +
         shell_word(campaign.work_folder) + " || exit\n" + shell_word(campaign.program) +
         " merge -o " + folder + "/all.results " + folder +
         "\n"
         "status=$?\n"
         "if [ \"$status\" = 1 ]; then\n"
         "  echo \"To submit what is missing:\"\n"
         "  echo " +
         shell_word(campaign.resubmit_command) +
         "\n"
         "fi\n"
         "exit \"$status\"\n";
}

std::string slurm_readme(const SlurmCampaign& campaign, std::size_t max_array_size) {
  const std::string program = shell_word(campaign.program), folder = shell_word(campaign.folder);
  std::vector<std::size_t> numbers;
  for (std::size_t i = 1; i <= campaign.shards; ++i) numbers.push_back(i);
  std::string text = "A campaign in " + std::to_string(campaign.shards) +
                     " shards for Slurm. Submit it, and then the job that merges the shards:\n\n"
                     "cd " +
                     folder + "\nids=\n";
  for (const ArrayChunk& chunk : array_chunks(numbers, max_array_size))
    text += "ids=$ids:$(" + submit_command(chunk) + ")\n";
  text += "sbatch --parsable --dependency=afterany$ids merge.sbatch\n\n";
  text += "The state of the shards, and those that are neither done nor running:\n\n" + program +
          " status " + folder + "\n" + program + " status " + folder + " --missing\n\n";
  text += "Submit what is missing, and the merge again; finished runs are kept:\n\n" +
          campaign.resubmit_command + "\n\n" +
          "A shard whose node is gone may still be locked. If its program no longer runs:\n"
          "sbatch --array=INDEX job.sbatch OFFSET --take-over\n";
  return text;
}

std::string submit_command(const ArrayChunk& chunk) {
  return "sbatch --parsable --array=" + chunk.indexes + " job.sbatch " +
         std::to_string(chunk.offset);
}

std::string submit_merge_command(const std::vector<std::string>& job_ids) {
  const std::string after =
      job_ids.empty() ? "" : "--dependency=afterany:" + join(job_ids, ":") + " ";
  return "sbatch --parsable " + after + "merge.sbatch";
}

std::string parse_job_id(const std::string& output) {
  for (const std::string& line : split(output, '\n')) {
    const std::string id = split(line + ";", ';').front();
    if (!id.empty() &&
        std::all_of(id.begin(), id.end(), [](char c) { return c >= '0' && c <= '9'; }))
      return id;
  }
  const std::string text = trim(output);
  throw job_error("sbatch", text.empty() ? "printed nothing" : "did not submit the job: " + text,
                  "the id of the job");
}

}  // namespace slalom
