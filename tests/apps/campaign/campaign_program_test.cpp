#include <slalom/analysis/cell.h>
#include <slalom/app/campaign_program.h>
#include <slalom/core/error.h>
#include <slalom/io/result_file.h>
#include <slalom/io/scenario_list.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <unistd.h>
#include <vector>

namespace slalom {
namespace {

const std::string kIni =
    "[campaign]\nmethods = nd\n[scenarios]\ngenerator = random\ncount = 1\n"
    "[method.nd]\nadapter = mrpt_holonomic\nclass = CHolonomicND\n"
    "[simulation]\nmax_time = 2\n";

class CampaignProgram : public ::testing::Test {
 protected:
  CampaignProgram() { std::filesystem::create_directories(folder_); }
  ~CampaignProgram() override { std::filesystem::remove_all(folder_); }

  CampaignArguments arguments(const std::vector<std::string>& overrides = {}) const {
    const std::string config = folder_ + "/campaign.ini";
    write_file_atomically(config, kIni);
    CampaignArguments arguments;
    arguments.config = config;
    arguments.overrides = overrides;
    arguments.quiet = true;
    return arguments;
  }

  /// What making the scenarios says against the .ini; "" when nothing.
  std::string complaint(const std::string& override_key) const {
    // Ten million scenarios take hours: only a check before them answers in time.
    const auto wrong = arguments({override_key, "scenarios.count=10000000"});
    try {
      campaign_scenarios(load_campaign_ini(wrong), wrong);
    } catch (const Error& error) {
      EXPECT_EQ(error.exit_status(), 2);
      return error.what();
    }
    return "";
  }

  const std::string folder_ = (std::filesystem::temp_directory_path() /
                               ("slalom_campaign_program_" + std::to_string(getpid())))
                                  .string();
};

TEST_F(CampaignProgram, RefusesRowsOfAnUnknownDescriptorBeforeScenariosAreMade) {
  EXPECT_EQ(complaint("analysis.rows=densty:2"),
            "--set analysis.rows: 'densty' is not computed by this campaign; expected 'density'");
}

TEST_F(CampaignProgram, RefusesADescriptorAsAColumnBeforeScenariosAreMade) {
  EXPECT_EQ(complaint("analysis.columns=success,density")
                .find("--set analysis.columns: 'density' is not computed by this campaign; "
                      "expected one of success, optimality"),
            0U);
}

TEST_F(CampaignProgram, TakesWallClockFiguresAsColumns) {
  const auto asked = arguments({"analysis.columns=success,cycle_time_p95"});
  EXPECT_EQ(campaign_scenarios(load_campaign_ini(asked), asked).size(), 1U);
}

TEST_F(CampaignProgram, MakesTheSameScenariosWithAnyNumberOfJobs) {
  // Mazes are built and certified with uneven effort, so threads finish them out of order.
  auto asked = arguments({"scenarios.generator=random,maze", "scenarios.count=20"});
  const auto contents = [&asked](int jobs) {
    asked.jobs = jobs;
    std::vector<std::string> bytes;
    for (const Scenario& scenario : campaign_scenarios(load_campaign_ini(asked), asked))
      bytes.push_back(scenario.name() + serialize(scenario));
    return bytes;
  };
  const std::vector<std::string> alone = contents(1);
  EXPECT_EQ(alone.size(), 20U);
  EXPECT_TRUE(alone == contents(2));
  EXPECT_TRUE(alone == contents(5));
}

TEST_F(CampaignProgram, RefusesAnMrptConfigurationWithoutTheClassBeforeAnyRun) {
  const std::string nd_ini = folder_ + "/nd.ini", path = folder_ + "/runs.results";
  write_file_atomically(nd_ini, "[Other]\nkey = 1\n");
  const auto wrong = arguments({"method.nd.config=" + nd_ini});
  const IniFile ini = load_campaign_ini(wrong);
  try {
    run_campaign_program(ini, wrong, campaign_scenarios(ini, wrong), path);
    FAIL() << "taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_status(), 2);
    EXPECT_EQ(std::string(error.what()).find("--set method.nd.config: CHolonomicND refuses it ("),
              0U);
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

// Programs link all rooms. Two rooms that gave one name to two types would share the code of their
// vectors, and this file's, with the cells of tables, would come first.
TEST_F(CampaignProgram, FindsReferencesAndRunsMethodsWithAllRoomsLinked) {
  std::vector<Cell> cells_of_a_table;
  for (std::size_t n = 0; n < 3; ++n) cells_of_a_table.emplace_back().n = n;
  ASSERT_EQ(cells_of_a_table.back().n, 2U);
  const auto plain = arguments();
  const IniFile ini = load_campaign_ini(plain);
  auto scenarios = campaign_scenarios(ini, plain);
  const std::string hash = scenarios.front().hash(), path = folder_ + "/runs.results";
  const CampaignReport report = run_campaign_program(ini, plain, std::move(scenarios), path);
  EXPECT_TRUE(report.complete);
  EXPECT_EQ(report.problem, "");
  const ResultFile file = ResultFile::open(path);
  const References references = file.read_references(hash);
  ASSERT_TRUE(references.shortest && references.safest);
  EXPECT_GE(length(references.safest->path), references.shortest->certificate.lower_bound);
  ASSERT_EQ(file.read_table().runs.size(), 1U);
}

}  // namespace
}  // namespace slalom
