// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"
#include "program_run.h"

#include <slalom/core/available_cores.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>

#include <SQLiteCpp/SQLiteCpp.h>
#include <nlohmann/json.hpp>

#include <sched.h>

namespace slalom {
namespace {

class Evaluate : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("small.ini", kSmallCampaign);
  }
};

TEST_F(Evaluate, WritesScenariosResultsTablesAndASelfContainedReport) {
  const ProgramResult result = run("slalom-evaluate small.ini -o out -j 2");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("Report: out/report/index.html"), std::string::npos);
  EXPECT_NE(result.out.find(read("out/tables.txt")), std::string::npos);
  EXPECT_NE(read("out/tables.csv").find("success"), std::string::npos);
  const std::string report = read("out/report/index.html");
  EXPECT_NE(report.find("gap by density"), std::string::npos);
  EXPECT_NE(read("out/report/data/pictures-1.js").find("<svg"), std::string::npos);
  for (const char* foreign : {"src=\"http", "href=\"http", "@import", "url(http"})
    EXPECT_EQ(report.find(foreign), std::string::npos) << foreign;
  EXPECT_EQ(result.err.find('\r'), std::string::npos) << "no progress bar without a terminal";
}

TEST_F(Evaluate, TheSameSeedGivesIdenticalResultsForAnyNumberOfWorkers) {
  ASSERT_EQ(run("slalom-evaluate small.ini -o one -j 1 --quiet").status, 0);
  ASSERT_EQ(run("slalom-evaluate small.ini -o two -j 2 --quiet").status, 0);
  const std::string one = run("slalom-analyze dump one/runs.results").out;
  EXPECT_EQ(std::count(one.begin(), one.end(), '\n'), 8);
  EXPECT_EQ(one, run("slalom-analyze dump two/runs.results").out);
  EXPECT_EQ(read("one/tables.csv"), read("two/tables.csv"));
}

TEST_F(Evaluate, TheDemoNeedsNoFileOfTheReader) {
  const ProgramResult result = run("slalom-evaluate --demo --quiet");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("Report: slalom-demo/report/index.html"), std::string::npos);
  EXPECT_FALSE(read("slalom-demo/report/index.html").empty());
  // Two buildings with five pairs of start and goal each, 60 random scenarios, four methods.
  const std::string runs = run("slalom-analyze dump slalom-demo/runs.results").out;
  EXPECT_EQ(std::count(runs.begin(), runs.end(), '\n'), (2 * 5 + 60) * 4);
  // The first table of README.
  ASSERT_EQ(run("slalom-analyze table slalom-demo/runs.results --by detour_ratio:1,1.01,1.03,4 "
                "--columns success -o success.md")
                .status,
            0);
  const std::string table = read("success.md"), begin = "| --- |";
  const std::string readme = read_text(kSourceFolder + std::string("/README.md"), "README");
  const std::string rows = table.substr(table.find(begin));
  EXPECT_EQ(readme.substr(readme.find(begin), rows.size()), rows);
  expect_failure("slalom-evaluate small.ini --demo", 2,
                 {"--demo: 'small.ini' is another campaign; expected one"});
}

TEST_F(Evaluate, FindsWhatIsShippedBehindTheLauncherOfAnArchive) {
  const std::string make =
      "mkdir -p there/bin there/lib/slalom/programs there/lib/slalom/glibc && "
      "cp '" +
      kPrograms +
      "/slalom-evaluate' there/lib/slalom/programs && "
      "cp /lib64/ld-linux-x86-64.so.2 there/lib/slalom/glibc && "
      "cp '" +
      kSourceFolder +
      "/scripts/launcher.sh' there/bin/slalom-evaluate && "
      "chmod +x there/bin/slalom-evaluate && sed -i s/@MINOR@/";
  for (const std::string newest : {"1", "1000"}) {  // as it is, and by the loader that is beside it
    ASSERT_EQ(run(make + newest + "/ there/bin/slalom-evaluate").status, 0);
    expect_failure("there/bin/slalom-evaluate --demo", 3,
                   {(folder_ / "there/share/slalom/configs/demo.ini").string()});
  }
}

TEST_F(Evaluate, UsesAllCoresUnlessTheirNumberIsGiven) {
  // The first core of the test's affinity is the only one that the program may use.
  cpu_set_t all, one;
  ASSERT_EQ(sched_getaffinity(0, sizeof(all), &all), 0);
  int first = 0;
  while (!CPU_ISSET(first, &all)) ++first;
  CPU_ZERO(&one);
  CPU_SET(first, &one);
  ASSERT_EQ(sched_setaffinity(0, sizeof(one), &one), 0);
  const std::string alone = run("slalom-evaluate small.ini -o alone").err;
  ASSERT_EQ(sched_setaffinity(0, sizeof(all), &all), 0);
  const std::string repeated = "nd, gap: repeatable in 4 of 4 runs\n";
  EXPECT_EQ(alone, "1 worker\n" + repeated);
  const std::string shown = run("slalom-evaluate small.ini -o out").err;
  EXPECT_EQ(shown,
            count_text(static_cast<std::size_t>(available_cores()), "worker") + "\n" + repeated);
  EXPECT_EQ(run("slalom-evaluate small.ini -o out").err, "all 8 runs are there\n" + repeated);
  EXPECT_EQ(run("slalom-evaluate small.ini -o zero -j 0").err, shown);
  EXPECT_EQ(run("slalom-evaluate small.ini -o three -j 3").err, repeated);
  EXPECT_EQ(run("slalom-evaluate small.ini -o quiet --quiet").err, "");
  const std::string dump = run("slalom-analyze dump out/runs.results").out;
  for (const std::string folder : {"alone", "zero", "three"})
    EXPECT_EQ(run("slalom-analyze dump " + folder + "/runs.results").out, dump) << folder;
  for (const std::string jobs : {"-1", "1025", "many"})
    expect_failure("slalom-evaluate small.ini -o none -j " + jobs, 2, {"--jobs"});
}

TEST_F(Evaluate, HasOneWorkerIfAMethodIsARunningProcess) {
  // Nothing listens there, so that each run ends at once.
  write("running.ini",
        std::string(kSmallCampaign) + "[method.running]\nadapter = lcm\nstartup_time = 0.01\n");
  const std::string command = "slalom-evaluate running.ini --set campaign.methods=";
  EXPECT_EQ(run(command + "gap,running -o out").err.find("1 worker\n"), 0U);
  EXPECT_EQ(run(command + "gap -o gap -j 0")
                .err.find(count_text(static_cast<std::size_t>(available_cores()), "worker")),
            0U);
}

TEST_F(Evaluate, ShowsTheRunsOfEachMethodOnATerminal) {
  if (std::system("command -v script >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "needs the package bsdutils";
  run("script -qec 'stty cols 120; slalom-evaluate small.ini -o out' terminal.txt");
  EXPECT_NE(read("terminal.txt").find("] 8/8 "), std::string::npos);
  EXPECT_NE(read("terminal.txt").find(", nd 4/4, gap 4/4"), std::string::npos)
      << read("terminal.txt");
}

TEST_F(Evaluate, MeasuresMoversWhereThereAreSome) {
  const std::string command =
      "slalom-evaluate small.ini --overwrite --quiet --set campaign.methods=gap "
      "--set metrics.enabled=all --set metrics.descriptors=all ";
  const auto dump_of = [&](const std::string& options) {
    const ProgramResult result = run(command + options);
    EXPECT_EQ(result.status, 0) << result.err;
    return run("slalom-analyze dump out/runs.results").out;
  };
  const std::string walkers = "-o out --set scenarios.walkers=1";
  const std::string moving = dump_of(walkers);
  EXPECT_NE(moving.find("\"personal_space_time\":{\"value\":"), std::string::npos) << moving;
  EXPECT_NE(moving.find("\"survivability\":{"), std::string::npos) << moving;
  EXPECT_EQ(run("slalom-simulate verify out/runs.results").status, 0);
  EXPECT_EQ(dump_of("-o out").find("personal_space"), std::string::npos);
  // Tables about movers have them in any case.
  const std::string named = dump_of(
      "-o out --set analysis.columns=mover_collision --set analysis.rows=crossing_flow:0,1");
  EXPECT_NE(named.find("\"mover_collision\":{\"na\":\"no moving obstacles\""), std::string::npos)
      << named;
}

TEST_F(Evaluate, TheListHasTheDescriptorsOfTheResultsAndIsSelectedByThem) {
  ASSERT_EQ(run("slalom-evaluate small.ini -o out --quiet --set robot.radius=0.2").status, 0);
  const auto values = [this] {
    return SQLite::Database((folder_ / "out/campaign.scenarios").string())
        .execAndGet("SELECT COUNT(*) FROM descriptor_values")
        .getInt();
  };
  const int stored = values();
  EXPECT_GE(stored, 4);
  const std::string ids = "--descriptors density,clearance_mean --robot-radius 0.2";
  ASSERT_EQ(run("slalom-scenarios describe out/campaign.scenarios " + ids).status, 0);
  EXPECT_EQ(values(), stored) << "they were not computed again";

  std::istringstream runs(run("slalom-analyze dump out/runs.results").out);
  std::ptrdiff_t successes = 0;
  for (std::string line; std::getline(runs, line);) {
    const auto record = nlohmann::json::parse(line);
    if (record["method"] == "nd" && record["outcome"] == "success") ++successes;
  }
  const auto selected = [this](const std::string& condition) {
    const ProgramResult result =
        run("slalom-scenarios select out/campaign.scenarios --results out/runs.results --where '" +
            condition + "'");
    EXPECT_EQ(result.status, 0) << result.err;
    return std::count(result.out.begin(), result.out.end(), '\n');
  };
  EXPECT_EQ(selected("outcome.nd = success"), successes);
  EXPECT_EQ(selected("Success.ND < 1"), 4 - successes);
  EXPECT_EQ(selected("path length.nd is not na"), 4);
  expect_failure(
      "slalom-scenarios select out/campaign.scenarios --results out/runs.results --where "
      "'sucess.nd = 1'",
      2, {"selection, character 1", "'sucess.nd'", "expected 'success.nd'"});
}

TEST_F(Evaluate, AnotherSeedGivesOtherScenarios) {
  ASSERT_EQ(run("slalom-evaluate small.ini -o one --quiet --set campaign.methods=gap").status, 0);
  ASSERT_EQ(
      run("slalom-evaluate small.ini -o two --quiet --set campaign.methods=gap --seed 6").status,
      0);
  EXPECT_NE(run("slalom-scenarios list one/campaign.scenarios").out,
            run("slalom-scenarios list two/campaign.scenarios").out);
}

TEST_F(Evaluate, AddingAMethodDoesNotChangeOtherMethods) {
  ASSERT_EQ(run("slalom-evaluate small.ini -o both --quiet").status, 0);
  ASSERT_EQ(run("slalom-evaluate small.ini -o alone --quiet --set campaign.methods=gap").status, 0);
  std::istringstream both(run("slalom-analyze dump both/runs.results").out);
  std::istringstream alone(run("slalom-analyze dump alone/runs.results").out);
  std::string line, expected;
  while (std::getline(both, line))
    if (nlohmann::json::parse(line)["method"] == "gap") expected += line + "\n";
  EXPECT_EQ(expected, alone.str());
}

TEST_F(Evaluate, DoesNotReplaceAListThatTheConfigurationNames) {
  ASSERT_EQ(run("slalom-evaluate small.ini -o out --quiet").status, 0);
  ASSERT_EQ(run("slalom-scenarios tag out/campaign.scenarios --add mine --quiet").status, 0);
  const std::string list = read("out/campaign.scenarios");
  expect_failure(
      "slalom-evaluate small.ini -o out --overwrite --set scenarios.list=./out/campaign.scenarios",
      2, {"out/campaign.scenarios", "is also an input", "scenarios.list"});
  EXPECT_EQ(read("out/campaign.scenarios"), list);
}

TEST_F(Evaluate, OmitsTrajectoriesAndReportOnRequest) {
  const std::string command = "slalom-evaluate small.ini --quiet ";
  ASSERT_EQ(run(command + "-o all").status, 0);
  const ProgramResult result =
      run(command + "-o few --set record.trajectories=none --set analysis.report=false");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "few/report"));
  EXPECT_EQ(result.out, read("few/tables.txt"));
  EXPECT_EQ(run("slalom-analyze dump few/runs.results").out,
            run("slalom-analyze dump all/runs.results").out);
  EXPECT_LT(std::filesystem::file_size(folder_ / "few/runs.results"),
            std::filesystem::file_size(folder_ / "all/runs.results"));
  EXPECT_EQ(run("slalom-analyze report few/runs.results -o report").status, 0);
}

TEST_F(Evaluate, HelpVersionAndOptionsArePrinted) {
  EXPECT_NE(run("slalom-evaluate --help").out.find("--jobs"), std::string::npos);
  EXPECT_EQ(run("slalom-evaluate --version").status, 0);
  const std::string options = run("slalom-evaluate --options").out;
  for (const char* key : {"[robot]", "max_accel_v", "[sensor]", "aperture_deg", "stuck_distance"})
    EXPECT_NE(options.find(key), std::string::npos) << key;
}

TEST_F(Evaluate, RejectsUnknownNamesAndSuggestsTheNearest) {
  const std::string base = "slalom-evaluate small.ini -o out ";
  expect_failure(base + "--set robot.raduis=1", 2,
                 {"--set robot.raduis", "unknown key", "'radius'"});
  expect_failure(base + "--set simulatoin.step=1", 2, {"simulatoin", "simulation"});
  expect_failure(base + "--set robot.radius=wide", 2, {"radius", "wide", "number"});
  expect_failure(base + "--set robot.radius=-1", 2, {"radius", "-1", "> 0"});
  expect_failure(base + "--set method.nd.class=CHolonomicNDD", 2,
                 {"class", "CHolonomicNDD", "CHolonomicND"});
  expect_failure(base + "--set method.gap.plugin=missing.so", 2, {"plugin", "missing.so"});
  expect_failure(base + "--set method.gap.adapter=libary", 2, {"adapter", "libary", "library"});
  expect_failure(base + "--set campaign.methods=nd,ghost", 2, {"ghost", "method.ghost"});
  expect_failure(base + "--set metrics.enabled=succes", 2, {"succes", "success"});
  expect_failure(base + "--set analysis.rows=densty:4", 2, {"densty", "density"});
  expect_failure(base + "--color", 2, {"--color", "--help"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/runs.results"));
}

TEST_F(Evaluate, RejectsAnOverrideWhoseValueIsASeparateWord) {
  expect_failure("slalom-evaluate small.ini --set robot.radius 0.3 -o out", 2,
                 {"--set robot.radius", "expected robot.radius=0.3"});
  expect_failure("slalom-evaluate --set robot.delay -1 -o out -c small.ini", 2,
                 {"expected robot.delay=-1"});
  for (const char* end : {"", " small.ini", " -o out"})
    expect_failure(std::string("slalom-evaluate -c small.ini --set robot.radius") + end, 2,
                   {"--set robot.radius", "expected robot.radius=VALUE"});
}

TEST_F(Evaluate, RejectsRowsWithoutBinsWithAnExample) {
  std::string campaign = kSmallCampaign;
  write("small.ini", campaign.replace(campaign.find(":0,0.05,1"), 9, ","));
  expect_failure("slalom-evaluate small.ini -o out", 2,
                 {"small.ini:21: [analysis] rows 'density,'", "density:0,0.1,0.2", "density:q4"});
}

TEST_F(Evaluate, TakesTheConfigurationAsAnArgumentOrAnOption) {
  const std::string options = " --quiet --set campaign.methods=gap -o out";
  EXPECT_EQ(run("slalom-evaluate -c small.ini" + options).status, 0);
  EXPECT_EQ(run("slalom-evaluate small.ini --config small.ini" + options).status, 0);
  write("other.ini", kSmallCampaign);
  expect_failure("slalom-evaluate small.ini -c other.ini -o none", 2, {"small.ini", "other.ini"});
  expect_failure("slalom-evaluate -o none", 2, {"campaign is required"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "none"));
}

TEST_F(Evaluate, WarnsOnceAboutAnApertureInRadians) {
  const std::string command =
      "slalom-evaluate small.ini -o out -j 1 --set campaign.methods=gap "
      "--set sensor.aperture_deg=3.14";
  const ProgramResult result = run(command);
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err,
            "warning: --set sensor.aperture_deg: 3.14 degrees looks like radians; expected 179.9 "
            "for that angle in degrees\ngap: repeatable in 4 of 4 runs\n");
  EXPECT_EQ(run(command + " --quiet").err, "");
}

TEST_F(Evaluate, RejectsALibraryThatIsNotAMethod) {
  const std::string base = "slalom-evaluate small.ini -o out --set method.gap.plugin=";
  write("text.so", "not a library");
  expect_failure(base + "text.so", 2, {"text.so"});
  write("empty.c", "int nothing;\n");
  ASSERT_EQ(run("cc -shared -fPIC empty.c -o empty.so").status, 0);
  expect_failure(base + "empty.so", 2, {"empty.so", "slalom_method_get_api"});
}

TEST_F(Evaluate, RejectsMissingAndCorruptFiles) {
  expect_failure("slalom-evaluate none.ini -o out", 3, {"none.ini"});
  const std::string base = "slalom-evaluate small.ini -o out --set scenarios.generator= ";
  expect_failure(base + "--set scenarios.maps=none.gridmap.gz", 3, {"none.gridmap.gz"});
  write("broken.gridmap.gz", "not a map");
  expect_failure(base + "--set scenarios.maps=broken.gridmap.gz", 3, {"broken.gridmap.gz"});
  write("broken.scenarios", "not a list");
  expect_failure(base + "--set scenarios.list=broken.scenarios", 3, {"broken.scenarios"});
}

TEST_F(Evaluate, RejectsAnUnwritableOutputFolder) {
  write("file", "in the way");
  expect_failure("slalom-evaluate small.ini -o file/out", 1, {"file/out", "cannot create"});
}

TEST_F(Evaluate, ReportsThatNoScenarioIsSolvable) {
  // A robot of 2.9 m radius cannot move in a workspace of 6 m x 6 m.
  expect_failure("slalom-evaluate small.ini -o out --set robot.radius=2.9", 1,
                 {"attempts", "robot"});
}

}  // namespace
}  // namespace slalom
