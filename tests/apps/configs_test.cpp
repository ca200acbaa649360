// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"
#include "private_network.h"
#include "program_run.h"

namespace slalom {
namespace {

class Configs : public ProgramTest {
 protected:
  /// The .ini files in configs/ for list generation, or those for campaigns, without the claims of
  /// scripts/claims.py.
  static std::vector<std::filesystem::path> examples(bool generate) {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kConfigs)) {
      if (entry.path().extension() != ".ini" || entry.path().parent_path().filename() == "claims")
        continue;
      const bool campaign = read_text(entry.path()).find("[campaign]") != std::string::npos;
      if (campaign != generate) paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    return paths;
  }

  /// Options to share the collision grids of the navigators between campaigns: computing them takes
  /// longer than all runs.
  static std::string shared_grids(const std::string& text) {
    std::string options;
    for (const std::string method : {"reactive", "reactive_tuned"})
      if (text.find("[method." + method + "]") != std::string::npos)
        options += " --set method." + method + ".ptg_cache=grids";
    return options;
  }
};

/// A node in place of Nav2, which is not in the distribution; it answers at once and seeks no goal.
std::string node_of_the_test(const std::string& text) {
  return text.find("adapter      = ros2") == std::string::npos
             ? ""
             : " --set method.nav2.mode=lockstep --set 'method.nav2.launch=exec " + kCyclonePeer +
                   "'";
}

TEST_F(Configs, EveryCampaignExampleRuns) {
  enter_private_network();
  for (const auto& path : examples(false)) {
    const ProgramResult result =
        run("slalom-evaluate '" + path.string() +
            "' -o out --overwrite -j 1 --quiet --set scenarios.count=2 --set "
            "scenarios.maps= --set campaign.repetitions=1" +
            shared_grids(read_text(path)) + node_of_the_test(read_text(path)));
    EXPECT_EQ(result.status, 0) << path << "\n" << result.err;
    const std::string dump = run("slalom-analyze dump out/runs.results").out;
    const bool seeks_goals = node_of_the_test(read_text(path)).empty();
    const char* const outcome = seeks_goals ? "\"outcome\":\"success\"" : "\"outcome\":";
    EXPECT_NE(dump.find(outcome), std::string::npos) << path;
    EXPECT_EQ(dump.find("\"method_"), std::string::npos) << path << " has a method that fails";
  }
}

TEST_F(Configs, EveryGenerationExampleRuns) {
  for (const auto& path : examples(true)) {
    const bool fills_bins = read_text(path).find("[coverage]") != std::string::npos;
    const ProgramResult result =
        run("slalom-scenarios generate -c '" + path.string() +
            "' -n 2 -o a.scenarios --overwrite --quiet" +
            (fills_bins ? " -j 2 --set coverage.budget_evaluations=60" : ""));
    EXPECT_EQ(result.status, 0) << path << "\n" << result.err;
  }
}

}  // namespace
}  // namespace slalom
