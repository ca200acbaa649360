// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "manual_time.h"
#include "open_files.h"

#include <slalom/campaign/run_campaign.h>
#include <slalom/io/scenario_list.h>
#include <slalom/references/reference_codec.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <clocale>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <sched.h>
#include <set>
#include <stdexcept>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <thread>
#include <tuple>
#include <unistd.h>
#include <utility>

namespace slalom {
namespace {

class SpeechlessError : public std::exception {
 public:
  const char* what() const noexcept override { return nullptr; }
};

/// Changes of a run to its process that require a new one for the next run.
const std::vector<std::string> kMarks = {
    "thread",  "clone", "child", "nonblocking", "asynchronous", "shut",      "impatient",
    "curious", "timer", "nice",  "scheduler",   "unprivileged", "undumpable"};

/// Turns towards the goal and moves forward. Misbehaves according to its kind in the scenario whose
/// goal has y > 5.
class TestMethod : public Method {
 public:
  TestMethod(std::string kind, const RobotModel& robot, ManualTime& time)
      : kind_(std::move(kind)), robot_(robot), time_(time) {}

  void reset(const NavigationTask& task) override {
    misbehaves_ = task.goal.y > 5;
    if (kind_ == "mapped" && shared_tables().empty()) throw std::runtime_error("own tables");
    if (kind_ == "overwrite" && misbehaves_) overwrite_shared_tables();
  }

  Command step(const Observation& observation) override {
    if (misbehaves_ && observation.time > 1.5) {
      if (observation.time < 1.65) misbehave_once();
      if (kind_ == "nan" || kind_ == "infinite" || kind_ == "too_fast") return invalid_command();
      misbehave();
    }
    const double bearing = std::atan2(observation.goal_in_robot.y, observation.goal_in_robot.x);
    const double w = std::max(-robot_.max_w, std::min(robot_.max_w, 2 * bearing));
    return {std::abs(bearing) < 0.3 ? robot_.max_v : 0.0, w};
  }

  bool uses_tracks() const override { return kind_ == "tracking"; }
  bool uses_map() const override { return kind_ == "knowing"; }

 private:
  Command invalid_command() const {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    if (kind_ == "nan") return {nan, 0};
    if (kind_ == "infinite") return {0, std::numeric_limits<double>::infinity()};
    return {1.01 * robot_.max_v, 0};  // "too_fast"
  }

  void misbehave_once() const {
    static int runs = 0;  // in this process
    ++runs;
    if (kind_ == "rounding_first" && runs == 1) std::fesetround(FE_UPWARD);
    if (kind_ == "spoil") spoil_process();
    if (!is_mark(kind_)) return;
    if (runs > 1) throw std::runtime_error("not a fresh process");
    for (const int file : open_files()) mark_socket(file);
    if (kind_ == "timer") start_timer();
    if (kind_ == "nice") nice(1);
    if (kind_ == "scheduler") set_scheduler();
    if (kind_ == "unprivileged") prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    if (kind_ == "undumpable") prctl(PR_SET_DUMPABLE, 0);
    if (kind_ == "thread") std::thread([] { pause(); }).detach();
    if ((kind_ == "child" && fork() == 0) ||
        (kind_ == "clone" && syscall(SYS_clone, 0, nullptr, nullptr, nullptr, nullptr) == 0))
      while (true) pause();
  }

  /// Whether a run of that kind leaves a mark on its process that cannot be removed.
  static bool is_mark(const std::string& kind) {
    return std::find(kMarks.begin(), kMarks.end(), kind) != kMarks.end();
  }

  void mark_socket(int file) const {
    const timeval limit = {100, 0};
    const int one = 1;
    if (kind_ == "nonblocking") fcntl(file, F_SETFL, O_NONBLOCK);
    if (kind_ == "asynchronous") fcntl(file, F_SETFL, O_ASYNC);
    if (kind_ == "shut") shutdown(file, SHUT_RD);
    if (kind_ == "impatient") setsockopt(file, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
    if (kind_ == "curious") setsockopt(file, SOL_SOCKET, SO_PASSCRED, &one, sizeof one);
  }

  static void start_timer() {
    timer_t timer = {};
    timer_create(CLOCK_MONOTONIC, nullptr, &timer);
    const itimerspec late = {{}, {1000, 0}};
    timer_settime(timer, 0, &late, nullptr);
  }

  static void set_scheduler() {
    const sched_param priority = {};
    sched_setscheduler(0, SCHED_BATCH, &priority);
  }

  static void spoil_process() {
    const auto expect = [](bool restored, const char* what) {
      if (!restored) throw std::runtime_error(std::string(what) + " of the last run");
    };
    expect(std::fegetround() == FE_TONEAREST, "rounding mode");
    std::fesetround(FE_DOWNWARD);
    expect(std::signal(SIGUSR1, SIG_IGN) == SIG_DFL, "signal handler");
    sigset_t blocked, before;
    sigemptyset(&blocked);
    sigaddset(&blocked, SIGUSR2);
    sigprocmask(SIG_BLOCK, &blocked, &before);
    expect(sigismember(&before, SIGUSR2) == 0, "signal mask");
    expect(setlocale(LC_ALL, nullptr) == std::string("C"), "locale");
    setlocale(LC_ALL, "C.UTF-8");
    expect(std::filesystem::current_path() != "/proc", "folder");
    std::filesystem::current_path("/proc");
    expect(umask(0123) != 0123, "umask");
    rlimit files = {};
    getrlimit(RLIMIT_NOFILE, &files);
    expect(files.rlim_cur != 77, "resource limit");
    files.rlim_cur = 77;
    setrlimit(RLIMIT_NOFILE, &files);
    expect(getenv("SLALOM_TEST_SPOILED") == nullptr, "environment");
    setenv("SLALOM_TEST_SPOILED", "1", 1);
    expect(alarm(1000) == 0, "alarm");
  }

  void misbehave() const {
    if (kind_ == "crash") {
      std::signal(SIGSEGV, SIG_DFL);  // sanitizers would catch it and exit
      std::raise(SIGSEGV);
    }
    if (kind_ == "abort") std::abort();
    if (kind_ == "killed") std::raise(SIGKILL);
    if (kind_ == "throw_number") throw 42;
    if (kind_ == "speechless") throw SpeechlessError();
    if (kind_ == "wordy") throw std::runtime_error(std::string(10 << 20, 'x'));
    if (kind_ == "greedy") exhaust_memory();
    if (kind_ == "rounding") std::fesetround(FE_UPWARD);
    if (kind_ == "chatty") std::cout << std::string(100000, '#') << std::endl;
    if (kind_ == "slow") time_.advance(0.15);
    if (kind_ == "disconnect")
      for (int descriptor = 3; descriptor < 1024; ++descriptor) close(descriptor);
    if (kind_ == "exit") std::exit(0);
    if (kind_ == "throw") throw std::runtime_error("path lost");
    while (kind_ == "hang") time_.advance(0.01);
  }

  /// The memory of this process that is shared with others as tables of scenarios.
  static std::vector<std::pair<char*, std::size_t>> shared_tables() {
    std::vector<std::pair<char*, std::size_t>> tables;
    std::ifstream mappings("/proc/self/maps");
    for (std::string line; std::getline(mappings, line);) {
      if (line.find("slalom tables") == std::string::npos) continue;
      char* end = nullptr;
      const std::uintptr_t first = std::strtoull(line.c_str(), &end, 16);
      const std::uintptr_t last = std::strtoull(end + 1, nullptr, 16);
      // NOLINTNEXTLINE(performance-no-int-to-ptr): the file states addresses as text.
      tables.emplace_back(reinterpret_cast<char*>(first), last - first);
    }
    return tables;
  }

  static void overwrite_shared_tables() {
    for (const auto& [bytes, size] : shared_tables()) {
      EXPECT_NE(mprotect(bytes, size, PROT_READ | PROT_WRITE), 0);
      // The remaining possibility: other memory at the same address.
      EXPECT_EQ(
          mmap(bytes, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0),
          bytes);
    }
  }

  static void exhaust_memory() {
    std::vector<std::unique_ptr<std::string>> blocks;
    while (true) blocks.push_back(std::make_unique<std::string>(10 << 20, 'x'));
  }

  std::string kind_;
  RobotModel robot_;
  ManualTime& time_;
  bool misbehaves_ = false;
};

Scenario free_field(const std::string& name, double goal_y) {
  Primitives obstacles;
  obstacles.discs.push_back({{8, 5}, 0.5});
  return Scenario::continuous(name, {0, 0, 10, 10}, obstacles, {1, 1, 0}, {5, goal_y});
}

class RecordingSink : public CampaignSink {
 public:
  void add_scenario(const ScenarioRecord& record, const References& references,
                    const PackedScenario& packed) override {
    EXPECT_EQ(deserialize_scenario(packed.content, record.name).hash(), record.hash);
    EXPECT_EQ(to_bytes(packed.unpack_references(record.name)), to_bytes(references));
    scenarios.push_back(record);
  }
  void add_run(const RunRecord& run, const RunTiming&, const PackedTrajectory& packed) override {
    const Trajectory trajectory = packed.unpack(run_id(run));
    EXPECT_TRUE(trajectory.samples.empty() || trajectory.hash() == run.trajectory_hash);
    runs.push_back(run);
  }
  std::vector<ScenarioRecord> scenarios;
  std::vector<RunRecord> runs;
};

class CampaignTest : public testing::Test {
 protected:
  CampaignTest() {
    registry_.add("test", [this](const IniFile& ini, const std::string& section) {
      const std::string kind = ini.get(section, "kind").value_or("good");
      return [=](const RobotModel& robot, const SensorModel&) -> std::unique_ptr<Method> {
        if (kind == "unbuildable") throw usage_error(section, "unknown class", "a known class");
        if (kind == "deadly") std::abort();
        return std::make_unique<TestMethod>(kind, robot, time_);
      };
    });
  }

  IniFile ini_for(const std::vector<std::string>& kinds,
                  const std::string& limits = "run_wall_time = 2") const {
    std::string methods, sections;
    for (const std::string& kind : kinds) {
      methods += (methods.empty() ? "" : ",") + kind;
      sections += "[method." + kind + "]\nadapter = test\nkind = " + kind + "\n";
    }
    return IniFile::from_text("[campaign]\nrepetitions = 2\nmethods = " + methods + "\n[limits]\n" +
                              limits + "\n" + sections);
  }

  RecordingSink run(const std::vector<std::string>& kinds, int workers) {
    return run(ini_for(kinds), workers);
  }

  RecordingSink run(const IniFile& ini, int workers) {
    Campaign campaign{read_campaign_options(ini),
                      {free_field("low", 3), free_field("high", 7)},
                      read_methods(ini, registry_)};
    campaign.recorders = recorders_;
    campaign.options.clock = time_.clock();
    campaign_ = &campaign;
    const auto progress = make_silent_progress();
    RecordingSink sink;
    const CampaignSummary summary = run_campaign(campaign, sink, {workers, *progress, nullptr});
    EXPECT_TRUE(summary.complete);
    EXPECT_EQ(summary.runs, sink.runs.size());
    sort_by_plan(sink.runs, campaign);
    return sink;
  }

  /// Results arrive as they are obtained.
  static void sort_by_plan(std::vector<RunRecord>& runs, const Campaign& campaign) {
    std::map<std::string, std::size_t> rank;
    for (const Scenario& scenario : campaign.scenarios) rank.emplace(scenario.name(), rank.size());
    for (const NamedMethod& method : campaign.methods) rank.emplace(method.name, rank.size());
    const auto key = [&](const RunRecord& run) {
      return std::tuple(rank.at(run.scenario_name), rank.at(run.method), run.repetition);
    };
    std::sort(runs.begin(), runs.end(),
              [&](const RunRecord& a, const RunRecord& b) { return key(a) < key(b); });
  }

  ManualTime time_;  ///< shared by all workers: runs that advance it need a single worker
  Campaign* campaign_ = nullptr;  ///< that is being run
  MethodRegistry registry_;
  std::vector<RunRecorder> recorders_;
};

/// The outcomes of a method's runs in the scenario where it misbehaves.
std::set<std::string> outcomes_of(const RecordingSink& sink, const std::string& method) {
  std::set<std::string> outcomes;
  for (const RunRecord& r : sink.runs)
    if (r.method == method && r.scenario_name == "high") outcomes.insert(r.outcome);
  return outcomes;
}

TEST_F(CampaignTest, RunsEveryMethodInEveryScenario) {
  const RecordingSink sink = run({"good", "other"}, 2);
  ASSERT_EQ(sink.scenarios.size(), 2U);
  ASSERT_EQ(sink.runs.size(), 8U);  // 2 scenarios x 2 methods x 2 repetitions
  EXPECT_EQ(sink.runs[0].scenario_name, "low");
  EXPECT_EQ(sink.runs[0].method, "good");
  EXPECT_EQ(sink.runs[1].repetition, 1);
  EXPECT_EQ(sink.runs[2].method, "other");
  EXPECT_EQ(sink.runs[4].scenario_name, "high");
  for (const RunRecord& r : sink.runs) {
    EXPECT_EQ(r.outcome, "success") << r.outcome_detail;
    EXPECT_EQ(r.metrics.at("success").value.number(), 1);
  }
}

bool same_run(const RunRecord& a, const RunRecord& b) {
  const auto values = [](const RunRecord& run) {
    std::vector<std::pair<std::string, Value>> metrics;
    for (const auto& [id, value] : run.metrics) metrics.emplace_back(id, value.value);
    return metrics;
  };
  return a.scenario_hash == b.scenario_hash && a.method == b.method && a.seed == b.seed &&
         a.outcome == b.outcome && a.outcome_detail == b.outcome_detail &&
         a.trajectory_hash == b.trajectory_hash && values(a) == values(b);
}

TEST_F(CampaignTest, SharedTablesGiveTheSameRuns) {
  // A single worker for a single method computes its tables itself.
  std::vector<RunRecord> expected;
  for (const char* kind : {"good", "crash", "throw"})
    for (const RunRecord& run : run({kind}, 1).runs) expected.push_back(run);
  EXPECT_EQ(outcomes_of(run({"mapped"}, 1), "mapped"), std::set<std::string>{"method_error"});
  for (const int workers : {1, 3}) {
    const RecordingSink sink = run({"good", "crash", "throw", "mapped"}, workers);
    EXPECT_EQ(outcomes_of(sink, "mapped"), std::set<std::string>{"success"}) << "shared tables";
    for (const RunRecord& one : expected)
      EXPECT_EQ(std::count_if(sink.runs.begin(), sink.runs.end(),
                              [&](const RunRecord& other) { return same_run(one, other); }),
                1)
          << one.method << " " << one.scenario_name << " " << one.repetition;
  }
}

TEST_F(CampaignTest, AMethodThatOverwritesTheSharedTablesHarmsOnlyItself) {
  const RecordingSink alone = run({"good", "other"}, 1);
  const RecordingSink together = run({"overwrite", "good", "other"}, 1);
  EXPECT_NE(outcomes_of(together, "overwrite"), std::set<std::string>{"success"});
  EXPECT_EQ(outcomes_of(together, "overwrite").count("infrastructure_error"), 0U);
  for (const RunRecord& one : alone.runs)
    EXPECT_EQ(std::count_if(together.runs.begin(), together.runs.end(),
                            [&](const RunRecord& other) { return same_run(one, other); }),
              1)
        << one.method << " " << one.scenario_name << " " << one.repetition;
}

TEST_F(CampaignTest, MethodsGetTheSameSeedsInTheSameScenario) {
  const RecordingSink sink = run({"good", "other"}, 1);
  EXPECT_EQ(sink.runs[0].seed, sink.runs[2].seed);
  EXPECT_NE(sink.runs[0].seed, sink.runs[1].seed);
  EXPECT_NE(sink.runs[0].seed, sink.runs[4].seed);
}

TEST_F(CampaignTest, AMisbehavingMethodEndsOnlyItsOwnRun) {
  const std::map<std::string, std::string> expected = {{"crash", "method_crash"},
                                                       {"abort", "method_crash"},
                                                       {"exit", "method_crash"},
                                                       {"throw", "method_error"},
                                                       {"throw_number", "method_error"},
                                                       {"speechless", "method_error"},
                                                       {"wordy", "method_error"},
                                                       {"hang", "method_deadline"},
                                                       {"nan", "method_invalid_command"},
                                                       {"infinite", "method_invalid_command"},
                                                       {"too_fast", "method_invalid_command"},
                                                       {"chatty", "success"},
                                                       {"good", "success"}};
  std::vector<std::string> kinds;
  for (const auto& [kind, outcome] : expected) kinds.push_back(kind);
  testing::internal::CaptureStdout();
  const RecordingSink sink = run(kinds, 1);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  ASSERT_EQ(sink.runs.size(), 4 * expected.size());
  for (const RunRecord& r : sink.runs) {
    EXPECT_EQ(r.outcome, r.scenario_name == "low" ? "success" : expected.at(r.method)) << r.method;
    if (r.outcome == "success") continue;
    EXPECT_EQ(r.metrics.at("success").value, Value::of(0));
    EXPECT_TRUE(r.metrics.at("optimality").value.is_na());
    EXPECT_FALSE(r.outcome_detail.empty());
    EXPECT_LT(r.outcome_detail.size(), 5000U);
  }
}

TEST_F(CampaignTest, AnExceptionWithoutATextWhereAMethodIsBuiltIsItsError) {
  registry_.add("fragile", [](const IniFile&, const std::string&) {
    return [](const RobotModel&, const SensorModel&) -> std::unique_ptr<Method> {
      throw SpeechlessError();
    };
  });
  const IniFile ini =
      IniFile::from_text("[campaign]\nmethods = it\n[method.it]\nadapter = fragile\n");
  for (const RunRecord& r : run(ini, 1).runs) EXPECT_EQ(r.outcome, "method_error");
}

TEST_F(CampaignTest, ACrashedRunIsReconstructedUpToTheCrash) {
  const RecordingSink sink = run({"crash", "hang", "nan", "throw"}, 1);
  std::map<std::string, std::set<std::string>> hashes;
  for (const RunRecord& r : sink.runs) {
    if (r.scenario_name == "low") continue;
    EXPECT_GT(r.metrics.at("path_length").value.number(), 0.05) << r.method;
    hashes[r.method].insert(r.trajectory_hash);
  }
  // All fail in the same control cycle of identical runs and differ only in the kind of failure.
  EXPECT_EQ(hashes["crash"].size(), 1U);
  for (const char* method : {"hang", "nan"}) EXPECT_EQ(hashes[method], hashes["crash"]) << method;
  EXPECT_EQ(hashes["throw"], hashes["crash"]);
}

/// The simulation ends as if nothing had happened, but the worker cannot answer.
TEST_F(CampaignTest, ACrashIsNamedAlsoIfTheRunHadEnded) {
  const RecordingSink good = run({"good"}, 1), sink = run({"disconnect"}, 1);
  for (std::size_t i = 0; i < sink.runs.size(); ++i) {
    const RunRecord& r = sink.runs[i];
    EXPECT_EQ(r.trajectory_hash, good.runs[i].trajectory_hash);
    if (r.scenario_name == "low") continue;
    EXPECT_EQ(r.outcome, "method_crash");
    EXPECT_EQ(r.outcome_detail,
              "closed the worker's connection to the simulator, after the end of the run");
    EXPECT_EQ(r.metrics.at("success").value, Value::of(0));
  }
}

#if !defined(SLALOM_SANITIZE)
TEST_F(CampaignTest, AMethodThatExhaustsMemoryEndsOnlyItsOwnRun) {
  const RecordingSink sink = run(ini_for({"greedy", "good"}, "memory_mb = 300"), 2);
  EXPECT_EQ(outcomes_of(sink, "greedy"), std::set<std::string>{"method_error"});
  EXPECT_EQ(outcomes_of(sink, "good"), std::set<std::string>{"success"});
}
#endif

TEST_F(CampaignTest, AMissedCycleDeadlineFollowsThePolicy) {
  const std::string limits =
      "run_wall_time = 30\n[simulation]\nstuck_time = 2\n[limits]\ncycle_deadline = 0.1\n"
      "deadline_policy = ";
  const auto outcomes = [&](const std::string& method, const std::string& policy) {
    return outcomes_of(run(ini_for({method, "good"}, limits + policy), 1), method);
  };
  using Outcomes = std::set<std::string>;
  EXPECT_EQ(outcomes("slow", "fail"), Outcomes{"method_deadline"});
  EXPECT_EQ(outcomes("hang", "fail"), Outcomes{"method_deadline"})
      << "long before the wall-clock limit";
  // Every reply after 1.5 s is late. With `stop` the robot makes no progress. With `hold` the last
  // command is kept, and the robot continues its curve until it hits a wall.
  EXPECT_EQ(outcomes("slow", "stop"), Outcomes{"stuck"});
  EXPECT_EQ(outcomes("slow", "hold"), Outcomes{"collision"});
}

/// Writes the observed end of a run to a file, since the run is executed in a worker process.
class EndWriter : public RunObserver {
 public:
  explicit EndWriter(std::string path) : path_(std::move(path)) {}
  void on_start(const NavigationTask&) override {}
  void on_cycle(const Observation&, const Command&, const mrpt::math::TPose2D&) override {
    ++cycles_;
  }
  void on_end(const SimulationResult& result) override {
    std::ofstream(path_) << to_string(result.outcome) << ' ' << result.trajectory.hash() << ' '
                         << cycles_;
  }

 private:
  std::string path_;
  int cycles_ = 0;
};

TEST_F(CampaignTest, RecordsTheSelectedRunsWithTheirOutcomes) {
  const std::string folder = testing::TempDir() + "slalom_recorded_" + std::to_string(getpid());
  std::filesystem::create_directories(folder);
  const auto path = [&folder](std::size_t scenario, const std::string& method, int repetition) {
    return folder + "/" + std::to_string(scenario) + method + std::to_string(repetition);
  };
  recorders_ = {{RecordedRuns::Failures, folder, [&path](const Scenario&, const RunSpec& spec) {
                   return std::make_unique<EndWriter>(
                       path(spec.scenario, spec.method, spec.repetition));
                 }}};
  const RecordingSink sink = run(ini_for({"crash", "nan", "good"}, "run_wall_time = 5"), 2);
  for (const RunRecord& r : sink.runs) {
    std::ifstream file(path(r.scenario_name == "high" ? 1 : 0, r.method, r.repetition));
    EXPECT_EQ(file.is_open(), r.outcome != "success") << r.method << r.scenario_name;
    if (!file.is_open()) continue;
    std::string outcome, hash;
    int cycles = 0;
    file >> outcome >> hash >> cycles;
    EXPECT_EQ(outcome, r.outcome);
    EXPECT_EQ(hash, r.trajectory_hash);
    EXPECT_EQ(cycles, 16) << "valid commands at 0, 0.1, ... 1.5 s";
  }
  std::filesystem::remove_all(folder);
}

TEST_F(CampaignTest, AMethodThatCannotBeBuiltInAWorkerFailsItsRuns) {
  int built = 0;
  registry_.add("once", [&built](const IniFile&, const std::string& section) {
    return [&built, section](const RobotModel&, const SensorModel&) -> std::unique_ptr<Method> {
      if (++built > 0) throw usage_error(section, "cannot be loaded", "a method");
      return nullptr;
    };
  });
  const IniFile ini =
      IniFile::from_text("[campaign]\nmethods = gone\n[method.gone]\nadapter = once\n");
  const RecordingSink sink = run(ini, 1);
  for (const RunRecord& r : sink.runs) {
    EXPECT_EQ(r.outcome, "method_error");
    EXPECT_NE(r.outcome_detail.find("method.gone: cannot be loaded"), std::string::npos);
  }
}

TEST_F(CampaignTest, ResultsDoNotDependOnTheNumberOfWorkersOrOtherMethods) {
  const auto values_of_good = [](const RecordingSink& sink) {
    std::vector<std::pair<std::string, std::map<std::string, Value>>> values;
    for (const RunRecord& r : sink.runs) {
      if (r.method != "good") continue;
      values.emplace_back(r.trajectory_hash, std::map<std::string, Value>());
      for (const auto& [id, value] : r.metrics) values.back().second.emplace(id, value.value);
    }
    return values;
  };
  const auto alone = values_of_good(run({"good"}, 1));
  EXPECT_EQ(alone, values_of_good(run({"good"}, 3)));
  EXPECT_EQ(alone, values_of_good(run({"crash", "good"}, 2)));
  EXPECT_EQ(alone, values_of_good(run({"rounding", "good"}, 1)));
}

TEST_F(CampaignTest, ARunDoesNotAffectTheNextOneOfItsMethod) {
  const RecordingSink good = run({"good"}, 1), sink = run({"rounding_first", "spoil"}, 1);
  ASSERT_EQ(good.runs[3].repetition, 1);
  ASSERT_EQ(sink.runs[5].method, "rounding_first");
  EXPECT_EQ(sink.runs[5].trajectory_hash, good.runs[3].trajectory_hash);
  for (const RunRecord& r : sink.runs) {
    if (r.method == "spoil") {
      EXPECT_EQ(r.outcome, "success") << r.outcome_detail;
    }
  }
}

TEST_F(CampaignTest, ARunThatLeavesAMarkOnItsProcessIsTheLastOneInIt) {
  for (const RunRecord& r : run(kMarks, 1).runs)
    EXPECT_EQ(r.outcome, "success") << r.method << ": " << r.outcome_detail;
}

TEST_F(CampaignTest, TheIdentityOfARunIsThatOfThePlan) {
  class Impostor : public TestMethod {
   public:
    Impostor(const RobotModel& robot, ManualTime& time, Campaign& campaign)
        : TestMethod("good", robot, time), campaign_(campaign) {}
    void reset(const NavigationTask& task) override {
      TestMethod::reset(task);
      campaign_.scenarios[1] = free_field("high", 8);
    }

   private:
    Campaign& campaign_;
  };
  registry_.add("impostor", [this](const IniFile&, const std::string&) {
    return [this](const RobotModel& robot, const SensorModel&) -> std::unique_ptr<Method> {
      return std::make_unique<Impostor>(robot, time_, *campaign_);
    };
  });
  const IniFile ini =
      IniFile::from_text("[campaign]\nmethods = it\n[method.it]\nadapter = impostor\n");
  const RecordingSink sink = run(ini, 1);
  EXPECT_EQ(sink.runs[0].outcome, "success");
  EXPECT_EQ(sink.runs[1].outcome, "method_crash");
  EXPECT_NE(sink.runs[1].outcome_detail.find("reply was corrupted"), std::string::npos);
  EXPECT_GT(sink.runs[1].metrics.at("path_length").value.number(), 0.05) << "from the log";
}

TEST_F(CampaignTest, ARunWhoseProcessIsKilledAgainWhenAloneIsACrashOfItsMethod) {
  const RecordingSink sink = run({"killed", "good"}, 2);
  EXPECT_EQ(outcomes_of(sink, "killed"), std::set<std::string>{"method_crash"});
  EXPECT_EQ(outcomes_of(sink, "good"), std::set<std::string>{"success"});
}

TEST_F(CampaignTest, MethodsAreDestroyedWhenTheirWorkersAreNoLongerNeeded) {
  class Counted : public TestMethod {
   public:
    Counted(const RobotModel& robot, ManualTime& destroyed)
        : TestMethod("good", robot, destroyed), destroyed_(destroyed) {}
    ~Counted() override { destroyed_.advance(1); }
    Counted(const Counted&) = delete;
    Counted& operator=(const Counted&) = delete;

   private:
    ManualTime& destroyed_;
  };
  ManualTime destroyed;  // its seconds count
  registry_.add("test", [&](const IniFile&, const std::string&) {
    return [&](const RobotModel& robot, const SensorModel&) -> std::unique_ptr<Method> {
      return std::make_unique<Counted>(robot, destroyed);
    };
  });
  run({"good", "other"}, 1);
  EXPECT_EQ(destroyed.clock()(), 2);
}

TEST_F(CampaignTest, AnUnsolvableScenarioGivesNoMetricValues) {
  const IniFile ini = ini_for({"good"});
  Primitives wall;
  wall.polygons.push_back({{{4, 0}, {5, 0}, {5, 10}, {4, 10}}});
  const Scenario walled = Scenario::continuous("walled", {0, 0, 10, 10}, wall, {1, 5, 0}, {9, 5});
  const Campaign campaign{read_campaign_options(ini), {walled}, read_methods(ini, registry_)};
  const auto progress = make_silent_progress();
  RecordingSink sink;
  run_campaign(campaign, sink, {1, *progress, nullptr});
  ASSERT_EQ(sink.runs.size(), 2U);
  EXPECT_EQ(sink.runs[0].outcome, "unsolvable_scenario");
  EXPECT_TRUE(sink.runs[0].metrics.at("success").value.is_na());
}

TEST_F(CampaignTest, AScenarioInWhichAMoverStaysAtTheGoalIsUnsolvable) {
  const IniFile ini = ini_for({"good"});
  const Scenario open = Scenario::continuous("open", {0, 0, 10, 10}, {}, {1, 5, 0}, {9, 5});
  const Scenario closed = open.with_movers({{"guard", 1, {{0, {9, 5}}}}});
  const Campaign campaign{read_campaign_options(ini), {closed}, read_methods(ini, registry_)};
  const auto progress = make_silent_progress();
  RecordingSink sink;
  run_campaign(campaign, sink, {1, *progress, nullptr});
  ASSERT_EQ(sink.runs.size(), 2U);
  EXPECT_EQ(sink.runs[0].outcome, "unsolvable_scenario");
  EXPECT_EQ(sink.runs[0].outcome_detail.find("there is no arrival among the moving obstacles"), 0U)
      << sink.runs[0].outcome_detail;
}

/// The room of the tests above with somebody who walks from the goal towards the start.
Scenario room_with(const Person& person) {
  return Scenario::continuous("room", {0, 0, 10, 10}, {}, {1, 5, 0}, {9, 5}).with_people({person});
}

TEST_F(CampaignTest, PeopleAreMetByEveryMethodAlike) {
  IniFile ini = ini_for({"good", "other"});
  ini.set("people", "notices", "0", "test");
  Campaign campaign{read_campaign_options(ini),
                    {room_with({"anna", 0.3, 1.25, {8, 5}, {{2, 5}}})},
                    read_methods(ini, registry_)};
  campaign.options.adapt_to(campaign.scenarios);
  std::vector<RunRecord> first;
  for (const int workers : {1, 2}) {
    const auto progress = make_silent_progress();
    RecordingSink sink;
    run_campaign(campaign, sink, {workers, *progress, nullptr});
    ASSERT_EQ(sink.runs.size(), 4U);
    sort_by_plan(sink.runs, campaign);
    for (const RunRecord& run : sink.runs) {
      EXPECT_EQ(run.outcome_detail.find("contact with person 'anna'"), 0U) << run.outcome_detail;
      EXPECT_EQ(run.metrics.at("mover_collision").value, Value::of(1));
      EXPECT_EQ(run.metrics.at("contact_mover").value, Value::of(0));
      EXPECT_NEAR(run.metrics.at("min_mover_clearance").value.number(), 0, 1e-6);
    }
    if (first.empty()) first = sink.runs;
    EXPECT_TRUE(std::equal(first.begin(), first.end(), sink.runs.begin(), same_run));
  }
}

TEST_F(CampaignTest, PeopleAreHinderedIfTheyNoticeTheRobot) {
  const auto run_with = [this](const std::string& notices) {
    IniFile ini = ini_for({"good"});
    ini.set("people", "notices", notices, "test");
    Campaign campaign{read_campaign_options(ini),
                      {room_with({"anna", 0.3, 1.25, {8, 5}, {{2, 5}}})},
                      read_methods(ini, registry_)};
    campaign.options.adapt_to(campaign.scenarios);
    const auto progress = make_silent_progress();
    RecordingSink sink;
    run_campaign(campaign, sink, {1, *progress, nullptr});
    return sink.runs.at(0);
  };
  const RunRecord seen = run_with("1"), unseen = run_with("0");
  EXPECT_GT(seen.metrics.at("people_hindrance").value.number(), 0);
  EXPECT_GT(seen.metrics.at("people_speed_change").value.number(), 0);
  EXPECT_EQ(unseen.metrics.at("people_hindrance").value, Value::of(0));
  EXPECT_EQ(unseen.metrics.at("people_hindered").value, Value::of(0));
  EXPECT_EQ(unseen.metrics.at("people_speed_change").value.reason(),
            "nobody who notices the robot had it in reach");
  EXPECT_EQ(unseen.metrics.at("contact_blame").value, Value::of(0));
}

TEST_F(CampaignTest, APersonWhoStaysAtTheGoalIsNoProofThatItCannotBeReached) {
  // A mover there is one, see above.
  const IniFile ini = ini_for({"good"});
  const Campaign campaign{read_campaign_options(ini),
                          {room_with({"anna", 1, 1.25, {9, 5}, {{8.9, 5}}})},
                          read_methods(ini, registry_)};
  const auto progress = make_silent_progress();
  RecordingSink sink;
  run_campaign(campaign, sink, {1, *progress, nullptr});
  ASSERT_EQ(sink.runs.size(), 2U);
  EXPECT_NE(sink.runs[0].outcome, "unsolvable_scenario");
  EXPECT_NE(sink.runs[0].outcome, "infrastructure_error");
}

TEST_F(CampaignTest, APersonWhoStartsInAWallIsAnErrorThatNamesIt) {
  const IniFile ini = ini_for({"good"});
  const Campaign campaign{read_campaign_options(ini),
                          {room_with({"anna", 0.3, 1.25, {9.8, 5}, {{2, 5}}})},
                          read_methods(ini, registry_)};
  const auto progress = make_silent_progress();
  RecordingSink sink;
  EXPECT_TRUE(
      throws_error(ErrorKind::Job, "scenario room", {"person 'anna': starts in a wall"}, [&] {
        run_campaign(campaign, sink, {1, *progress, nullptr});
      }));
}

TEST_F(CampaignTest, AMethodThatCannotBeBuiltIsReportedBeforeTheFirstRun) {
  const auto check = [this](const std::string& kind) {
    const IniFile ini = ini_for({"good", kind});
    check_methods({read_campaign_options(ini), {}, read_methods(ini, registry_)});
  };
  EXPECT_NO_THROW(check("good2"));
  const IniFile ini = ini_for({"good", "tracking", "knowing", "good2"});
  const PrivilegedMethods privileged =
      check_methods({read_campaign_options(ini), {}, read_methods(ini, registry_)});
  EXPECT_EQ(privileged.tracks, std::vector<std::string>{"tracking"});
  EXPECT_EQ(privileged.map, std::vector<std::string>{"knowing"});
  EXPECT_TRUE(throws_error(ErrorKind::Usage,
                           "method.unbuildable: ", {"unknown class", "expected a known class"},
                           [&] { check("unbuildable"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "<text>",
                           {"method.deadly", "could not be built", "signal 6"},
                           [&] { check("deadly"); }));
}

}  // namespace
}  // namespace slalom
