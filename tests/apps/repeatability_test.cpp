// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"
#include "private_network.h"
#include "program_run.h"

#include <slalom/core/text.h>
#include <slalom/io/result_file.h>
#include <slalom/results/repeatability.h>

#include <nlohmann/json.hpp>

namespace slalom {
namespace {

using Json = nlohmann::json;

/// A campaign of a method that commands 0.125 m/s times the number of runs of its process, in four
/// scenarios: with one worker 0.125, 0.25, 0.375 and 0.5 m/s. A second execution of a run is alone
/// in its process and commands 0.125 m/s, so that one of four is the same.
class Repeatability : public ProgramTest {
 protected:
  static void SetUpTestSuite() { enter_private_network(); }
  void SetUp() override {
    ProgramTest::SetUp();
    std::string text = kSmallCampaign;
    text.replace(text.find("nd, gap"), 7, "mine");
    text += "[method.mine]\nadapter = library\nplugin = " + kBuild +
            "/tests/apps/plugins/libcounting_method.so\n";
    write("mine.ini", text);
    write("small.ini", kSmallCampaign);
  }
  /// The run that a line names: "mine: repeatable in 1 of 4 runs; 0123abcd/mine/0 differs ...".
  static std::string run_of(const std::string& line) {
    const std::size_t begin = line.find("; ") + 2;
    return line.substr(begin, line.find(" differs") - begin);
  }
  static bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }
};

TEST_F(Repeatability, OfMethodsThatKeepNothingBetweenRunsIsComplete) {
  const ProgramResult first = run("slalom-evaluate small.ini -o out -j 2");
  EXPECT_TRUE(has(first.err, "nd, gap: repeatable in 4 of 4 runs\n")) << first.err;
  EXPECT_FALSE(has(first.out, "repeatable"));
  EXPECT_EQ(run("slalom-evaluate small.ini -o quiet --quiet").err, "");
  const Json report = Json::parse(read("out/report/report.json"));
  for (const char* method : {"nd", "gap"})
    EXPECT_EQ(report["repeatability"][method],
              (Json{{"repeated", 4}, {"equal", 4}, {"difference", ""}}));
  EXPECT_FALSE(has(run("slalom-analyze table out/runs.results").out, "repeatable"));
}

TEST_F(Repeatability, IsMeasuredForEveryAdapter) {
  if (!has_multicast()) GTEST_SKIP() << "neither a private network nor one with multicast";
  std::string text = kSmallCampaign;
  text.replace(text.find("nd, gap"), 7, "nd, gap, far, node, python, network");
  const std::string limits = "deadline = 100\nstartup_time = 100\n";  // of slow machines
  text += "[method.far]\nadapter = lcm\n" + limits +
          "launch = exec slalom-lcm-method --plugin libslalom_follow_the_gap.so\n"
          "[method.node]\nadapter = ros2\nlaunch = exec " +
          kCyclonePeer + "\n" + limits +
          "[method.python]\nadapter = python\nclass = MyMethod\n"
          "module = " +
          kSource +
          "/examples/python_method/my_method.py\n"
          "[method.network]\nadapter = onnx\nscan_size = 61\n"
          "model = " +
          kSource + "/examples/onnx_policy/policy.onnx\n";
  write("small.ini", text);
  const ProgramResult result = run("slalom-evaluate small.ini -o out -j 2");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(has(result.err, "nd, gap, far, node, python, network: repeatable in 4 of 4 runs\n"))
      << result.err;
}

TEST_F(Repeatability, NamesTheFirstValueThatDiffers) {
  const ProgramResult result = run("slalom-evaluate mine.ini -o out -j 1 --quiet");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(has(result.err, "mine: repeatable in 1 of 4 runs; ")) << result.err;
  EXPECT_TRUE(has(result.err, "/mine/0 differs after 0.00 s: command v 0.")) << result.err;
  EXPECT_TRUE(has(result.err, " and 0.125 m/s\n")) << result.err;
  const std::string sentence =
      result.err.substr(0, result.err.find('\n')) + "; its values, and their differences";
  EXPECT_TRUE(has(result.out, sentence)) << result.out;
  EXPECT_TRUE(has(read("out/tables.txt"), sentence));
  EXPECT_TRUE(has(read("out/report/index.html"), sentence));
  const Json report = Json::parse(read("out/report/report.json"));
  EXPECT_EQ(report["repeatability"]["mine"]["equal"], 1);
  EXPECT_EQ(report["repeatability"]["mine"]["repeated"], 4);
  EXPECT_TRUE(has(report["notes"].dump(), sentence)) << report["notes"];
  EXPECT_TRUE(has(run("slalom-analyze show out/runs.results --run " + run_of(result.err)).out,
                  "repeatable in 1 of 4 runs; "));
  const std::string repetitions = ", which [campaign] repetitions would show\n";
  for (const char* command : {"table out/runs.results", "compare out/runs.results out/runs.results",
                              "compare out/runs.results out/runs.results --gate 'success >= 0'"})
    EXPECT_TRUE(has(run(std::string("slalom-analyze ") + command).out, repetitions)) << command;
}

TEST_F(Repeatability, WithoutTrajectoriesAValueOfTheRunIsNamed) {
  const ProgramResult result =
      run("slalom-evaluate mine.ini -o out -j 1 --quiet --set record.trajectories=none");
  EXPECT_TRUE(has(result.err, "/mine/0 differs: /")) << result.err;
}

TEST_F(Repeatability, IsMeasuredOnceAndKeptByExtensionsAndMerges) {
  const std::string evaluate = "slalom-evaluate mine.ini -o out -j 1 --quiet --set ";
  EXPECT_EQ(run(evaluate + "record.repeated_runs=0").err, "");
  const std::string dump = run("slalom-analyze dump out/runs.results").out;
  const std::string two = run(evaluate + "record.repeated_runs=2").err;
  EXPECT_TRUE(has(two, " of 2 runs; ")) << two;
  const std::string manifest = run("slalom-analyze export manifest out/runs.results").out;
  EXPECT_EQ(run(evaluate + "record.repeated_runs=2").err, two);
  EXPECT_EQ(run("slalom-analyze export manifest out/runs.results").out, manifest);
  EXPECT_TRUE(has(run(evaluate + "record.repeated_runs=5").err, " 1 of 4 runs; "));
  EXPECT_EQ(run("slalom-analyze dump out/runs.results").out, dump);
  EXPECT_TRUE(has(run(evaluate + "scenarios.count=6").err, " of 5 runs; "));
  ASSERT_EQ(run("slalom-simulate merge out/runs.results -o all.results").status, 0);
  EXPECT_TRUE(has(run("slalom-analyze table all.results").out, " of 5 runs; "));
}

TEST_F(Repeatability, IsNotMeasuredAcrossVersionsOfAMethod) {
  std::filesystem::copy_file(kFollowTheGap, folder_ / "gap.so");
  const std::string evaluate = "slalom-evaluate small.ini -o out --set method.gap.plugin=./gap.so ";
  EXPECT_TRUE(has(run(evaluate).err, "nd, gap: repeatable in 4 of 4 runs\n"));
  std::filesystem::copy_file(kMethods + "/libslalom_go_to_goal.so", folder_ / "gap.so",
                             std::filesystem::copy_options::overwrite_existing);
  const ProgramResult mixed = run(evaluate + "--keep-finished");
  EXPECT_EQ(mixed.status, 0) << mixed.err;
  EXPECT_TRUE(has(mixed.err, "\nnd: repeatable in 4 of 4 runs\n")) << mixed.err;
}

TEST_F(Repeatability, VerifyDoesNotAccuseAMethodThatIsNotRepeatable) {
  for (const char* measured : {"5", "0"}) {
    const std::string set = std::string(" --set record.repeated_runs=") + measured;
    ASSERT_EQ(run("slalom-evaluate mine.ini -o out -j 1 --quiet --overwrite" + set).status, 0);
    const ProgramResult result =
        run("slalom-simulate verify out/runs.results --trust --fraction 1 --quiet");
    EXPECT_EQ(result.status, 0) << result.out << result.err;
    EXPECT_TRUE(has(result.out,
                    "/mine/0: not repeatable: mine, executed once more here, differs after 0.00 s: "
                    "command v 0."))
        << result.out;
    EXPECT_TRUE(has(result.out, " in 4 of 4 scenarios ")) << result.out;
    EXPECT_TRUE(has(result.out, " cannot be verified\n")) << result.out;
  }
}

TEST_F(Repeatability, TheBadgeOfAVerificationCountsTheIdenticalRunsOnly) {
  ASSERT_EQ(
      run("slalom-evaluate mine.ini -o out -j 1 --quiet --set campaign.methods=mine,nd").status, 0);
  const ProgramResult result =
      run("slalom-simulate verify out/runs.results --trust --fraction 1 --quiet --badge");
  ASSERT_EQ(result.status, 0) << result.out << result.err;
  ASSERT_TRUE(has(result.out, " cannot be verified\n")) << result.out;
  const std::string sentence = last_line(result.out);
  EXPECT_EQ(Json::parse(read("out/runs.results.verified.json"))["message"],
            sentence.substr(0, sentence.find(' ')) + " of 8 runs verified");
}

TEST_F(Repeatability, VerifySaysThatAMethodRepeatsItselfWhereTheResultsDiffer) {
  std::filesystem::copy_file(kFollowTheGap, folder_ / "gap.so");
  ASSERT_EQ(run("slalom-evaluate small.ini -o out --quiet --set method.gap.plugin=./gap.so").status,
            0);
  std::filesystem::copy_file(kMethods + "/libslalom_go_to_goal.so", folder_ / "gap.so",
                             std::filesystem::copy_options::overwrite_existing);
  const ProgramResult result =
      run("slalom-simulate verify out/runs.results --trust --fraction 1 --quiet");
  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(has(result.out, "; gap, executed once more here, repeats itself\n")) << result.out;
  EXPECT_FALSE(has(result.out, "not repeatable"));

  // A file cannot excuse its results.
  {
    ResultFile file = ResultFile::open((folder_ / "out/runs.results").string());
    Manifest manifest = file.read_manifest();
    for (auto& [key, text] : manifest)
      if (starts_with(key, kRepeatedPrefix)) text = "differs";
    file.replace_manifest(manifest);
    ASSERT_TRUE(file.commit());
  }
  const ProgramResult forged =
      run("slalom-simulate verify out/runs.results --trust --fraction 1 --quiet");
  EXPECT_EQ(forged.status, 1);
  EXPECT_TRUE(has(forged.out, "repeats itself, though the file says that it does not\n"))
      << forged.out;
}

}  // namespace
}  // namespace slalom
