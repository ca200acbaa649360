// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "places.h"

#include <slalom/analysis/cell.h>
#include <slalom/app/campaign_program.h>
#include <slalom/app/testbeds.h>
#include <slalom/app/verify_results.h>
#include <slalom/core/error.h>
#include <slalom/core/read_file.h>
#include <slalom/io/own_columns.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_file.h>
#include <slalom/io/scenario_list.h>
#include <slalom/results/privileged.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
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

  static std::vector<Scenario> scenarios_of(const CampaignArguments& arguments) {
    CampaignConfig config = read_campaign(load_campaign_ini(arguments));
    return campaign_scenarios(config, arguments);
  }

  static void execute(const CampaignArguments& arguments, const std::string& path) {
    CampaignConfig config = read_campaign(load_campaign_ini(arguments));
    auto scenarios = campaign_scenarios(config, arguments);
    ResultFile results = open_campaign_results(config, arguments, scenarios, path);
    run_campaign_program(config, arguments, std::move(scenarios), std::move(results));
  }

  /// Calls campaign_scenarios() with this override and so many scenarios that generating them would
  /// take hours: only a preceding check is fast enough.
  void request_scenarios(const std::string& override_key) const {
    const auto wrong = arguments({override_key, "scenarios.count=10000000"});
    scenarios_of(wrong);
  }

  /// Reads a campaign of a library with these keys.
  void read_library(const std::string& keys) const {
    auto of_library = arguments();
    write_file_atomically(of_library.config,
                          "[campaign]\nmethods = a\n[scenarios]\ngenerator = random\ncount = 1\n"
                          "[simulation]\ngoal_tolerance = 0.05\n[method.a]\nadapter = library\n"
                          "plugin = missing.so\n" +
                              keys);
    read_campaign(load_campaign_ini(of_library));
  }

  const std::string folder_ = (std::filesystem::temp_directory_path() /
                               ("slalom_campaign_program_" + std::to_string(getpid())))
                                  .string();
};

TEST_F(CampaignProgram, RefusesAMethodThatStopsOutsideTheToleranceOfTheGoal) {
  EXPECT_TRUE(
      throws_error(ErrorKind::Usage, folder_ + "/campaign.ini:11: [method.a]",
                   {"xy_goal_tolerance", "0.1 is larger than [simulation] goal_tolerance 0.05"},
                   [&] { read_library("xy_goal_tolerance = 0.1\n"); }));
}

TEST_F(CampaignProgram, RejectsRowsOfAnUnknownDescriptorBeforeGeneration) {
  EXPECT_TRUE(throws_error(ErrorKind::Usage,
                           "--set analysis.rows: ", {"'densty'", "expected 'density'"},
                           [this] { request_scenarios("analysis.rows=densty:2"); }));
}

TEST_F(CampaignProgram, RejectsADescriptorAsAColumnBeforeGeneration) {
  EXPECT_TRUE(throws_error(ErrorKind::Usage,
                           "--set analysis.focus: ", {"'dn'", "expected one of nd"},
                           [this] { request_scenarios("analysis.focus=dn"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "--set analysis.columns: ",
                           {"'density'", "expected one of success, optimality"},
                           [this] { request_scenarios("analysis.columns=success,density"); }));
}

TEST_F(CampaignProgram, RefusesMethodsOverLcmWithoutNetwork) {
  const auto read = [this](const std::string& network) {
    read_campaign(load_campaign_ini(
        arguments({"limits.network=" + network, "method.nd.adapter=lcm", "campaign.methods=nd"})));
  };
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "--set limits.network: ", {"[method.nd]", "network"},
                           [&] { read("false"); }));
}

TEST_F(CampaignProgram, AcceptsWallClockMeasurementsAsColumns) {
  const auto given = arguments({"analysis.columns=success,cycle_time_p95"});
  EXPECT_EQ(scenarios_of(given).size(), 1U);
}

TEST_F(CampaignProgram, GeneratesTheSameScenariosWithAnyNumberOfJobs) {
  // Mazes take varying times, so that threads finish them out of order.
  auto given = arguments({"scenarios.generator=random,maze", "scenarios.count=20"});
  const auto contents = [&given](int jobs) {
    given.jobs = jobs;
    std::vector<std::string> bytes;
    for (const Scenario& scenario : scenarios_of(given))
      bytes.push_back(scenario.name() + serialize(scenario));
    return bytes;
  };
  const std::vector<std::string> alone = contents(1);
  EXPECT_EQ(alone.size(), 20U);
  EXPECT_TRUE(alone == contents(2));
  EXPECT_TRUE(alone == contents(5));
}

TEST_F(CampaignProgram, RejectsAnMrptConfigurationWithoutTheClassBeforeAnyRun) {
  const std::string nd_ini = folder_ + "/nd.ini", path = folder_ + "/runs.results";
  write_file_atomically(nd_ini, "[Other]\nkey = 1\n");
  const auto wrong = arguments({"method.nd.config=" + nd_ini});
  CampaignConfig config = read_campaign(load_campaign_ini(wrong));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "--set method.nd.config: ", {"CHolonomicND"}, [&] {
    auto scenarios = campaign_scenarios(config, wrong);
    open_campaign_results(config, wrong, scenarios, path);
  }));
  EXPECT_FALSE(std::filesystem::exists(path));
}

// Programs link all modules. If two modules used one name for two types (an ODR violation), they
// would share the code of their vectors, and that of this file, with the cells of tables, first.
TEST_F(CampaignProgram, ComputesReferencesAndRunsMethodsWithAllModulesLinked) {
  std::vector<Cell> cells_of_a_table;
  for (std::size_t n = 0; n < 3; ++n) cells_of_a_table.emplace_back().n = n;
  ASSERT_EQ(cells_of_a_table.back().n, 2U);
  const auto plain = arguments();
  CampaignConfig config = read_campaign(load_campaign_ini(plain));
  auto scenarios = campaign_scenarios(config, plain);
  const std::string hash = scenarios.front().hash(), path = folder_ + "/runs.results";
  ResultFile results = open_campaign_results(config, plain, scenarios, path);
  const CampaignReport report =
      run_campaign_program(config, plain, std::move(scenarios), std::move(results));
  EXPECT_TRUE(report.complete);
  EXPECT_EQ(report.problem, "");
  const ResultFile file = ResultFile::open(path);
  const References references = file.read_references(hash);
  ASSERT_TRUE(references.shortest && references.safest);
  EXPECT_GE(length(references.safest->path), references.shortest->certificate.lower_bound);
  ASSERT_EQ(file.read_runs(hash).size(), 1U);
}

/// A copy of a result file in which its runs have this outcome.
void copy_with_outcome(const std::string& from, const std::string& to, Outcome outcome,
                       const std::string& detail) {
  const ResultFile file = ResultFile::open(from);
  ResultFile copy =
      ResultFile::create(to, file.read_manifest(), file.descriptors(), file.metrics());
  file.for_each_run([&](const RunRecord& run) {
    const std::string& hash = run.scenario_hash;
    if (!copy.has_scenario(hash))
      copy.add_scenario(file.read_record(hash), file.read_scenario(hash),
                        file.read_references(hash));
    RunRecord ended = run;
    ended.outcome = to_string(outcome);
    ended.outcome_detail = detail;
    copy.add_run(ended, file.read_timing(run), file.read_trajectory(run));
  });
  copy.commit();
}

TEST_F(CampaignProgram, VerifyComparesAllButTheColumnsOfTheAuthor) {
  const std::string path = folder_ + "/runs.results", own = folder_ + "/own.results";
  const auto given = arguments();
  execute(given, path);
  const ResultTable table = read_results(path);
  const auto verify = [&](const std::string& id, bool is_descriptor) {
    QuantityInfo info;
    info.id = id;
    OwnColumn column{ValueColumn(info), is_descriptor, "return 1"};
    column.values.add_number(1);
    write_with_column(ResultFile::open(path), table, column, own);
    return verify_results(own, given, {}, [](const auto&) {});
  };
  for (const bool is_descriptor : {false, true}) {
    const VerifyReport report = verify("comfort", is_descriptor);
    EXPECT_EQ(report.identical_runs(), 1U);
    EXPECT_TRUE(report.differences.empty());
    ASSERT_EQ(report.unchecked.size(), 1U);
    EXPECT_EQ(report.unchecked[0],
              "comfort: not verified, since the function that computes it is not executed "
              "(own_column.comfort of the manifest)");
  }
  // A quantity of Slalom is compared, whatever the manifest states.
  EXPECT_EQ(verify("impact_speed_of_movers", false).identical_runs(), 1U);
  EXPECT_EQ(verify("mover_collision", false).differences.size(), 1U);
}

TEST_F(CampaignProgram, VerifyTakesOnlyTimeLimitsForDifferencesOfTheMachines) {
  const std::string path = folder_ + "/runs.results", other = folder_ + "/other.results";
  const auto verify = [&](const std::vector<std::string>& overrides, Outcome outcome) {
    for (const std::string& file : {path, other}) std::filesystem::remove(file);
    const auto given = arguments(overrides);
    execute(given, path);
    copy_with_outcome(path, other, outcome, "run_wall_time = 60 s exceeded");
    return verify_results(other, given, {}, [](const auto&) {});
  };
  // Any machine that is slower than this one may need more than a limit of 1e-9 s of a cycle; the
  // policy to hold the last command has the same result on both.
  const VerifyReport limited = verify({"limits.cycle_deadline=1e-9", "limits.deadline_policy=hold"},
                                      Outcome::MethodDeadline);
  EXPECT_TRUE(limited.differences.empty());
  ASSERT_EQ(limited.time_limits.size(), 1U);
  EXPECT_NE(limited.time_limits[0].find("/nd/0: ended at a time limit in the file (run_wall_time = "
                                        "60 s exceeded)"),
            std::string::npos)
      << limited.time_limits[0];
  EXPECT_EQ(limited.identical_runs(), 0U);
  EXPECT_TRUE(throws_error(ErrorKind::Job, other, {"none was compared", "longer [limits]"},
                           [&] { verdict(limited, other); }));
  // No machine is a thousand times slower.
  const VerifyReport impossible = verify({"limits.run_wall_time=36000"}, Outcome::MethodDeadline);
  ASSERT_EQ(impossible.differences.size(), 1U);
  EXPECT_NE(impossible.differences[0].find("too early for a slower machine"), std::string::npos);
  const VerifyReport crashed = verify({}, Outcome::MethodCrash);
  EXPECT_EQ(crashed.differences.size(), 1U);
  EXPECT_TRUE(crashed.time_limits.empty());
  EXPECT_TRUE(throws_error(ErrorKind::Job, other, {"1 difference in 1 run in 1 scenario"},
                           [&] { verdict(crashed, other); }));
}

TEST(DetectableChanges, AreThoseOfWhichASampleWithoutReplacementContainsOne) {
  EXPECT_EQ(detectable_changes(20, 20), 1U);
  // C(10, 1) / C(20, 1) = 0.5 ...: of 19 changed scenarios one drawn is missed with 1/20.
  EXPECT_EQ(detectable_changes(1, 20), 19U);
  for (const std::size_t all : {30U, 200U})
    for (const std::size_t sampled : {2U, 5U, 29U}) {
      const auto unseen = [&](std::size_t changed) {
        double p = 1;
        for (std::size_t i = 0; i < sampled; ++i)
          p *= changed + i >= all
                   ? 0.0
                   : static_cast<double>(all - changed - i) / static_cast<double>(all - i);
        return p;
      };
      const std::size_t found = detectable_changes(sampled, all);
      EXPECT_LE(unseen(found), 0.05 + 1e-12);
      EXPECT_GT(unseen(found - 1), 0.05 - 1e-12);
    }
}

TEST_F(CampaignProgram, RefusesResultsOfAnotherCampaignNamingWhatDiffers) {
  const std::string path = folder_ + "/runs.results";
  const auto open = [&](const std::vector<std::string>& overrides,
                        ExistingResults existing = ExistingResults::Continue) {
    auto given = arguments(overrides);
    given.existing = existing;
    const CampaignConfig config = read_campaign(load_campaign_ini(given));
    return open_campaign_results(config, given, {}, path);
  };
  EXPECT_TRUE(throws_error(ErrorKind::File, path + ": does not exist", {"--resume"},
                           [&] { open({}, ExistingResults::Require); }));
  open({"robot.max_v=0.6"});
  EXPECT_TRUE(throws_error(ErrorKind::File, path + ": holds another campaign: ",
                           {"robot.max_v is 1 here and 0.6 in " + path, "--overwrite"},
                           [&] { open({}); }));
  // Settings that change no result may differ.
  open({"robot.max_v=0.60", "record.rawlog=all", "analysis.rows=density:2"},
       ExistingResults::Require);
  open({}, ExistingResults::Overwrite);
  open({});
}

TEST_F(CampaignProgram, NoticesFilesOfMethodsThatAreReplacedWhileTheyRun) {
  const std::string path = folder_ + "/runs.results", helper = folder_ + "/helper";
  write_file_atomically(helper, "one");
  const auto given = arguments();
  CampaignConfig config = read_campaign(load_campaign_ini(given));
  auto scenarios = campaign_scenarios(config, given);
  config.dependencies = {{"method.nd.module/helper", helper}};
  ResultFile results = open_campaign_results(config, given, scenarios, path);
  write_file_atomically(helper, "two");
  const CampaignReport report =
      run_campaign_program(config, given, std::move(scenarios), std::move(results));
  EXPECT_NE(report.problem.find("module/helper of method.nd is not the one of " + path),
            std::string::npos)
      << report.problem;
}

TEST_F(CampaignProgram, StoresWhichMethodsArePrivileged) {
  const std::string path = folder_ + "/runs.results";
  const auto given = arguments();
  CampaignConfig config = read_campaign(load_campaign_ini(given));
  EXPECT_EQ(open_campaign_results(config, given, {}, path).read_manifest().count(kPrivilegedKey),
            0U);
  std::filesystem::remove(path);
  config.privileged = {{"nd"}, {}};
  const Manifest manifest = open_campaign_results(config, given, {}, path).read_manifest();
  EXPECT_EQ(privileged_methods(manifest).names(), std::vector<std::string>{"nd"});
}

TEST_F(CampaignProgram, NeverReplacesAFileThatHoldsNoResults) {
  const std::string path = folder_ + "/stranger";
  write_file_atomically(path, "a stranger's text");
  auto given = arguments();
  const CampaignConfig config = read_campaign(load_campaign_ini(given));
  for (const auto existing : {ExistingResults::Continue, ExistingResults::Overwrite}) {
    given.existing = existing;
    EXPECT_TRUE(throws_error(ErrorKind::File, path + ": ", {"a result file (.results)"},
                             [&] { open_campaign_results(config, given, {}, path); }));
    EXPECT_EQ(read_file(path), "a stranger's text");
  }
}

/// A campaign whose method and robot have the parameters of a file with this text.
class RosParameterCampaign : public CampaignProgram {
 protected:
  void check(const std::string& yaml) const {
    write_file_atomically(folder_ + "/nav.yaml", yaml);
    CampaignConfig config = read_campaign(
        load_campaign_ini(arguments({"robot.from=nav.yaml", "sensor.from=nav.yaml",
                                     "method.ros.from=nav.yaml", "campaign.methods=ros"})));
    check_campaign(config);
    EXPECT_EQ(config.ini_text.find("nav.yaml"), std::string::npos) << config.ini_text;
    EXPECT_NE(config.ini_text.find("plugin = libslalom_"), std::string::npos) << config.ini_text;
  }
};

TEST_F(RosParameterCampaign, ControllersOfNav2BecomeMethodsThatAcceptTheirParameters) {
  for (const char* name : {"/humble.yaml", "/jazzy.yaml"})
    check(read_text(kRosParameters + std::string(name), "parameters", kMaxConfigSize));
  check(
      "A: {plugin: \"nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController\",\n"
      "  desired_linear_vel: 0.5, use_rotate_to_heading: false, use_collision_detection: false}\n");
}

TEST_F(RosParameterCampaign, PlannersOfMoveBaseBecomeMethodsThatAcceptTheirParameters) {
  check("DWAPlannerROS: {max_vel_x: 0.5, min_rot_vel: -0.3, vth_samples: 12}\n");
  check("TrajectoryPlannerROS: {vtheta_samples: 9, pdist_scale: 0.6, gdist_scale: 0.8}\n");
  check(
      "EBandPlannerROS: {num_iterations_eband_optimization: 2, k_prop: 3}\nplanner_frequency: 1\n");
}

TEST_F(RosParameterCampaign, ValuesThatTheMethodRefusesAreNamedWithTheirLine) {
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "", {"vth_samples", "2"},
                           [&] { check("DWAPlannerROS:\n  vth_samples: 1\n"); }));
  EXPECT_TRUE(throws_error(
      ErrorKind::Usage, folder_ + "/nav.yaml:2: DWAPlannerROS.max_vel_x: ", {"robot.max_v", "> 0"},
      [&] { check("DWAPlannerROS:\n  max_vel_x: -1\n"); }));
}

TEST(TestBedNames, AreThoseOfTheHashesInTheDocumentation) {
  std::istringstream lines(read_file(kDocs + "/reference/testbeds.md"));
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t hash = line.rfind("` | ") - 32;
    if (line.rfind("| `", 0) != 0 || hash > line.size() || line[hash - 1] != '`') continue;
    EXPECT_EQ(testbed_of(line.substr(hash, 32)), line.substr(3, line.find('`', 3) - 3)) << line;
    ++count;
  }
  EXPECT_EQ(count, 9U);
  EXPECT_EQ(testbed_of(std::string(32, '0')), "");
}

}  // namespace
}  // namespace slalom
