// SPDX-License-Identifier: BSD-3-Clause
// The protocol of the adapter with a link that is no network, and a clock that advances while the
// method waits.
#include "error_text.h"
#include "ros2_link.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

namespace slalom {
namespace {

constexpr RosTime kSecond = 1'000'000'000;

/// The network, its nodes and the wall clock.
struct Network {
  std::vector<std::string> sent;      // "transform", "scans", "barrier NODE", "clock", "goal", ...
  std::vector<RosTime> clocks, data;  // stamps
  std::deque<RosCommand> commands;    // on their way to the simulator
  std::function<void(RosTime now)> on_clock = [](RosTime) {}, on_scan = on_clock;
  std::function<void()> on_wait = [] {}, on_parameter = on_wait;
  std::vector<std::string> missing;
  std::string missing_parameter;
  mrpt::math::TPose2D goal, pose;
  std::vector<std::string> publishers = {"/a"};
  bool deaf = false;  // the nodes do not reply to barriers
  double time = 0;    // s
  int links = 0;

  void answer(double v, RosTime stamp = 0) {
    commands.push_back({{v, 0.1, 0}, stamp == 0 ? std::nullopt : std::optional<RosTime>(stamp)});
  }
};

class FakeLink : public RosLink {
 public:
  explicit FakeLink(Network& network) : network_(network) { ++network.links; }
  std::vector<std::string> missing() override { return network_.missing; }
  std::vector<std::string> publishers() override { return network_.publishers; }
  std::string set_parameter(std::size_t parameter, double) override {
    network_.sent.push_back("parameter " + std::to_string(parameter));
    network_.on_parameter();
    return network_.missing_parameter;
  }
  void send_goal(const mrpt::math::TPose2D& goal, RosTime) override {
    network_.sent.push_back("goal");
    network_.goal = goal;
  }
  void send_map(const KnownMap&, RosTime) override { network_.sent.push_back("map"); }
  void await_map() override { network_.sent.push_back("map is there"); }
  void send_transform(const Observation& observation, RosTime) override {
    network_.sent.push_back("transform");
    network_.pose = observation.odometry;
  }
  void send_odometry(const Observation&, RosTime) override { network_.sent.push_back("odometry"); }
  void send_scans(const Observation&, RosTime scan_time) override {
    network_.sent.push_back("scans");
    network_.data.push_back(scan_time);
    network_.on_scan(scan_time);
  }
  void send_clock(RosTime now) override {
    network_.sent.push_back("clock");
    network_.clocks.push_back(now);
    network_.on_clock(now);
  }
  bool pass_barrier(std::size_t node, double seconds) override {
    network_.sent.push_back("barrier " + std::to_string(node));
    if (network_.deaf) network_.time += seconds;
    return !network_.deaf;
  }
  std::optional<RosCommand> take_command() override {
    if (network_.commands.empty()) return std::nullopt;
    const RosCommand command = network_.commands.front();
    network_.commands.pop_front();
    return command;
  }
  void wait(double seconds) override {
    network_.time += seconds;
    network_.on_wait();
  }

 private:
  Network& network_;
};

/// A method on the network, and its runs cycle by cycle.
class Ros2MethodTest : public testing::Test {
 protected:
  Ros2MethodTest() {
    network_.on_clock = [this](RosTime now) { network_.answer(0.5, now); };
    scan_.resizeScan(3);
    task_.control_period = 0.1;
    task_.goal = {4, 0};
  }

  void make() {
    method_ = make_ros2_method(
        options_, robot_, SensorModel(), [this] { return network_.time; },
        [this](const Ros2Options&, int, const SensorModel&) {
          return std::make_unique<FakeLink>(network_);
        });
  }
  void begin() {
    if (!method_) make();
    method_->reset(task_);
    cycle_ = 0;
  }
  void settle() {
    Observation start;
    start.odometry = task_.start;
    start.scan = &scan_;
    method_->settle(start);
  }
  Command step() {
    Observation observation;
    observation.time = 0.1 * cycle_++;
    observation.scan = &scan_;
    return method_->step(observation);
  }
  double figure(const std::string& id) const { return method_->run_figures().at(id); }

  Network network_;
  Ros2Options options_;
  RobotModel robot_;
  NavigationTask task_;
  mrpt::obs::CObservation2DRangeScan scan_;
  std::unique_ptr<Method> method_;
  int cycle_ = 0;
};

TEST_F(Ros2MethodTest, ACycleAsksEachNodeTwiceAfterEachTopicThenAdvancesTheClock) {
  options_.barrier = "planner, /controller";
  begin();
  step();
  network_.sent.clear();
  step();
  EXPECT_EQ(network_.sent,
            (std::vector<std::string>{"transform", "barrier 0", "barrier 0", "barrier 1",
                                      "barrier 1", "odometry", "barrier 0", "barrier 0",
                                      "barrier 1", "barrier 1", "scans", "barrier 0", "barrier 0",
                                      "barrier 1", "barrier 1", "clock"}));
  options_.name_space = "robot";
  EXPECT_EQ(barrier_nodes(options_), (std::vector<std::string>{"/robot/planner", "/controller"}));
}

TEST_F(Ros2MethodTest, AGoalWithoutAHeadingHasTheDirectionFromTheStart) {
  task_.start = {1, 0, 0.5};
  task_.goal = {1, 3};
  begin();
  step();
  EXPECT_DOUBLE_EQ(network_.goal.phi, M_PI / 2);
  task_.goal_heading = -0.25;
  begin();
  step();
  EXPECT_EQ(network_.goal.phi, -0.25);
}

TEST_F(Ros2MethodTest, TheGoalAndTheMapAreSentBeforeTheRobotRestsForASecond) {
  options_.map = Ros2Map::Known;
  const std::vector<std::uint8_t> cells(4);
  const KnownMap map = {0.05, {0, 0}, 2, 2, &cells};
  task_.map = &map;
  begin();
  EXPECT_EQ(network_.sent, (std::vector<std::string>{"map"}));
  EXPECT_TRUE(method_->uses_map());
  step();
  EXPECT_EQ(network_.sent[1], "map is there");
  EXPECT_EQ(network_.sent[2], "goal");
  EXPECT_EQ(network_.data.size(), 11U);  // ten of the rest, and the first of the run
  EXPECT_EQ(network_.data.back() - network_.data.front(), kSecond);
}

TEST_F(Ros2MethodTest, TheClockOnlyAdvancesInEqualStepsAndOverRuns) {
  options_.clock_step = 0.02;
  options_.commands_per_cycle = 5;
  make();
  for (int run = 0; run < 3; ++run) {
    begin();
    for (int i = 0; i < 7; ++i) step();
  }
  int jumps = 0;
  for (std::size_t i = 1; i < network_.clocks.size(); ++i) {
    const RosTime step = network_.clocks[i] - network_.clocks[i - 1];
    EXPECT_GT(step, 0);
    if (step != kSecond / 50) ++jumps;
  }
  EXPECT_EQ(jumps, 2);  // between the runs
  EXPECT_EQ(network_.data.front() % kSecond, 0);
}

TEST_F(Ros2MethodTest, TheRestGoesOnUntilTheNodesAnswerEachObservationOfABlock) {
  int clocks = 0;
  network_.on_clock = [&](RosTime now) {
    if (++clocks > 13) network_.answer(0.5, now);  // the node misses the first messages
  };
  begin();
  step();
  EXPECT_EQ(network_.data.size(), 31U);  // blocks of 10 with 0, 7 and 10 answers
  EXPECT_EQ(figure("commands_missing"), 0);
  EXPECT_EQ(figure("commands_late"), 0);
}

TEST_F(Ros2MethodTest, NodesThatNeverCommandEndTheRunAfterTheStartupTime) {
  network_.on_clock = [](RosTime) {};
  begin();
  EXPECT_THROW(step(), MethodTimeout);
  EXPECT_NEAR(network_.time, options_.startup_time, 1);
  // Nodes that were starting have read it at some time.
  const auto goals = std::count(network_.sent.begin(), network_.sent.end(), "goal");
  EXPECT_NEAR(static_cast<double>(goals), options_.startup_time, 2);
}

TEST_F(Ros2MethodTest, NodesThatAreMissingFindARobotThatRestsAtTheStart) {
  task_.start = {3, 2, 0.5};
  network_.missing = {"reader of /scan"};
  options_.map = Ros2Map::Known;
  const std::vector<std::uint8_t> cells(4);
  const KnownMap map = {0.05, {0, 0}, 2, 2, &cells};
  task_.map = &map;
  std::size_t scans_when_heard = 0;
  network_.on_wait = [&] {  // it reads scans as soon as it has a transform
    if (network_.pose == task_.start && scans_when_heard == 0) {
      network_.missing.clear();
      scans_when_heard = network_.data.size();
    }
  };
  begin();
  settle();
  network_.sent.resize(7);
  EXPECT_EQ(network_.sent, (std::vector<std::string>{"map", "transform", "odometry", "scans",
                                                     "clock", "map is there", "goal"}));
  EXPECT_EQ(step().v, 0.5);
}

TEST_F(Ros2MethodTest, ACheckShowsNodesARobotInAnEmptyWorld) {
  options_.launch = "exec sleep 1000";
  options_.map = Ros2Map::Known;
  network_.missing = {"reader of /scan"};
  network_.on_scan = [&](RosTime) { network_.missing.clear(); };
  make();
  method_->check();
  EXPECT_EQ(network_.sent,
            (std::vector<std::string>{"map", "transform", "odometry", "scans", "clock"}));
  EXPECT_EQ(network_.pose, mrpt::math::TPose2D());
  network_.publishers = {"/a", "/b"};
  make();
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "ros2_method.publishers",
                           {"/cmd_vel has 2 publishers (/a, /b)"}, [&] { method_->check(); }));
  network_.missing = {"publisher of /cmd_vel"};
  network_.on_scan = [](RosTime) {};
  make();
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "ros2_method.launch", {"no publisher of /cmd_vel"},
                           [&] { method_->check(); }));
}

TEST_F(Ros2MethodTest, ReadersThatComeAndGoAreWaitedFor) {
  options_.parameter_set = "a.speed=1";
  int looks = 0;
  network_.missing = {"reader of /scan"};
  network_.on_wait = [&] { network_.missing = {}; };
  network_.on_parameter = [&] {  // it is configured again by a parameter
    if (++looks == 1) network_.missing = {"reader of /scan"};
  };
  begin();
  settle();
  EXPECT_TRUE(network_.missing.empty());
  EXPECT_EQ(looks, 2);
}

TEST_F(Ros2MethodTest, SimulatedTimePassesWithoutJumpsWhileNodesStart) {
  options_.startup_time = 20;
  options_.launch = "exec sleep 1000";
  for (const Ros2Mode mode : {Ros2Mode::Lockstep, Ros2Mode::Realtime}) {
    options_.mode = mode;
    make();
    network_.clocks.clear();
    network_.missing = {"reader of /scan"};
    begin();
    EXPECT_THROW(settle(), MethodTimeout);
    const std::vector<RosTime>& clocks = network_.clocks;
    ASSERT_GT(clocks.size(), 50U);
    EXPECT_LE(clocks.front(), kSecond);
    for (std::size_t i = 1; i < clocks.size(); ++i) {
      EXPECT_GT(clocks[i], clocks[i - 1]);
      EXPECT_LE(clocks[i] - clocks[i - 1], kSecond);
      if (mode == Ros2Mode::Lockstep) {
        EXPECT_EQ(clocks[i] % kSecond, 0) << "timers keep their phase";
      }
    }
    if (mode == Ros2Mode::Realtime) {
      EXPECT_NEAR(static_cast<double>(clocks.back()), 20e9, 4e9) << "as the wall clock";
    }
  }
}

TEST_F(Ros2MethodTest, ANodeThatNeedsLongerThanTheFirstWaitsIsReadyWithoutLateCommands) {
  for (const double computing : {0.03, 0.1, 0.4}) {
    SCOPED_TRACE(computing);
    std::deque<RosTime> scans;  // of the node
    double free_at = 0;
    network_.on_clock = [&](RosTime now) {
      if (scans.empty()) free_at = network_.time + computing;
      scans.push_back(now);
    };
    network_.on_wait = [&] {
      for (; !scans.empty() && network_.time >= free_at - 1e-9; free_at += computing) {
        network_.answer(0.5, scans.front());
        scans.pop_front();
      }
    };
    make();
    begin();
    for (int i = 0; i < 10; ++i) EXPECT_EQ(step().v, 0.5);
    for (const auto& [id, count] : method_->run_figures()) EXPECT_EQ(count, 0) << id;
  }
}

TEST_F(Ros2MethodTest, InRealTimeAnyCommandSinceTheGoalEndsTheRest) {
  options_.mode = Ros2Mode::Realtime;
  task_.control_period = 0.05;
  for (const double phase : {0.001, 0.019, 0.021, 0.03, 0.049}) {
    SCOPED_TRACE(phase);
    double next = network_.time + phase;  // of a node at 20 Hz with its own clock
    network_.on_clock = [](RosTime) {};
    network_.on_wait = [&] {
      for (; network_.time >= next; next += 0.05) network_.answer(0.5);
    };
    make();
    const double before = network_.time;
    begin();
    step();
    EXPECT_LE(network_.time - before, 1.2);
    EXPECT_EQ(figure("commands_missing"), 0);
  }
}

TEST_F(Ros2MethodTest, NodesThatFallSilentBetweenRunsEndTheNextOneAtTheDeadline) {
  for (const Ros2Mode mode : {Ros2Mode::Lockstep, Ros2Mode::Realtime}) {
    options_.mode = mode;
    make();
    begin();
    step();
    const auto answer = std::exchange(network_.on_clock, [](RosTime) {});
    begin();
    const double before = network_.time;
    EXPECT_THROW(settle(), MethodTimeout);
    EXPECT_NEAR(network_.time - before, options_.deadline, 0.2);
    network_.on_clock = answer;
  }
}

TEST_F(Ros2MethodTest, NodesThatAnswerAPartOfEachObservationEndTheRun) {
  network_.on_clock = [](RosTime) {};
  for (const double patience : {0.0, 0.2}) {
    options_.commands_per_cycle = 2;
    options_.patience = patience;
    network_.on_scan = [this](RosTime now) {
      network_.answer(0.5, now);
      network_.answer(0.5, now);
    };
    make();
    begin();
    step();
    network_.on_scan = [this](RosTime now) { network_.answer(0.5, now); };
    begin();
    const double before = network_.time;
    EXPECT_THROW(settle(), MethodTimeout);
    EXPECT_GE(network_.time - before, options_.deadline);
    EXPECT_LE(network_.time - before, options_.startup_time + options_.deadline);
  }
}

TEST_F(Ros2MethodTest, TheRestGoesOnWhileAReaderIsGone) {
  options_.mode = Ros2Mode::Realtime;
  begin();
  const auto answer = network_.on_clock;
  network_.on_clock = [&](RosTime now) {
    network_.missing = {"reader of /scan"};  // until it is active
    if (network_.time > 5) network_.missing.clear();
    answer(now);
  };
  settle();
  EXPECT_NEAR(network_.time, 5, 0.3);
}

TEST_F(Ros2MethodTest, TheRestIsNoPartOfTheFirstCycle) {
  options_.mode = Ros2Mode::Realtime;
  begin();
  settle();
  const double before = network_.time;
  step();
  EXPECT_NEAR(network_.time - before, task_.control_period, 1e-9);
  EXPECT_TRUE(method_->is_paced());
}

TEST_F(Ros2MethodTest, InRealTimeTheRobotStopsWithoutCommandsUntilThereIsOne) {
  options_.mode = Ros2Mode::Realtime;
  begin();
  step();
  network_.on_clock = [](RosTime) {};
  std::vector<double> speeds;
  for (int i = 0; i < 8; ++i) speeds.push_back(step().v);
  EXPECT_EQ(speeds, (std::vector<double>{0.5, 0.5, 0.5, 0.5, 0, 0, 0, 0}));  // 0.5 s of 0.1 s
  EXPECT_EQ(figure("commands_expired"), 4);
  EXPECT_EQ(figure("commands_missing"), 8);
  network_.on_clock = [this](RosTime now) { network_.answer(0.3, now); };
  EXPECT_EQ(step().v, 0.3);
  options_.command_timeout = 0;  // never
  make();
  begin();
  step();
  network_.on_clock = [](RosTime) {};
  for (int i = 0; i < 20; ++i) EXPECT_EQ(step().v, 0.3);
}

TEST_F(Ros2MethodTest, NodesThatServedNoRunAreNotLaunchedAgain) {
  options_.launch = "exec sleep 1000";
  options_.restart = Ros2Restart::Run;
  make();
  for (const int expected : {1, 2, 3}) {
    begin();
    step();
    EXPECT_EQ(network_.links, expected);
  }
}

TEST_F(Ros2MethodTest, TimeBeginsAnewForNewNodes) {
  options_.launch = "exec sleep 1000";
  options_.restart = Ros2Restart::Run;
  std::vector<RosTime> first;
  for (int run = 0; run < 3; ++run) {
    network_.clocks.clear();
    begin();
    step();
    if (run == 0) first = network_.clocks;
    EXPECT_EQ(network_.clocks, first);
  }
}

TEST_F(Ros2MethodTest, TheMessageAboutPublishersNamesTheirNodes) {
  network_.publishers = {"/smoother", "/behaviors"};
  try {
    begin();
    settle();
    FAIL();
  } catch (const MethodError& error) {
    EXPECT_TRUE(mentions(error.what(),
                         {"/cmd_vel has 2 publishers (/smoother, /behaviors)", "publishers = 1"}));
  }
}

TEST_F(Ros2MethodTest, ACommandFromAnOlderScanIsCountedAsStale) {
  begin();
  step();
  network_.on_clock = [this](RosTime now) { network_.answer(0.5, now - kSecond / 10); };
  step();
  step();
  EXPECT_EQ(figure("commands_stale"), 2);
  network_.on_clock = [this](RosTime) { network_.answer(0.5); };  // Twist has no stamp
  step();
  EXPECT_EQ(figure("commands_stale"), 2);
}

TEST_F(Ros2MethodTest, ASecondCommandOfACycleIsCountedAsLate) {
  begin();
  step();
  network_.on_clock = [this](RosTime now) {
    network_.answer(0.5, now);
    network_.answer(0.6, now);
  };
  EXPECT_EQ(step().v, 0.5);
  EXPECT_EQ(figure("commands_late"), 0);
  step();
  step();
  EXPECT_EQ(figure("commands_late"), 2);
}

TEST_F(Ros2MethodTest, ACommandBeyondTheLimitsOfTheRobotIsCounted) {
  begin();
  step();
  EXPECT_EQ(figure("commands_limited"), 0);
  network_.on_clock = [this](RosTime now) { network_.answer(-0.2, now); };
  EXPECT_EQ(step().v, 0) << "it never moves backwards";
  network_.on_clock = [this](RosTime now) { network_.answer(0.5, now); };
  EXPECT_EQ(step().v, 0.5);
  EXPECT_EQ(figure("commands_limited"), 1);
}

TEST_F(Ros2MethodTest, TheLastOfTheExpectedCommandsCounts) {
  options_.commands_per_cycle = 2;
  network_.on_clock = [this](RosTime now) {
    network_.answer(0.5, now);
    network_.answer(0.6, now);
  };
  begin();
  EXPECT_EQ(step().v, 0.6);
  EXPECT_EQ(step().v, 0.6);
  EXPECT_EQ(figure("commands_late"), 0);
}

TEST_F(Ros2MethodTest, MoreCommandsThanExpectedInTheRestEndTheRun) {
  network_.on_clock = [this](RosTime now) {
    network_.answer(0.5, now);
    network_.answer(0.6, now);
  };
  begin();
  EXPECT_THROW(step(), MethodError);
}

TEST_F(Ros2MethodTest, WithPatienceTheLastCommandIsKeptAndCountedAsMissing) {
  options_.patience = 0.2;
  begin();
  EXPECT_EQ(step().v, 0.5);
  network_.on_clock = [](RosTime) {};
  const double before = network_.time;
  EXPECT_EQ(step().v, 0.5);
  EXPECT_NEAR(network_.time - before, 0.2, 1e-9);
  EXPECT_EQ(figure("commands_missing"), 1);
  EXPECT_THROW(for (int i = 0; i < 100; ++i) step(), MethodTimeout);
  EXPECT_NEAR(network_.time - before, options_.deadline, 0.2 + 1e-9);
}

TEST_F(Ros2MethodTest, WithoutPatienceASilentNodeEndsTheRunAtTheDeadline) {
  begin();
  step();
  network_.on_clock = [](RosTime) {};
  const double before = network_.time;
  EXPECT_THROW(step(), MethodTimeout);
  EXPECT_NEAR(network_.time - before, options_.deadline, 0.1);
}

TEST_F(Ros2MethodTest, ATimeThatIsLostOnItsWayIsSentAgain) {
  begin();
  step();
  bool is_lost = true;
  network_.on_clock = [&](RosTime now) {
    if (!is_lost) network_.answer(0.25, now);
    is_lost = false;
  };
  network_.clocks.clear();
  EXPECT_EQ(step().v, 0.25);
  ASSERT_EQ(network_.clocks.size(), 2U);
  EXPECT_EQ(network_.clocks[0], network_.clocks[1]);
  EXPECT_EQ(figure("commands_missing"), 0);
}

TEST_F(Ros2MethodTest, ANodeThatDoesNotReplyToTheBarrierEndsTheRunAtTheDeadline) {
  options_.barrier = "planner";
  begin();
  step();
  network_.deaf = true;
  EXPECT_THROW(step(), MethodTimeout);
}

TEST_F(Ros2MethodTest, VelocitiesBeyondTheLimitsBecomeTheNearestOnes) {
  network_.on_clock = [this](RosTime) { network_.commands.push_back({{-3, 9, 1}, std::nullopt}); };
  begin();
  const Command command = step();
  EXPECT_EQ(command.v, 0);  // forward only
  EXPECT_EQ(command.w, robot_.max_w);
  EXPECT_EQ(command.vy, 0);
}

TEST_F(Ros2MethodTest, ASecondPublisherOfCommandsEndsTheRun) {
  begin();
  step();
  network_.publishers = {"/a", "/b"};
  network_.on_clock = [](RosTime) {};
  EXPECT_THROW(step(), MethodError);
  begin();
  EXPECT_THROW(step(), MethodError);
  network_.publishers = {"/a"};
  network_.on_clock = [this](RosTime) { network_.answer(0.5); };
  begin();
  EXPECT_EQ(step().v, 0.5);
}

TEST_F(Ros2MethodTest, NodesThatAreGoneEndTheRunAtOnce) {
  begin();
  step();
  network_.publishers = {};
  network_.on_clock = [](RosTime) {};
  const double before = network_.time;
  EXPECT_THROW(step(), MethodError);
  EXPECT_EQ(network_.time, before);
}

TEST_F(Ros2MethodTest, InRealTimeTheLatestCommandOfThePeriodCounts) {
  options_.mode = Ros2Mode::Realtime;
  begin();
  step();
  network_.on_clock = [this](RosTime now) {
    network_.answer(0.5, now);
    network_.answer(0.6, now);
  };
  const double before = network_.time;
  EXPECT_EQ(step().v, 0.6);
  EXPECT_NEAR(network_.time - before, 0.1, 1e-9);
  network_.on_clock = [](RosTime) {};
  EXPECT_EQ(step().v, 0.6);
  EXPECT_NEAR(network_.time - before, 0.2, 1e-9);
  EXPECT_EQ(figure("commands_missing"), 1);
}

TEST_F(Ros2MethodTest, ParametersAreSetWhenTheNodesAreThereAndWaitedForUntilTheStartupTime) {
  options_.parameter_set = "a.speed=1; a.FollowPath.gain=2";
  begin();
  settle();
  network_.sent.resize(3);
  EXPECT_EQ(network_.sent, (std::vector<std::string>{"parameter 0", "parameter 1", "goal"}));
  method_.reset();
  network_.missing_parameter = "parameter speed of the node /a";
  try {
    begin();
    settle();
    FAIL();
  } catch (const NodeParameterError& error) {
    EXPECT_TRUE(mentions(error.what(), {"no parameter speed of the node /a after 30 s"}));
  }
  EXPECT_GE(network_.time, options_.startup_time);
}

TEST(Ros2Options, ParametersOfNodesBecomeAFileOfRos) {
  Ros2Options options;
  options.name_space = "robot";
  options.parameter_set = "b.FollowPath.gain=0.5; /a.on=true; b.name=it's; b.count = 3";
  EXPECT_EQ(parameter_file_text(node_parameters(options)),
            "/a:\n  ros__parameters:\n    on: true\n"
            "/robot/b:\n  ros__parameters:\n    FollowPath.gain: 0.5\n    name: 'it''s'\n"
            "    count: 3\n");
}

TEST(Ros2Options, TheValueOfAParameterIsThatOfItsAssignment) {
  const IniFile ini = IniFile::from_text("[method.a]\nparameter_set = n.x=1; n.y = 2\n");
  EXPECT_EQ(ros2_parameter_value(ini, "method.a", "n.y"), "2");
  EXPECT_EQ(ros2_parameter_value(ini, "method.a", "n.z"), std::nullopt);
  EXPECT_EQ(ros2_parameter_value(ini, "method.b", "n.x"), std::nullopt);
}

TEST(Ros2Options, InvalidNamesAndCombinationsAreRefused) {
  const auto refused = [](const std::string& keys, const std::string& where,
                          std::initializer_list<std::string> words) {
    const IniFile ini = IniFile::from_text("[method.a]\nadapter = ros2\n" + keys, "my.ini");
    return throws_error(ErrorKind::Usage, "my.ini:3: [method.a] " + where, words,
                        [&] { read_ros2_method(ini, "method.a"); });
  };
  EXPECT_TRUE(refused("command = cmd vel\n", "command", {"invalid name 'cmd vel'"}));
  EXPECT_TRUE(refused("barrier = a, 2b\n", "barrier", {"invalid name '2b'"}));
  EXPECT_TRUE(refused("scan = /scan/\n", "scan", {"invalid name '/scan/'"}));
  EXPECT_TRUE(refused("parameter_set = a.x=1; speed=2\n", "parameter_set",
                      {"malformed assignment 'speed=2'", "NODE.NAME=VALUE; ..."}));
  EXPECT_TRUE(refused("parameter_set = a-b.x=1\n", "parameter_set", {"invalid name '/a-b'"}));
  EXPECT_TRUE(refused("domain = 0\n", "domain", {"in [1, 101]"}));
  EXPECT_TRUE(refused("mode = fast\n", "mode", {"lockstep, realtime"}));
  EXPECT_TRUE(refused("barrier = a\nmode = realtime\n", "barrier", {"mode = lockstep"}));
  EXPECT_TRUE(refused("restart = run\n", "restart", {"a command line in launch"}));
  EXPECT_TRUE(refused("topic = /x\n", "topic", {"unknown key"}));
}

}  // namespace
}  // namespace slalom
