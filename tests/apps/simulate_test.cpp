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

TEST_F(Simulate, RunsMethodsOverAListAsTheWholeJobDoes) {
  ASSERT_EQ(run("slalom-evaluate small.ini -o out --quiet").status, 0);
  const Ended ended = run(
      "slalom-simulate run -c small.ini --scenarios out/campaign.scenarios -o runs.results -j 2");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(run("slalom-analyze dump runs.results").out,
            run("slalom-analyze dump out/runs.results").out);
}

TEST_F(Simulate, RefusesListsThatAreNone) {
  expect_refusal("slalom-simulate run -c small.ini --scenarios small.ini -o runs.results", 3,
                 {"small.ini"});
  expect_refusal("slalom-simulate fly", 2, {"unknown verb 'fly'", "run"});
}

TEST_F(Simulate, AnExceptionOfMrptIsToldByItsReasonAlone) {
  write("weights.ini", "[FULL_EVAL_CONFIG]\nfactorWeights = 0.1 0.5\n");  // not MRPT's section
  const std::string command =
      "slalom-simulate run -c small.ini -o runs.results --set campaign.methods=nd --set "
      "method.nd.class=CHolonomicFullEval --set method.nd.config=weights.ini";
  expect_refusal(command, 2, {"config", "factorWeights", "CHolonomicFullEval"});
  EXPECT_EQ(run(command).err.find("0x"), std::string::npos) << "no addresses of a call stack";
}

}  // namespace
}  // namespace slalom
