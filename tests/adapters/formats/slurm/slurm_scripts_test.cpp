// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/slurm/slurm_scripts.h>

#include <gtest/gtest.h>

#include <numeric>

namespace slalom {
namespace {

std::vector<std::size_t> numbers_to(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{1});
  return numbers;
}

std::string text_of(const std::vector<ArrayChunk>& chunks) {
  std::string text;
  for (const ArrayChunk& chunk : chunks)
    text += chunk.indexes + "+" + std::to_string(chunk.offset) + " ";
  return text;
}

SlurmCampaign campaign() {
  SlurmCampaign campaign;
  campaign.program = "/opt/slalom/bin/slalom-simulate";
  campaign.run_options = {"-c", "/home/ö k/it's.ini", "--set", "robot.max_v=1"};
  campaign.work_folder = "/home/ö k";
  campaign.folder = "/scratch/ö k/$run";
  campaign.shards = 16;
  campaign.jobs = 4;
  campaign.template_text = "#SBATCH --account=lab\nmodule load gcc";
  campaign.resubmit_command = "slalom-simulate slurm --submit";
  return campaign;
}

TEST(SlurmScripts, ArrayIndexesStayBelowTheLimit) {
  EXPECT_EQ(text_of(array_chunks(numbers_to(1), 1001)), "1+0 ");
  EXPECT_EQ(text_of(array_chunks(numbers_to(1000), 1001)), "1-1000+0 ");
  EXPECT_EQ(text_of(array_chunks(numbers_to(1001), 1001)), "1-1000+0 1+1000 ");
  EXPECT_EQ(text_of(array_chunks(numbers_to(1002), 1001)), "1-1000+0 1-2+1000 ");
  EXPECT_EQ(text_of(array_chunks(numbers_to(5000), 1001)),
            "1-1000+0 1-1000+1000 1-1000+2000 1-1000+3000 1-1000+4000 ");
  EXPECT_EQ(text_of(array_chunks({3, 7, 50, 51, 120}, 51)), "3,7,50+0 1+50 20+100 ");
  EXPECT_EQ(text_of(array_chunks({}, 1001)), "");
}

TEST(SlurmScripts, TheLimitIsReadFromTheConfiguration) {
  EXPECT_EQ(parse_max_array_size("MailProg = x\nMaxArraySize            = 50\nA = 1\n"), 50U);
  EXPECT_FALSE(parse_max_array_size("sh: 1: scontrol: not found\n"));
  EXPECT_FALSE(parse_max_array_size("MaxArraySize = 0\n"));
}

TEST(SlurmScripts, TheJobRunsOneShardAndPassesSignalsOn) {
  const std::string script = job_script(campaign());
  constexpr char command[] =
      "'/opt/slalom/bin/slalom-simulate' run '-c' '/home/ö k/it'\\''s.ini' '--set' 'robot.max_v=1' "
      "-j 4 --shard \"$shard/16\" -o \"$output\" \"${@:2}\" &\n";
  for (const char* part :
       {"#!/bin/bash\n", "#SBATCH --requeue\n", "#SBATCH --open-mode=append\n",
        "#SBATCH --signal=B:TERM@120\n", "#SBATCH --cpus-per-task=4\n", "#SBATCH --account=lab\n",
        "module load gcc\n", "cd -- '/home/ö k' || exit\n", command,
        "output='/scratch/ö k/$run'/$(printf 'shard-%05d.results' \"$shard\")\n"})
    EXPECT_NE(script.find(part), std::string::npos) << part << "\nin\n" << script;
  EXPECT_LT(script.find("#SBATCH --account"), script.find("cd --")) << "options come first";
}

TEST(SlurmScripts, TheMergeSaysHowToSubmitWhatIsMissing) {
  const std::string script = merge_script(campaign());
  EXPECT_NE(script.find(" merge -o '/scratch/ö k/$run'/all.results '/scratch/ö k/$run'\n"),
            std::string::npos)
      << script;
  EXPECT_NE(script.find("echo 'slalom-simulate slurm --submit'\n"), std::string::npos) << script;
}

TEST(SlurmScripts, TheReadmeHasACommandForEachArrayAndTheMergeWaitsForAll) {
  SlurmCampaign large = campaign();
  large.shards = 1002;
  const std::string text = slurm_readme(large, 1001);
  for (const char* part :
       {"cd '/scratch/ö k/$run'\n", "ids=$ids:$(sbatch --parsable --array=1-1000 job.sbatch 0)\n",
        "ids=$ids:$(sbatch --parsable --array=1-2 job.sbatch 1000)\n",
        "sbatch --parsable --dependency=afterany$ids merge.sbatch\n", "--missing"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\nin\n" << text;
  EXPECT_EQ(submit_merge_command({"12", "13"}),
            "sbatch --parsable --dependency=afterany:12:13 merge.sbatch");
  EXPECT_EQ(submit_merge_command({}), "sbatch --parsable merge.sbatch");
}

TEST(SlurmScripts, AJobIdIsReadOrTheOutputIsReported) {
  EXPECT_EQ(parse_job_id("4711\n"), "4711");
  EXPECT_EQ(parse_job_id("4711;cluster\n"), "4711");
  EXPECT_EQ(parse_job_id("sbatch: warning: slow\n4711\n"), "4711");
  EXPECT_TRUE(throws_error(ErrorKind::Job, "sbatch: printed nothing", {"the id of the job"},
                           [] { parse_job_id(" \n"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Job, "sbatch: ", {"Invalid account"},
                           [] { parse_job_id("sbatch: error: Invalid account"); }));
}

}  // namespace
}  // namespace slalom
