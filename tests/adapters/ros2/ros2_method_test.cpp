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
  std::vector<std::string> sent;      // "data", "barrier NODE", "clock", "goal", "map"
  std::vector<RosTime> clocks, data;  // stamps
  std::deque<RosCommand> commands;    // on their way to the simulator
  std::function<void(RosTime now)> on_clock = [](RosTime) {};
  std::vector<std::string> missing;
  std::string missing_parameter;
  mrpt::math::TPose2D goal;
  int publishers = 1;
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
  int publishers() override { return network_.publishers; }
  std::string set_parameter(std::size_t parameter, double) override {
    network_.sent.push_back("parameter " + std::to_string(parameter));
    return network_.missing_parameter;
  }
  void send_goal(const mrpt::math::TPose2D& goal, RosTime) override {
    network_.sent.push_back("goal");
    network_.goal = goal;
  }
  void send_map(const KnownMap&, RosTime) override { network_.sent.push_back("map"); }
  void send_observation(const Observation&, RosTime now, RosTime) override {
    network_.sent.push_back("data");
    network_.data.push_back(now);
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
  void wait(double seconds) override { network_.time += seconds; }

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

TEST_F(Ros2MethodTest, ACycleSendsTheDataThenAsksEachNodeTwiceThenAdvancesTheClock) {
  options_.barrier = "planner, /controller, planner";
  begin();
  step();
  network_.sent.clear();
  step();
  EXPECT_EQ(network_.sent,
            (std::vector<std::string>{"data", "barrier 0", "barrier 0", "barrier 1", "barrier 1",
                                      "barrier 2", "barrier 2", "clock"}));
  options_.name_space = "robot";
  EXPECT_EQ(barrier_nodes(options_),
            (std::vector<std::string>{"/robot/planner", "/controller", "/robot/planner"}));
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
  EXPECT_EQ(network_.sent, (std::vector<std::string>{"goal", "map"}));
  EXPECT_TRUE(method_->uses_map());
  step();
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
  network_.publishers = 2;
  network_.on_clock = [](RosTime) {};
  EXPECT_THROW(step(), MethodError);
  EXPECT_THROW(begin(), MethodError);
  network_.publishers = 1;
  network_.on_clock = [this](RosTime) { network_.answer(0.5); };
  begin();
  EXPECT_EQ(step().v, 0.5);
}

TEST_F(Ros2MethodTest, NodesThatAreGoneEndTheRunAtOnce) {
  begin();
  step();
  network_.publishers = 0;
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
  EXPECT_EQ(network_.sent, (std::vector<std::string>{"parameter 0", "parameter 1", "goal"}));
  method_.reset();
  network_.missing_parameter = "parameter speed of the node /a";
  try {
    begin();
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
