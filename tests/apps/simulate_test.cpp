#include "program_run.h"

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

TEST_F(Simulate, RejectsInvalidListsAndVerbs) {
  expect_failure("slalom-simulate run -c small.ini --scenarios small.ini -o runs.results", 3,
                 {"small.ini"});
  expect_failure("slalom-simulate fly", 2, {"unknown verb 'fly'", "run"});
}

TEST_F(Simulate, TakesTheConfigurationAsAnArgumentOrAnOption) {
  EXPECT_EQ(run("slalom-simulate run small.ini --quiet -o a.results").status, 0);
  EXPECT_EQ(run("slalom-simulate run -c small.ini --quiet -o b.results").status, 0);
  EXPECT_EQ(run("slalom-analyze dump a.results").out, run("slalom-analyze dump b.results").out);
  expect_failure("slalom-simulate run small.ini -c other.ini -o c.results", 2,
                 {"small.ini", "other.ini"});
  expect_failure("slalom-simulate run -o c.results", 2, {"config is required"});
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
