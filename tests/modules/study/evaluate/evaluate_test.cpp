// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/analysis/campaign_settings.h>
#include <slalom/evaluate.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_file.h>
#include <slalom/results/privileged.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <stdexcept>

namespace slalom {
namespace {

Scenario free_field(const std::string& name, double goal_y) {
  Primitives obstacles;
  obstacles.discs.push_back({{8, 5}, 0.5});
  return Scenario::continuous(name, {0, 0, 10, 10}, obstacles, {1, 1, 0}, {5, goal_y});
}

std::vector<Scenario> two_fields() {
  return {free_field("low", 3), free_field("high", 7)};
}

/// Turns towards the goal, then moves forward.
Command towards_goal(const Observation& observation) {
  const double bearing = std::atan2(observation.goal_in_robot.y, observation.goal_in_robot.x);
  return {std::abs(bearing) < 0.3 ? 1.0 : 0.0, std::max(-1.5, std::min(1.5, 2 * bearing))};
}

Methods towards_goal_only() {
  Methods methods;
  methods.add("mine", towards_goal);
  return methods;
}

/// The values of a metric, one per run.
std::vector<double> values_of(const ResultTable& table, const std::string& id) {
  const ValueColumn* column = find_metric(table, id);
  std::vector<double> values;
  for (std::size_t run = 0; column != nullptr && run < table.size(); ++run)
    values.push_back(column->is_na(run) ? -1 : column->number(run));
  return values;
}

std::string outcome_of(const ResultTable& table, std::size_t run) {
  return table.outcomes[table.outcome[run]];
}

/// Texts by run: all that a result file and a table have in common.
std::string text_of(const ResultTable& table) {
  std::string text;
  for (std::size_t run = 0; run < table.size(); ++run)
    text += run_id(table, run) + " " + outcome_of(table, run) + " " +
            table.details.at(run).outcome_detail + " " + table.details.at(run).trajectory_hash +
            "\n";
  return text;
}

TEST(Evaluate, WritesAResultFileThatEqualsItsTable) {
  Options options;
  options.output = testing::TempDir() + "/evaluated.results";
  const ResultTable table = evaluate(towards_goal_only(), two_fields(), options);
  const ResultTable read = read_detailed_results(options.output);
  EXPECT_EQ(text_of(read), text_of(table));
  EXPECT_EQ(read.manifest, table.manifest);
  for (const ValueColumn& metric : table.metrics) {
    if (metric.wall_clock) continue;
    const std::string& id = metric.info().id;
    EXPECT_EQ(values_of(read, id), values_of(table, id));
  }
  const ResultFile file = ResultFile::open(options.output);
  file.for_each_run([&](const RunRecord& run) {
    EXPECT_EQ(file.read_trajectory(run).samples.back().t,
              values_of(table, "time_to_goal").at(run.scenario_hash == table.scenario_hashes[1]));
  });
}

TEST(Generate, AddsWalkersToAnyFamily) {
  Options options;
  options.walkers.count = 2;
  for (const Scenario& scenario : generate(RoomsOptions{}, 2, 1, options))
    EXPECT_EQ(scenario.movers().size(), 2U);
  CrossingOptions crossing;
  crossing.movers.min_movers = crossing.movers.max_movers = 3;
  EXPECT_EQ(generate(crossing, 1, 1, options).at(0).movers().size(), 5U);
}

TEST(Evaluate, ShowsEachRunWithItsTrajectoryToTheObserver) {
  std::map<std::string, std::string> hashes;  // of trajectories, by run
  Options options;
  options.observer = [&](const RunRecord& run, const Trajectory& trajectory) {
    EXPECT_EQ(trajectory.hash(), run.trajectory_hash);
    EXPECT_GT(trajectory.samples.size(), 1U);
    hashes[run_id(run)] = trajectory.hash();
  };
  const ResultTable table = evaluate(towards_goal_only(), two_fields(), options);
  ASSERT_EQ(hashes.size(), table.size());
  for (std::size_t run = 0; run < table.size(); ++run)
    EXPECT_EQ(hashes.count(run_id(table, run)), 1U);
}

TEST(Evaluate, RunsAFunctionInEveryScenario) {
  Options options;
  options.repetitions = 2;
  const ResultTable table = evaluate(towards_goal_only(), two_fields(), options);
  ASSERT_EQ(table.size(), 4U);
  EXPECT_EQ(table.methods, std::vector<std::string>{"mine"});
  EXPECT_EQ(table.scenario_names, (std::vector<std::string>{"high", "low"}));
  EXPECT_EQ(values_of(table, "success"), (std::vector<double>{1, 1, 1, 1}));
  ASSERT_NE(find_descriptor(table, "density"), nullptr);
  EXPECT_FALSE(find_descriptor(table, "density")->is_na(0));
  ASSERT_NE(find_metric(table, "cycle_time_mean"), nullptr);
  EXPECT_TRUE(find_metric(table, "cycle_time_mean")->wall_clock);
  EXPECT_EQ(table.manifest.at("campaign.methods"), "mine");
}

TEST(Evaluate, ResultsDoNotDependOnTheWorkers) {
  Options options;
  options.metrics = {"success", "path_length", "optimality"};
  options.sensor.noise_sigma = 0.01;
  options.odometry.turn_sigma = 0.05;
  const ResultTable one = evaluate(towards_goal_only(), two_fields(), options);
  options.workers = 3;
  const ResultTable three = evaluate(towards_goal_only(), two_fields(), options);
  options.workers = 0;  // one per core
  const ResultTable all = evaluate(towards_goal_only(), two_fields(), options);
  options.workers = 1;
  options.in_process = true;
  const ResultTable here = evaluate(towards_goal_only(), two_fields(), options);
  for (const std::string& id : options.metrics) {
    EXPECT_EQ(values_of(three, id), values_of(one, id)) << id;
    EXPECT_EQ(values_of(all, id), values_of(one, id)) << id;
    EXPECT_EQ(values_of(here, id), values_of(one, id)) << id;
  }
  options.seed = 2;
  EXPECT_NE(values_of(evaluate(towards_goal_only(), two_fields(), options), "path_length"),
            values_of(one, "path_length"));
}

TEST(Evaluate, AnExceptionEndsItsRunAsMethodError) {
  for (const bool in_process : {false, true}) {
    Options options;
    options.in_process = in_process;
    Methods methods;
    methods.add("mine", [](const Observation& observation) {
      if (observation.goal_in_robot.y > 5) throw std::runtime_error("too far");
      return towards_goal(observation);
    });
    const ResultTable table = evaluate(methods, two_fields(), options);
    EXPECT_EQ(outcome_of(table, 0), "method_error");
    EXPECT_EQ(outcome_of(table, 1), "success");
  }
}

TEST(Evaluate, StateOfAFunctionDoesNotPassFromRunToRun) {
  Methods methods;
  methods.add("mine", [cycles = 0](const Observation& observation) mutable {
    ++cycles;
    if (cycles > std::lround(observation.time / 0.1) + 1) throw std::runtime_error("old state");
    return towards_goal(observation);
  });
  const ResultTable table = evaluate(methods, two_fields());
  EXPECT_EQ(values_of(table, "success"), (std::vector<double>{1, 1}));
}

TEST(Evaluate, AcceptsFactoriesOfMethods) {
  struct Stopped : Method {
    void reset(const NavigationTask&) override {}
    Command step(const Observation&) override { return {}; }
  };
  Methods methods;
  methods.add("stopped", [](const RobotModel& robot, const SensorModel&) {
    if (robot.radius != 0.4) throw std::runtime_error("another robot");
    return std::make_unique<Stopped>();
  });
  Options options;
  options.robot.radius = 0.4;
  const ResultTable table = evaluate(methods, {free_field("one", 3)}, options);
  EXPECT_EQ(outcome_of(table, 0), "stuck");
}

TEST(Evaluate, ReportsProgressAndCanBeCanceled) {
  Options options;
  std::vector<std::string> phases;
  std::size_t last_total = 0;
  options.progress = [&](const std::string& phase, std::size_t done, std::size_t total) {
    if (phases.empty() || phases.back() != phase) phases.push_back(phase);
    EXPECT_LE(done, total);
    last_total = total;
  };
  evaluate(towards_goal_only(), two_fields(), options);
  EXPECT_EQ(phases, (std::vector<std::string>{"Describing scenarios", "Running methods"}));
  EXPECT_EQ(last_total, 2U);
  options.progress = {};
  options.cancel = [] { return true; };
  EXPECT_EQ(evaluate(towards_goal_only(), two_fields(), options).size(), 0U);
}

TEST(Evaluate, RunsEqualScenariosOnce) {
  const ResultTable table = evaluate(towards_goal_only(), {free_field("a", 3), free_field("b", 3)});
  EXPECT_EQ(table.size(), 1U);
}

TEST(Evaluate, TheManifestHasTheOptionsUnderTheirNames) {
  Options options;
  options.sensor.noise_sigma = 0.02;
  options.metrics = {"success"};
  options.cancel = [] { return true; };
  // The corners are 0.5 m from the center.
  options.robot.footprint = "0.3,0.4; -0.3,0.4; -0.3,-0.4; 0.3,-0.4";
  const Manifest manifest = evaluate(towards_goal_only(), two_fields(), options).manifest;
  EXPECT_EQ(campaign_setting(manifest, "sensor.noise_sigma"), "0.02");
  EXPECT_EQ(manifest.at("robot.radius"), "0.5");
  EXPECT_EQ(manifest.at("robot.kinematics"), "diff_drive");
  EXPECT_EQ(manifest.at("metrics.enabled"), "success");
}

testing::AssertionResult refused(const Options& options, const std::string& where,
                                 std::initializer_list<std::string> words) {
  return throws_error(ErrorKind::Usage, where, words,
                      [&] { evaluate(towards_goal_only(), two_fields(), options); });
}

TEST(Evaluate, RejectsInvalidOptionsWithTheirName) {
  Options options;
  options.metrics = {"sucess"};
  EXPECT_TRUE(refused(options, "options metrics.enabled: ", {"'sucess'", "expected 'success'"}));
  options = {};
  options.descriptors = {"density", "clear"};
  EXPECT_TRUE(refused(options, "options metrics.descriptors: ", {"'clear'"}));
  options = {};
  options.repetitions = 0;
  EXPECT_TRUE(
      refused(options, "options campaign.repetitions: ", {"'0'", "an integer in [1, 1000000]"}));
  options = {};
  options.seed = 1ULL << 63;
  EXPECT_TRUE(refused(options, "options campaign.seed: ", {"an integer in [0, "}));
  options = {};
  options.deadline.cycle_deadline = std::nan("");
  EXPECT_TRUE(refused(options, "options limits.cycle_deadline: ", {"expected a number >= 0"}));
  options = {};
  options.robot.radius = -1;
  EXPECT_TRUE(refused(options, "options robot.radius: ", {"'-1'", "expected a number > 0"}));
  options = {};
  options.simulation.step = 0.03;
  EXPECT_TRUE(refused(options, "options simulation.step: ", {"does not divide"}));
  options = {};
  options.robot.footprint = "0.3,0.4; -0.3,0.4";
  EXPECT_TRUE(refused(options, "options robot.footprint: ", {"3 to 64 corners"}));
}

TEST(Evaluate, RejectsMissingAndDuplicateInput) {
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "methods: ", {"none given", "at least one"},
                           [] { evaluate({}, two_fields()); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "evaluate: ", {"no scenario", "generate()"},
                           [] { evaluate(towards_goal_only(), {}); }));
  Methods methods = towards_goal_only();
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "method 'mine': ", {"duplicate", "once"},
                           [&] { methods.add("mine", towards_goal); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "method '': ", {"empty name"},
                           [&] { methods.add("", towards_goal); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "method 'none': ", {"no function"},
                           [&] { methods.add("none", Controller()); }));
}

TEST(Evaluate, AMethodThatCannotBeBuiltIsReportedBeforeTheFirstRun) {
  Methods methods;
  methods.add("broken", [](const RobotModel&, const SensorModel&) -> std::unique_ptr<Method> {
    throw usage_error("broken", "no such class");
  });
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "broken: ", {"no such class"},
                           [&] { evaluate(methods, two_fields()); }));
}

TEST(CrossTable, IsPrintedForEachMethod) {
  Methods methods = towards_goal_only();
  methods.add("stopped", [](const Observation&) { return Command(); });
  const ResultTable table = evaluate(methods, two_fields());
  const std::string text = cross_table(table, "density:0,0.5", {"success", "path_length"});
  EXPECT_NE(text.find("mine by density"), std::string::npos) << text;
  EXPECT_NE(text.find("stopped by density"), std::string::npos) << text;
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "", {"'densty'", "'density'"},
                           [&] { cross_table(table, "densty:4", {"success"}); }));
}

/// Stops, and needs tracks.
class Watcher : public Method {
 public:
  void reset(const NavigationTask&) override {}
  Command step(const Observation& observation) override {
    return {tracks_of(observation).empty() ? 0.0 : 1.0, 0};
  }
  bool uses_tracks() const override { return true; }
};

TEST(Evaluate, RecordsWhichMethodsArePrivileged) {
  Methods methods = towards_goal_only();
  methods.add("watcher", [](const RobotModel&, const SensorModel&) -> std::unique_ptr<Method> {
    return std::make_unique<Watcher>();
  });
  Options options;
  options.simulation.max_time = 1;
  for (const bool in_process : {false, true}) {
    options.in_process = in_process;
    const ResultTable table = evaluate(methods, {free_field("low", 3)}, options);
    EXPECT_EQ(privileged_methods(table.manifest).names(), std::vector<std::string>{"watcher"});
    const std::string text = cross_table(table, "all", {"success"});
    EXPECT_NE(text.find("watcher* by all"), std::string::npos) << text;
    EXPECT_NE(text.find("* privileged: watcher is given"), std::string::npos) << text;
    EXPECT_EQ(text.find("mine*"), std::string::npos) << text;
  }
  EXPECT_EQ(
      evaluate(towards_goal_only(), {free_field("low", 3)}, options).manifest.count(kPrivilegedKey),
      0U);
}

}  // namespace
}  // namespace slalom
