// SPDX-License-Identifier: BSD-3-Clause
#include "program_run.h"

namespace slalom {
namespace {

/// Campaigns that are continued after something has changed.
class ChangedCampaign : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("small.ini", kSmallCampaign);
  }

  void expect_run(const std::string& arguments) const {
    const ProgramResult result = run("slalom-simulate run -c " + arguments);
    EXPECT_EQ(result.status, 0) << arguments << "\n" << result.err;
  }

  std::string dump(const std::string& results) const {
    return run("slalom-analyze dump " + results).out;
  }

  /// A Python method that drives at the speed that a module beside it names.
  void write_python(const std::string& speed) const {
    write("helper.py", "SPEED = " + speed + "\n");
    write("mine.py",
          "class Mine:\n"
          "  def __init__(self, robot, sensor): pass\n"
          "  def reset(self, task): pass\n"
          "  def step(self, observation):\n"
          "    from helper import SPEED\n"
          "    return SPEED, 0.0\n");
    write("python.ini", std::string(kSmallCampaign) +
                            "[method.mine]\nadapter = python\nmodule = mine.py\nclass = Mine\n");
  }
};

TEST_F(ChangedCampaign, ExtendedItIsTheOneMadeAtOnce) {
  const std::string set = "small.ini -o steps.results --set campaign.methods=";
  expect_run(set + "gap --set scenarios.count=2");
  const std::string first = dump("steps.results");
  const ProgramResult longer = run("slalom-simulate run -c " + set + "gap --set scenarios.count=4");
  EXPECT_EQ(longer.status, 0) << longer.err;
  EXPECT_NE(longer.err.find("continues: 2 of 4 runs are there"), std::string::npos) << longer.err;
  expect_run(set + "gap,nd --set scenarios.count=4");
  expect_run(set + "gap,nd --set scenarios.count=4 --set campaign.repetitions=2");
  expect_run("small.ini -o whole.results --set scenarios.count=4 --set campaign.repetitions=2");
  EXPECT_EQ(dump("steps.results"), dump("whole.results"));
  std::istringstream lines(first);
  for (std::string line; std::getline(lines, line);)
    EXPECT_NE(dump("steps.results").find(line), std::string::npos) << line;
  const ProgramResult table = run("slalom-analyze table steps.results");
  EXPECT_EQ(table.err, run("slalom-analyze table whole.results").err);
}

TEST_F(ChangedCampaign, TheFolderOfAnExtendedOneIsExtended) {
  const std::string command = "slalom-evaluate small.ini -o out --quiet --set scenarios.count=";
  ASSERT_EQ(run(command + "2").status, 0);
  ASSERT_EQ(
      run("slalom-scenarios tag out/campaign.scenarios --where 'density < 1' --add kept").status,
      0);
  ASSERT_EQ(run(command + "3").status, 0);
  const std::string tagged =
      run("slalom-scenarios select out/campaign.scenarios --where 'tag = kept' --json").out;
  EXPECT_EQ(std::count(tagged.begin(), tagged.end(), '\n'), 2) << tagged;
  const std::string all = run("slalom-scenarios select out/campaign.scenarios --json").out;
  EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 3) << all;
}

TEST_F(ChangedCampaign, ItIsNotExtendedByWhatChangesItsRuns) {
  expect_run("small.ini -o runs.results --quiet");
  const std::string before = dump("runs.results");
  const std::string command = "slalom-simulate run -c small.ini -o runs.results ";
  expect_failure(command + "--set scenarios.count=1", 3, {"is none of those here"});
  expect_failure(command + "--set campaign.methods=nd", 3, {"campaign.methods is nd here"});
  expect_failure(command + "--set campaign.repetitions=2 --set robot.max_v=0.3", 3,
                 {"robot.max_v is 0.3 here"});
  expect_failure(command + "--seed 6 --set scenarios.count=9", 3, {"campaign.seed is 6 here"});
  expect_failure(command + "--shard 1/2 --set campaign.repetitions=2", 3, {"contains no shard"});
  EXPECT_EQ(dump("runs.results"), before);
  EXPECT_NE(run(command).err.find("runs are there"), std::string::npos);
}

TEST_F(ChangedCampaign, OneWithAStoppingRuleIsNotExtended) {
  const std::string command =
      "slalom-evaluate small.ini -o out --quiet --until 'interval(success) < 0.9' ";
  ASSERT_EQ(run(command).status, 0);
  expect_failure(command + "--set scenarios.count=99", 3, {"--until, which cannot be extended"});
}

TEST_F(ChangedCampaign, AnImportedModuleThatChangedIsNoticed) {
  write_python("0.1");
  const std::string command =
      "slalom-simulate run -c python.ini --set campaign.methods=mine,nd -o runs.results ";
  ASSERT_EQ(run(command + "--set scenarios.count=2").status, 0);
  const std::string before = dump("runs.results");
  write_python("0.2");
  expect_failure(command + "--set scenarios.count=3", 3,
                 {"module/helper.py of method.mine is not the one of runs.results", "--overwrite",
                  "--keep-finished"});
  EXPECT_EQ(dump("runs.results"), before);
  const ProgramResult verified = run("slalom-simulate verify runs.results --trust");
  EXPECT_EQ(verified.status, 1);
  EXPECT_NE(verified.out.find("environment: module/helper.py of method.mine"), std::string::npos)
      << verified.out;

  ASSERT_EQ(run(command + "--set scenarios.count=3 --keep-finished").status, 0);
  std::istringstream lines(before);
  for (std::string line; std::getline(lines, line);)
    EXPECT_NE(dump("runs.results").find(line), std::string::npos) << line;
  for (const char* verb : {"table", "compare", "summary"}) {
    const std::string notes = run(std::string("slalom-analyze ") + verb + " runs.results").err;
    EXPECT_NE(notes.find("runs of several versions are mixed: module/helper.py of method.mine was "
                         "replaced"),
              std::string::npos)
        << verb << notes;
    EXPECT_NE(notes.find(" until 2 runs)"), std::string::npos) << verb << notes;
  }
  // The second version is now the known one.
  EXPECT_EQ(run(command + "--set scenarios.count=3").status, 0);
  write_python("0.3");
  expect_failure(command + "--set scenarios.count=3", 3, {"--keep-finished"});
}

}  // namespace
}  // namespace slalom
