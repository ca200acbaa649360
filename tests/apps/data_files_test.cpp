// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"
#include "program_run.h"

#include <slalom/core/text.h>
#include <slalom/io/result_file.h>

namespace slalom {
namespace {

/// A result file and a recorded run of a stranger, whose .ini names code.
class DataFiles : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("small.ini", std::string(kSmallCampaign) + "[record]\nrawlog = all\n");
    const ProgramResult result = run("slalom-simulate run -c small.ini -o runs.results --quiet");
    ASSERT_EQ(result.status, 0) << result.err;
  }

  /// Writes hostile.results: what runs.results contains, with other lines in a section of its .ini.
  void forge(const std::string& section, const std::string& lines) const {
    const ResultFile real = ResultFile::open((folder_ / "runs.results").string());
    Manifest manifest = real.read_manifest();
    std::string ini;
    bool skip = false;
    for (const std::string& line : split(manifest["campaign.ini"], '\n')) {
      if (!line.empty() && line[0] == '[') skip = line == "[" + section + "]";
      if (!skip) ini += line + "\n";
    }
    manifest["campaign.ini"] = ini + "[" + section + "]\n" + lines;
    const ResultFile forged = ResultFile::create((folder_ / "hostile.results").string(), manifest,
                                                 real.descriptors(), real.metrics());
    ResultFile file = ResultFile::open(forged.path());
    real.for_each_run([&](const RunRecord& run) {
      if (!file.has_scenario(run.scenario_hash))
        file.add_scenario(real.read_record(run.scenario_hash),
                          real.read_scenario(run.scenario_hash),
                          real.read_references(run.scenario_hash));
      file.add_run(run, real.read_timing(run), real.read_trajectory(run));
      run_ = run_id(run);
    });
    file.commit();
  }

  void expect_nothing_executed() const {
    EXPECT_FALSE(std::filesystem::exists(folder_ / "EXECUTED"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "written"));
  }

  mutable std::string run_;
};

TEST_F(DataFiles, NoProgramExecutesWhatAResultFileNames) {
  write("evil.py", "open('EXECUTED', 'w')\n");
  for (const char* lines :
       {"adapter = lcm\nlaunch = touch EXECUTED\n",
        "adapter = python\nmodule = evil.py\nclass = A\n",
        "adapter = library\nplugin = ./evil.so\n", "adapter = onnx\nmodel = evil.py\n",
        "adapter = lcm\nurl = file://written?mode=w\n",
        "adapter = mrpt_navigator\nconfig = evil.py\nptg_cache = written\n"}) {
    write("evil.so", "no library");
    forge("method.nd", lines);
    for (const std::string& command :
         {std::string("slalom-simulate verify hostile.results --quiet"),
          "slalom-falsify shrink hostile.results --run " + run_ + " -o out"})
      expect_failure(command, 2, {"hostile.results", "would execute", "method.nd: ", "--trust"});
    for (const char* command :
         {"slalom-analyze table hostile.results", "slalom-analyze report hostile.results -o page",
          "slalom-analyze dump hostile.results",
          "slalom-simulate merge -o all.results hostile.results"})
      run(command);
    expect_nothing_executed();
  }
}

TEST_F(DataFiles, ALibraryBesideTheResultsIsNotTakenForAShippedOne) {
  for (const auto& file : std::filesystem::directory_iterator(kMethods)) {
    const std::string name = file.path().filename().string();
    if (file.path().extension() != ".so") continue;
    write(name, "no library");
    forge("method.nd", "adapter = library\nplugin = " + name + "\n");
    expect_failure("slalom-simulate verify hostile.results --quiet", 2,
                   {"would execute", "plugin = " + name});
    std::filesystem::remove(folder_ / name);
  }
}

TEST_F(DataFiles, WithTrustTheyAreExecuted) {
  forge("method.nd", "adapter = lcm\nlaunch = touch EXECUTED\nstartup_time = 0.2\n");
  EXPECT_NE(run("slalom-simulate verify hostile.results --quiet --trust").status, 0);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "EXECUTED"));
}

TEST_F(DataFiles, MethodsOfTheUsersOwnCampaignAreExecuted) {
  forge("method.nd", "adapter = lcm\nlaunch = touch EXECUTED\n");
  EXPECT_EQ(run("slalom-simulate verify hostile.results --quiet -c small.ini").status, 0);
  expect_nothing_executed();
}

TEST_F(DataFiles, ShippedMethodsAreVerifiedWithoutAQuestion) {
  EXPECT_EQ(run("slalom-simulate verify runs.results --quiet").status, 0);
}

TEST_F(DataFiles, ARecordedRunExecutesNothingThatItNames) {
  write("evil.py",
        "open('EXECUTED', 'w')\n"
        "class A:\n"
        "  def __init__(self, robot, sensor): pass\n"
        "  def reset(self, task): pass\n"
        "  def step(self, observation): return 0, 0\n");
  write("evil.ini", std::string(kSmallCampaign) +
                        "[method.evil]\nadapter = python\nmodule = evil.py\nclass = A\n");
  ASSERT_EQ(run("slalom-simulate run -c evil.ini -o evil.results --quiet --set record.rawlog=all "
                "--set campaign.methods=evil")
                .status,
            0);
  std::filesystem::remove(folder_ / "EXECUTED");
  std::string log;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "evil.rawlogs"))
    log = "evil.rawlogs/" + entry.path().filename().string();
  expect_failure("slalom-replay check " + log, 2, {log, "would execute", "module = evil.py"});
  expect_failure("slalom-falsify shrink " + log + " -o out", 2, {"would execute"});
  for (const char* verb : {"metrics ", "play --png frames "}) run("slalom-replay " + (verb + log));
  expect_nothing_executed();
  // Paths are those of the campaign, relative to the current folder.
  EXPECT_EQ(run("slalom-replay check " + log + " --trust").status, 0);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "EXECUTED"));
}

}  // namespace
}  // namespace slalom
