// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"
#include "program_run.h"

#include <SQLiteCpp/SQLiteCpp.h>

namespace slalom {
namespace {

class Simulate : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("small.ini", kSmallCampaign);
  }
};

TEST_F(Simulate, AgreesWithEvaluateOnTheSameList) {
  ASSERT_EQ(run("slalom-evaluate small.ini -o out --quiet").status, 0);
  const ProgramResult result = run(
      "slalom-simulate run -c small.ini --scenarios out/campaign.scenarios -o runs.results -j 2");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(run("slalom-analyze dump runs.results").out,
            run("slalom-analyze dump out/runs.results").out);
}

TEST_F(Simulate, RunsTheCampaignThatAResultFileContains) {
  ASSERT_EQ(run("slalom-simulate run small.ini --quiet -o a.results").status, 0);
  ASSERT_EQ(run("slalom-simulate run a.results --quiet -o b.results").status, 0);
  EXPECT_EQ(run("slalom-analyze dump a.results").out, run("slalom-analyze dump b.results").out);
  expect_failure("slalom-simulate run a.results -o a.results --overwrite", 2,
                 {"-o a.results", "is also an input"});
  std::filesystem::copy_file(kFollowTheGap, folder_ / "mine.so");
  ASSERT_EQ(run("slalom-simulate run small.ini --set method.gap.plugin=./mine.so --quiet "
                "-o mine.results")
                .status,
            0);
  expect_failure("slalom-simulate run mine.results -o c.results", 2,
                 {"mine.results", "would execute", "./mine.so", "--trust"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "c.results"));
  EXPECT_EQ(run("slalom-simulate run mine.results --trust --quiet -o c.results").status, 0);
  expect_failure("slalom-simulate run none.results -o c.results", 3, {"none.results"});
}

TEST_F(Simulate, SaysBeforeTheRunsInWhichScenariosNobodyCanArriveInTime) {
  write("far.scenario.yaml",
        "name: far\nrepresentation: continuous\nbounds: [0, -2, 30, 2]\nstart: [1, 0, 0]\n"
        "goal: [27.8, 0]\ndiscs: []\npolygons: []\n");
  write("near.scenario.yaml",
        "name: near\nrepresentation: continuous\nbounds: [0, -2, 30, 2]\nstart: [1, 0, 0]\n"
        "goal: [5, 0]\ndiscs: []\npolygons: []\n");
  ASSERT_EQ(
      run("slalom-scenarios import far.scenario.yaml near.scenario.yaml -o two.scenarios").status,
      0);
  const std::string simulate =
      "slalom-simulate run small.ini --quiet --scenarios two.scenarios --set robot.max_v=0.26 ";
  // The path to within 0.2 m of the goal.
  const std::string note =
      "in 1 of 2 scenarios nobody can arrive within 60 s: far; in far the shortest path takes at "
      "least "
      "102.4 s at 0.26 m/s\n";
  const ProgramResult hurried = run(simulate + "--set simulation.max_time=60 -o a.results");
  EXPECT_EQ(hurried.err.find(note), 0U) << hurried.err;
  EXPECT_NE(run("slalom-analyze dump a.results").out.find("nobody can arrive within 60 s"),
            std::string::npos);
  for (const std::string verb : {"summary", "table"})
    EXPECT_NE(run("slalom-analyze " + verb + " a.results").err.find(note), std::string::npos);
  ASSERT_EQ(run("slalom-analyze report a.results -o report").status, 0);
  EXPECT_NE(read("report/index.html").find(note.substr(0, note.size() - 1)), std::string::npos);

  const ProgramResult enough = run(simulate + "-o b.results");
  ASSERT_EQ(enough.status, 0) << enough.err;
  EXPECT_EQ(enough.err.find("nobody"), std::string::npos) << enough.err;
  EXPECT_EQ(run("slalom-analyze dump b.results").out.find("timeout"), std::string::npos);
}

TEST_F(Simulate, RejectsInvalidListsAndVerbs) {
  expect_failure("slalom-simulate run -c small.ini --scenarios small.ini -o runs.results", 3,
                 {"small.ini"});
  expect_failure("slalom-simulate fly", 2, {"unknown verb 'fly'", "run"});
}

TEST_F(Simulate, NoOutputReplacesAFileThatTheConfigurationNames) {
  std::filesystem::copy_file(kFollowTheGap, folder_ / "gap.so");
  const std::string plugin = read("gap.so");
  expect_failure(
      "slalom-simulate run small.ini --set method.gap.plugin=./gap.so -o gap.so --overwrite", 2,
      {"-o gap.so", "is also an input", "method.gap.plugin", "./gap.so"});
  EXPECT_EQ(read("gap.so"), plugin);
}

TEST_F(Simulate, TakesTheConfigurationAsAnArgumentOrAnOption) {
  EXPECT_EQ(run("slalom-simulate run small.ini --quiet -o a.results").status, 0);
  EXPECT_EQ(run("slalom-simulate run -c small.ini --quiet -o b.results").status, 0);
  EXPECT_EQ(run("slalom-analyze dump a.results").out, run("slalom-analyze dump b.results").out);
  expect_failure("slalom-simulate run small.ini -c other.ini -o c.results", 2,
                 {"small.ini", "other.ini"});
  expect_failure("slalom-simulate run -o c.results", 2, {"campaign is required"});
}

TEST_F(Simulate, MergedShardsAreTheRunsOfTheCampaign) {
  ASSERT_EQ(run("slalom-simulate run small.ini --quiet -o all.results").status, 0);
  std::filesystem::create_directories(folder_ / "shards é");
  for (const std::string i : {"1", "2", "3", "4", "5"}) {  // of 4 scenarios: one shard is empty
    const ProgramResult result = run("slalom-simulate run small.ini --quiet --shard " + i +
                                     "/5 -o 'shards é/" + i + ".results'");
    ASSERT_EQ(result.status, 0) << result.err;
  }
  EXPECT_EQ(run("slalom-analyze dump 'shards é/5.results'").out, "") << "an empty shard is valid";
  const ProgramResult merged = run("slalom-simulate merge 'shards é' -o merged.results");
  ASSERT_EQ(merged.status, 0) << merged.err;
  EXPECT_EQ(merged.err, "merged.results: 8 of 8 runs from 5 files; complete\n");
  EXPECT_EQ(run("slalom-analyze dump merged.results").out,
            run("slalom-analyze dump all.results").out);
  EXPECT_EQ(run("slalom-simulate merge -o merged.results 'shards é' merged.results").status, 2);
  expect_failure("slalom-simulate run small.ini --shard 2/5 -o 'shards é/1.results'", 3,
                 {"contains shard 1/5", "--overwrite"});

  run("mv 'shards é/2.results' 'shards é/3.results' . && cp 'shards é/1.results' 'shards "
      "é/b.results'");
  expect_failure("slalom-simulate merge -o merged.results 'shards é'", 1,
                 {"merged.results: 4 of 8 runs; missing: shards 2-3", "--allow-incomplete"});
  const auto merged_runs = [&] {
    const std::string lines = run("slalom-analyze dump merged.results").out;
    return std::count(lines.begin(), lines.end(), '\n');
  };
  EXPECT_EQ(merged_runs(), 8) << "kept";
  EXPECT_EQ(run("slalom-simulate merge -o merged.results 'shards é' --allow-incomplete").err,
            "merged.results: 4 of 8 runs from 4 files, 2 equal duplicates; missing: shards 2-3\n");
  EXPECT_EQ(merged_runs(), 4);
  expect_failure("slalom-simulate merge -o merged.results small.ini", 3, {"small.ini"});
  expect_failure("slalom-simulate merge -o small.ini 3.results", 3, {"small.ini"});
}

TEST_F(Simulate, RunsAmongMoversAreTheSameInWorkersShardsAndContinuations) {
  const std::string command =
      "slalom-simulate run small.ini --quiet --set scenarios.walkers=2 --set metrics.enabled=all ";
  const auto dump = [this](const std::string& results) {
    return run("slalom-analyze dump " + results).out;
  };
  ASSERT_EQ(run(command + "-o one.results -j 1").status, 0);
  const std::string expected = dump("one.results");
  EXPECT_NE(expected.find("\"mover_collision\":{"), std::string::npos);
  ASSERT_EQ(run(command + "-o two.results -j 2").status, 0);
  EXPECT_EQ(dump("two.results"), expected);
  for (const std::string i : {"1", "2"})
    ASSERT_EQ(run(command + "-o part" + i + ".results --shard " + i + "/2").status, 0);
  ASSERT_EQ(run("slalom-simulate merge -o merged.results part1.results part2.results").status, 0);
  EXPECT_EQ(dump("merged.results"), expected);
  SQLite::Database((folder_ / "two.results").string(), SQLite::OPEN_READWRITE)
      .exec(
          "DELETE FROM runs WHERE run % 2 = 0; DELETE FROM trajectories WHERE run % 2 = 0; "
          "DELETE FROM run_timings WHERE run % 2 = 0");
  ASSERT_NE(dump("two.results"), expected);
  ASSERT_EQ(run(command + "-o two.results").status, 0);
  EXPECT_EQ(dump("two.results"), expected);
  EXPECT_EQ(run("slalom-simulate verify one.results --trust").status, 0);
}

TEST_F(Simulate, InvalidShardsAreRefused) {
  for (const char* shard : {"0/4", "5/4", "a", "1/0"})
    expect_failure("slalom-simulate run small.ini -o a.results --shard " + std::string(shard), 2,
                   {"--shard", shard, "I/N with I from 1 to N"});
  expect_failure("slalom-evaluate small.ini -o out --until 'interval(success) < 0.1' --shard 1/4",
                 2, {"--shard"});
}

TEST_F(Simulate, StatusTellsWhichShardsAreMissingFromTheirFiles) {
  expect_failure("slalom-simulate status .", 3, {"contains no result files"});
  for (const char* i : {"1", "3"})
    ASSERT_EQ(run("slalom-simulate run small.ini --quiet --shard " + std::string(i) + "/5 -o " + i +
                  ".results")
                  .status,
              0);
  EXPECT_EQ(run("slalom-simulate status .").out,
            "4 of 8 runs in 5 shards\n  done: 1,3\n  missing: 2,4-5\n");
  EXPECT_EQ(run("slalom-simulate status . --missing").out, "2,4-5\n");
  run("sqlite3 1.results 'DELETE FROM runs WHERE run = 2'");
  write("4.results", "SQLite format 3");
  write("other.txt", "");
  const ProgramResult status = run("slalom-simulate status .");
  EXPECT_NE(status.out.find("3 of 8 runs in 5 shards\n  done: 3\n  failed: 1\n  missing: 2,4-5\n"
                            "shard 1: 1 of 2 runs in ./1.results\n./4.results: "),
            std::string::npos)
      << status.out;
  const std::string json = run("slalom-simulate status . --json").out;
  for (const char* part : {R"("missing":"1-2,4-5")", R"("planned":8,)", R"("state":"failed")"})
    EXPECT_NE(json.find(part), std::string::npos) << part << " in " << json;
}

TEST_F(Simulate, VerifyRunsASampleAgainAndNamesWhatIsDifferent) {
  std::filesystem::copy_file(kFollowTheGap, folder_ / "gap.so");
  ASSERT_EQ(run("slalom-simulate run small.ini --set method.gap.plugin=./gap.so --quiet "
                "-o a.results")
                .status,
            0);
  const ProgramResult same =
      run("slalom-simulate verify a.results --trust --fraction 1 --quiet -j 2");
  EXPECT_EQ(last_line(same.out), "8 of 8 runs in 4 of 4 scenarios are identical") << same.err;
  EXPECT_EQ(last_line(run("slalom-simulate verify a.results --trust --quiet").out),
            "2 of 8 runs in 1 of 4 scenarios are identical");
  const std::string dump = run("slalom-analyze dump a.results").out;
  const std::string key = "\"hash\":\"";
  const std::string id = dump.substr(dump.find(key) + key.size(), 8) + "/gap/0";
  EXPECT_EQ(run("slalom-simulate verify a.results --trust --quiet --run " + id).out,
            "1 run is identical\n")
      << id;
  const ProgramResult unknown =
      run("slalom-simulate verify a.results --trust --quiet --run 0/gap/0");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("no such run in these results"), std::string::npos) << unknown.err;
  // Another method under the name of the library that the campaign used.
  std::filesystem::copy_file(kMethods + "/libslalom_go_to_goal.so", folder_ / "gap.so",
                             std::filesystem::copy_options::overwrite_existing);
  const ProgramResult changed =
      run("slalom-simulate verify a.results --trust --fraction 1 --quiet");
  EXPECT_EQ(changed.status, 1);
  EXPECT_NE(changed.out.find("/gap/0: /"), std::string::npos) << changed.out;
  EXPECT_NE(changed.out.find("environment: plugin of method.gap is not the one of a.results\n"),
            std::string::npos)
      << changed.out;
  EXPECT_NE(changed.err.find("differences in 8 runs"), std::string::npos) << changed.err;
}

/// Commands in the place of Slurm's.
class Slurm : public Simulate {
 protected:
  void SetUp() override {
    Simulate::SetUp();
    const std::string text = kSmallCampaign;
    const std::size_t begin = text.find("[scenarios]");
    write("generate.ini", text.substr(begin, text.find("[method.nd]") - begin));
    ASSERT_EQ(run("slalom-scenarios generate -c generate.ini -n 3 -o 'my list.scenarios'").status,
              0);
    provide("scontrol", "echo 'MaxArraySize = 4'");
    provide("sbatch",
            "pwd >> \"$HOME/calls\"; echo \"$@\" >> \"$HOME/calls\"; wc -l < \"$HOME/calls\"");
  }
  void provide(const std::string& name, const std::string& script) const {
    std::filesystem::create_directories(folder_ / "bin");
    write("bin/" + name, "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(folder_ / "bin" / name, std::filesystem::perms::all);
  }
  std::string command(const std::string& options) const {
    const std::string folder = folder_.string();
    return "env HOME=" + folder + " sh -c 'PATH=\"" + folder +
           "/bin:$PATH\" slalom-simulate slurm -c small.ini --scenarios \"my list.scenarios\" "
           "-o \"é out\" " +
           options + "'";
  }
};

TEST_F(Slurm, WritesScriptsAndSubmitsThemOnlyOnRequest) {
  write("site.txt", "#SBATCH --account=lab\n");
  ASSERT_EQ(run(command("--shards 5 -j 2 --template site.txt")).status, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "calls"));
  EXPECT_NE(read("é out/job.sbatch").find("#SBATCH --account=lab\n"), std::string::npos);
  EXPECT_NE(read("é out/README.txt").find("--array=1-2 job.sbatch 3"), std::string::npos);
  EXPECT_EQ(run("sh -n 'é out/merge.sbatch'").status, 0);
  const ProgramResult result = run(command("--shards 5 --submit"));
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out, "submitted job 2: 1-3\nsubmitted job 4: 1-2 + 3\nsubmitted job 6: merge\n");
  const std::string out = (folder_ / "é out").string() + "\n";
  EXPECT_EQ(read("calls"), out + "--parsable --array=1-3 job.sbatch 0\n" + out +
                               "--parsable --array=1-2 job.sbatch 3\n" + out +
                               "--parsable --dependency=afterany:2:4 merge.sbatch\n");
}

TEST_F(Slurm, TheScriptsRunTheShardsAndOnlyWhatIsMissingIsSubmittedAgain) {
  ASSERT_EQ(run(command("--shards 5")).status, 0);
  for (const std::string i : {"1", "2"}) {
    const ProgramResult task =
        run("cd 'é out' && SLURM_ARRAY_TASK_ID=" + i + " bash job.sbatch 3 --quiet");
    ASSERT_EQ(task.status, 0) << task.err;  // shards 4 and 5
  }
  EXPECT_EQ(run("slalom-simulate status 'é out' --missing").out, "1-3\n");
  const ProgramResult merge = run("bash 'é out/merge.sbatch'");
  EXPECT_EQ(merge.status, 1) << "no run is in shards 4 and 5";
  EXPECT_NE(merge.err.find("missing: shards 1-3"), std::string::npos) << merge.err;
  EXPECT_NE(merge.out.find(" --shards 5 -j 1 --submit"), std::string::npos) << merge.out;
  EXPECT_EQ(run(command("--shards 5 --submit")).out,
            "submitted job 2: 1-3\nsubmitted job 4: merge\n");
  expect_failure(command("--shards 6"), 2, {"--shards 6", "expected 5"});
  expect_failure(command("--shards 5 -j 0"), 2, {"-j 0", "expected 1 to 1024"});
  for (const std::string i : {"1", "2", "3"})
    ASSERT_EQ(run("SLURM_ARRAY_TASK_ID=" + i + " bash 'é out/job.sbatch' 0").status, 0);
  ASSERT_EQ(run("bash 'é out/merge.sbatch'").status, 0);
  ASSERT_EQ(run("slalom-simulate run -c small.ini --scenarios 'my list.scenarios' -o whole.results")
                .status,
            0);
  EXPECT_EQ(run("slalom-analyze dump 'é out/all.results'").out,
            run("slalom-analyze dump whole.results").out);
}

TEST_F(Slurm, FailuresOfSlurmAreReported) {
  provide("sbatch", "echo 'sbatch: error: Invalid account' >&2; exit 1");
  expect_failure(command("--shards 2 --submit"), 1, {"exit status 1", "Invalid account"});
  provide("sbatch", "exit 0");
  expect_failure(command("--shards 2 --submit"), 1, {"sbatch: printed nothing"});
  std::filesystem::remove(folder_ / "bin/sbatch");
  provide("scontrol", "exit 1");
  if (run("command -v sbatch").status != 0)
    expect_failure(command("--shards 2 --submit"), 1, {"127", "sbatch"});
  expect_failure(command("--shards 0"), 2, {"--shards"});
  EXPECT_NE(read("é out/README.txt").find("--array=1-2 job.sbatch 0"), std::string::npos)
      << "without scontrol the limit is 1001";
}

TEST_F(Simulate, AnExceptionOfMrptIsReportedByItsReasonOnly) {
  write("weights.ini", "[FULL_EVAL_CONFIG]\nfactorWeights = 0.1 0.5\n");  // not MRPT's section
  const std::string command =
      "slalom-simulate run -c small.ini -o runs.results --set campaign.methods=nd --set "
      "method.nd.class=CHolonomicFullEval --set method.nd.config=weights.ini";
  expect_failure(command, 2, {"config", "factorWeights", "CHolonomicFullEval"});
  EXPECT_EQ(run(command).err.find("0x"), std::string::npos) << "no addresses of a call stack";
}

}  // namespace
}  // namespace slalom
