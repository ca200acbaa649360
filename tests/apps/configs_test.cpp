#include "program_run.h"

namespace slalom {
namespace {

class Configs : public ProgramTest {
 protected:
  /// The .ini files of configs/ and of its folders that generate lists, or those of campaigns.
  static std::vector<std::filesystem::path> examples(bool generate) {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(SLALOM_CONFIGS)) {
      if (entry.path().extension() != ".ini") continue;
      const bool campaign = read_text(entry.path()).find("[campaign]") != std::string::npos;
      if (campaign != generate) paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    return paths;
  }
};

// One worker: each builds the tables of the navigators anew, which takes longer than the runs.
TEST_F(Configs, EveryExampleOfACampaignRuns) {
  for (const auto& path : examples(false)) {
    const Ended ended = run("slalom-evaluate '" + path.string() +
                            "' -o out -j 1 --quiet --set scenarios.count=2 --set "
                            "scenarios.maps= --set campaign.repetitions=1");
    EXPECT_EQ(ended.status, 0) << path << "\n" << ended.err;
    const std::string dump = run("slalom-analyze dump out/runs.results").out;
    EXPECT_NE(dump.find("\"outcome\":\"success\""), std::string::npos) << path;
    EXPECT_EQ(dump.find("\"method_"), std::string::npos) << path << " has a method that fails";
  }
}

TEST_F(Configs, EveryExampleOfGenerationGenerates) {
  for (const auto& path : examples(true)) {
    const bool fills_bins = read_text(path).find("[coverage]") != std::string::npos;
    const Ended ended =
        run("slalom-scenarios generate -c '" + path.string() + "' -n 2 -o a.scenarios --quiet" +
            (fills_bins ? " -j 2 --set coverage.budget_evaluations=60" : ""));
    EXPECT_EQ(ended.status, 0) << path << "\n" << ended.err;
  }
}

}  // namespace
}  // namespace slalom
