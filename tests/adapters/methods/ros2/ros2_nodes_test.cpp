// SPDX-License-Identifier: BSD-3-Clause
// Nodes over DDS, in a private network with a second interface where permitted.
#include "error_text.h"
#include "hurrying_clock.h"
#include "navigating_node.h"
#include "places.h"
#include "private_network.h"
#include "steering.h"
#include "temporary_folder.h"

#include <slalom/core/read_file.h>
#include <slalom/methods/external_process.h>
#include <slalom/ros2/ros2_method.h>
#include <slalom/simulation/simulate.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace slalom {
namespace {

const std::string kDescribedPeer = kPrograms + "/ros2_described_peer";
#ifdef WITH_FAST_PEER
const std::string kFastPeer = kPrograms + "/ros2_fast_peer";
#else
const std::string kFastPeer;
#endif

/// The law of the nodes, in this process; `turn` (rad/m) is that of the measured velocity.
class SteeringMethod : public Method {
 public:
  explicit SteeringMethod(double turn = 0) : turn_(turn) {}
  void reset(const NavigationTask&) override {}
  Command step(const Observation& observation) override {
    const auto& scan = observation.lasers.empty() ? *observation.scan : *observation.lasers[0];
    const std::size_t rays = scan.getScanSize();
    const double aperture = SensorModel().aperture();
    const Steering steering = steer(&scan.getScanRange(0), rays, static_cast<float>(-aperture / 2),
                                    static_cast<float>(aperture / static_cast<double>(rays - 1)));
    return {steering.v, steering.w + turn_ * observation.v};
  }

 private:
  double turn_;
};

class Ros2NodesTest : public testing::Test {
 protected:
  /// Participants that are bound to the loopback device are only found where there is no other.
  static void SetUpTestSuite() {
    if (enter_private_network() &&
        std::system("ip link add v0 type veth peer name v1 && ip addr add 10.9.0.1/24 dev v0 && "
                    "ip link set v0 up && ip link set v1 up") != 0)
      std::puts("There is no second network interface.");
  }

  /// A method by these keys. A slow machine does not reach its limits.
  static std::unique_ptr<Method> make(const std::string& keys,
                                      const WallClock& clock = steady_seconds,
                                      const SensorModel& sensor = {}) {
    const IniFile ini = IniFile::from_text(
        "[method.a]\nadapter = ros2\nstartup_time = 100\ndeadline = 100\n" + keys, "my.ini");
    return read_ros2_method(ini, "method.a", clock)(RobotModel(), sensor);
  }
  static std::unique_ptr<Method> launch(const std::string& command, const std::string& keys = "",
                                        const WallClock& clock = steady_seconds) {
    return make("launch = exec " + command + "\n" + keys, clock);
  }

  /// Columns between start and goal.
  static const World& columns() {
    static const World world = [] {
      Primitives obstacles;
      for (int i = 0; i < 5; ++i)
        obstacles.discs.push_back({{2.0 + i, i % 2 == 0 ? 1.7 : 2.6}, 0.3});
      return World(
          Scenario::continuous("columns", {0, 0, 8, 4}, obstacles, {0.7, 2, 0.2}, {7.3, 2}), 0.05);
    }();
    return world;
  }
  /// Its goal is where nodes have their fault.
  static const World& faulty() {
    static const World world(columns().scenario().with_start_goal({0.7, 2, 0.2}, {7.3, 3.5}), 0.05);
    return world;
  }

  static SimulationResult run(Method& method, const World& world = columns(),
                              const SensorModel& sensor = {}, double max_time = 12) {
    RunSetup setup;
    setup.sensor = sensor;
    setup.simulation.max_time = max_time;
    return simulate(world, setup, 1, method);
  }
  static std::string expected_hash(double turn = 0) {
    SteeringMethod local(turn);
    const SimulationResult result = run(local);
    EXPECT_GT(result.trajectory.samples.size(), 50U) << result.detail;
    return result.trajectory.hash();
  }

  /// A run of a second, whose cycles follow the wall clock.
  static void expect_second_in_real_time(Method& method) {
    const SimulationResult result = run(method, columns(), {}, 1);
    EXPECT_EQ(result.outcome, Outcome::Timeout) << result.detail;
    EXPECT_TRUE(result.cycle_seconds.empty());
  }

  /// Two runs have the hash of the law in this process, and all commands are of their cycle.
  static void expect_equal_runs(Method& method) {
    for (int i = 0; i < 2; ++i) {
      const SimulationResult result = run(method);
      EXPECT_EQ(result.trajectory.hash(), expected_hash()) << result.detail;
      for (const auto& [id, count] : method.run_figures()) EXPECT_EQ(count, 0) << id;
    }
  }
};

TEST_F(Ros2NodesTest, NodesOfBothMiddlewaresGiveTheTrajectoryOfTheirLawInThisProcess) {
  for (const std::string& peer : {kCyclonePeer, kDescribedPeer, kFastPeer})
    for (const std::string type : {"", " --stamped"}) {
      if (peer.empty()) continue;  // there is no Fast DDS 2
      SCOPED_TRACE(peer + type);
      expect_equal_runs(*launch(peer + type));
    }
}

TEST_F(Ros2NodesTest, BehindTheBarrierATimerNeverCommandsFromAnOlderScan) {
  for (const std::string& peer : {kCyclonePeer, kFastPeer}) {
    if (peer.empty()) continue;
    SCOPED_TRACE(peer);
    const auto method = launch(peer + " --stamped --timer", "barrier = method\n");
    for (std::size_t cycles = 0; cycles < 10'000;) {
      const SimulationResult result = run(*method);
      ASSERT_EQ(result.trajectory.hash(), expected_hash()) << result.detail;
      for (const auto& [id, count] : method->run_figures()) ASSERT_EQ(count, 0) << id;
      cycles += result.trajectory.samples.size();
    }
  }
}

TEST_F(Ros2NodesTest, BehindTheBarrierANodeHasTheOdometryOfItsScan) {
  const auto method = launch(kCyclonePeer + " --odometry", "barrier = method\n");
  const std::string expected = expected_hash(NavigatingNode::kTurn);
  EXPECT_NE(expected, expected_hash());
  for (int i = 0; i < 10; ++i) ASSERT_EQ(run(*method).trajectory.hash(), expected);
}

TEST_F(Ros2NodesTest, NodesOfNav2sLayoutsStartAndAreCountedByTheirNames) {
  const std::string keys = "restart = run\npublishers = 2\n";
  for (const std::string layout : {"humble", "jazzy"}) {
    SCOPED_TRACE(layout);
    expect_equal_runs(*launch(kCyclonePeer + " " + layout, keys));
    expect_second_in_real_time(*launch(kCyclonePeer + " " + layout, keys + "mode = realtime\n"));
  }
  if (!kFastPeer.empty()) expect_equal_runs(*launch(kFastPeer + " humble"));
  const auto humble = launch(kCyclonePeer + " humble");
  EXPECT_TRUE(mentions(run(*humble).detail,
                       {"/cmd_vel has 2 publishers (/behavior_server, /velocity_smoother), more "
                        "than publishers = 1"}));
  expect_equal_runs(*launch(kCyclonePeer + " jazzy"));
}

TEST_F(Ros2NodesTest, ANodeThatThinksForHalfACycleIsHeardInEveryMode) {
  const auto method = launch(kCyclonePeer + " --stamped thinks");
  EXPECT_EQ(run(*method).trajectory.hash(), expected_hash());
  for (const auto& [id, count] : method->run_figures()) EXPECT_EQ(count, 0) << id;
  expect_second_in_real_time(*launch(kCyclonePeer + " thinks", "mode = realtime\n"));
}

TEST_F(Ros2NodesTest, ANodeThatIsNamedTwiceIsAskedTwice) {
  for (const std::string& peer : {kCyclonePeer, kFastPeer})
    if (!peer.empty())
      expect_equal_runs(*launch(peer + " --stamped --timer", "barrier = method, method\n"));
}

TEST_F(Ros2NodesTest, ANodeGetsTheScanOfALaserAndItsPoseOnTheRobot) {
  SensorModel sensor;
  sensor.lasers.resize(1);
  sensor.lasers[0].name = "front";
  sensor.lasers[0].x = 0.1;
  sensor.lasers[0].y = -0.05;
  sensor.lasers[0].yaw = 0.4;
  sensor.lasers[0].upside_down = true;
  SteeringMethod local;
  const std::string expected = run(local, columns(), sensor).trajectory.hash();
  EXPECT_NE(expected, expected_hash());
  const TemporaryFolder folder;
  const std::string path = folder / "transforms";
  const auto method = make("launch = exec env TRANSFORMS_FILE=" + path + " " + kCyclonePeer + "\n",
                           steady_seconds, sensor);
  do {
    EXPECT_EQ(run(*method, columns(), sensor).trajectory.hash(), expected);
  } while (!std::filesystem::exists(path) || std::filesystem::file_size(path) == 0);
  // A turn of pi about x, then of 0.4 about z: i (cos 0.2) + j (sin 0.2).
  EXPECT_EQ(read_file(path),
            "map odom 0 0 0 0 0 0 1\nbase_link laser 0.1 -0.05 0 0.980067 0.198669 0 0\n");
}

TEST_F(Ros2NodesTest, ABestEffortPublisherIsHeard) {
  expect_equal_runs(*launch(kCyclonePeer + " best_effort"));
}

TEST_F(Ros2NodesTest, MethodsInDomainsOfTheirOwnDoNotHearEachOther) {
  const auto one = launch(kCyclonePeer), other = launch(kCyclonePeer + " fast");
  expect_equal_runs(*one);
  expect_equal_runs(*other);
  expect_equal_runs(*one);
}

TEST_F(Ros2NodesTest, ProcessesAreStartedAnewForEachRunOnRequest) {
  expect_equal_runs(*launch(kCyclonePeer, "restart = run\n"));
}

TEST_F(Ros2NodesTest, RunningNodesAreFoundByTheirDomain) {
  const ExternalProcess node("exec " + kCyclonePeer, {{"ROS_DOMAIN_ID", "77"}});
  const auto method = make("domain = 77\n");
  expect_equal_runs(*method);
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "my.ini", {"domain", "another worker", "77"},
                           [&] { make("domain = 77\n"); }));
}

TEST_F(Ros2NodesTest, EachFaultEndsItsRunWithItsOutcomeAndTheNextRunIsSound) {
  struct Fault {
    std::string name;
    Outcome outcome;
    std::string detail, keys;
  };
  for (const Fault& fault :
       {Fault{"exit", Outcome::MethodError, "exit status 3", ""},
        Fault{"killed", Outcome::MethodError, "signal 9", ""},
        Fault{"nan", Outcome::MethodInvalidCommand, "not a finite number", ""},
        Fault{"two", Outcome::MethodError, "/cmd_vel has 2 publishers", "barrier = method\n"},
        Fault{"silent", Outcome::MethodDeadline, "no command on /cmd_vel within 100 s", ""},
        Fault{"deaf", Outcome::MethodDeadline, "the node /method does not reply",
              "barrier = method\n"}}) {
    SCOPED_TRACE(fault.name);
    HurryingClock clock;
    const auto method = launch(kCyclonePeer + " " + fault.name, fault.keys, clock);
    HookedMethod hurried = hurry_from(*method, clock, 0.5);
    const SimulationResult result = run(hurried, faulty());
    EXPECT_EQ(result.outcome, fault.outcome) << result.detail;
    EXPECT_TRUE(mentions(result.detail, {fault.detail}));
    EXPECT_EQ(run(*method).trajectory.hash(), expected_hash());
  }
}

TEST_F(Ros2NodesTest, StaleAndMissingCommandsAreCounted) {
  const auto stale = launch(kCyclonePeer + " --stamped stale");
  run(*stale, faulty());
  EXPECT_GT(stale->run_figures().at("commands_stale"), 50);
  const auto pauses = launch(kCyclonePeer + " pauses", "patience = 0.02\n");
  run(*pauses, faulty());
  EXPECT_GT(pauses->run_figures().at("commands_missing"), 20);
}

TEST_F(Ros2NodesTest, CommandsBeyondTheSizeOfADatagramAreRead) {
  SteeringMethod local;
  const auto method = launch(kCyclonePeer + " --stamped huge");
  EXPECT_EQ(run(*method, faulty()).trajectory.hash(), run(local, faulty()).trajectory.hash());
}

TEST_F(Ros2NodesTest, TheLastOfSeveralCommandsForAScanCountsIfTheirNumberIsKnown) {
  expect_equal_runs(*launch(kCyclonePeer + " twice", "commands_per_cycle = 2\n"));
  const auto unknown = launch(kCyclonePeer + " twice");
  EXPECT_TRUE(
      mentions(run(*unknown).detail,
               {"further commands on /cmd_vel followed an observation", "commands_per_cycle = 1"}));
}

TEST_F(Ros2NodesTest, NodesStayOnThisMachineByTheVariableOfTheirDistribution) {
  const TemporaryFolder folder;
  const std::string file = folder / "environment";
  for (const char* one : {"ROS_LOCALHOST_ONLY", "ROS_AUTOMATIC_DISCOVERY_RANGE"}) unsetenv(one);
  const auto environment = [&](const char* distribution) {
    setenv("ROS_DISTRO", distribution, 1);
    make("launch = env | grep -E 'ROS_(AUTO|LOCAL)' | sort > " + file + "; exec " + kCyclonePeer +
         "\n")
        ->check();
    unsetenv("ROS_DISTRO");
    return read_file(file);
  };
  const std::string range = "ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST\n";
  EXPECT_EQ(environment("humble"), range + "ROS_LOCALHOST_ONLY=1\n");
  for (const char* one : {"iron", "jazzy", "kilted", "rolling"}) EXPECT_EQ(environment(one), range);
}

TEST_F(Ros2NodesTest, ParametersAreSetInTheirTypesAndHaveEffect) {
  const TemporaryFolder folder;
  const std::string file = folder / "parameters.yaml";
  const auto method = make("launch = cp $SLALOM_PARAMETERS " + file + " && exec " + kCyclonePeer +
                           "\n"
                           "parameter_set = method.speed=0; method.count=7; method.on=true; "
                           "method.label=a b\n");
  method->check();
  EXPECT_EQ(read_file(file),
            "/method:\n  ros__parameters:\n    speed: 0\n    count: 7\n    on: true\n"
            "    label: 'a b'\n");
  const SimulationResult result = run(*method);
  EXPECT_EQ(result.outcome, Outcome::Stuck) << result.detail;
  // The value that the node has by itself.
  expect_equal_runs(*launch(kCyclonePeer, "parameter_set = method.speed=1\nrestart = run\n"));
}

TEST_F(Ros2NodesTest, ParametersOfNodesOnFastDdsAreSet) {
  if (kFastPeer.empty()) GTEST_SKIP() << "there is no Fast DDS 2";
  const SimulationResult result =
      run(*launch(kFastPeer, "parameter_set = method.speed=0.5; method.speed=0\n"));
  EXPECT_EQ(result.outcome, Outcome::Stuck) << result.detail;
  EXPECT_TRUE(throws_error(
      ErrorKind::Usage, "my.ini:", {"parameter_set", "/method refuses speed = 3: it is beyond 1"},
      [] { launch(kFastPeer, "parameter_set = method.speed=3\n")->check(); }));
}

TEST_F(Ros2NodesTest, AQuestionWhoseFirstReplyIsLostOrLateIsAskedAgain) {
  const std::string lock = "barrier = method\nparameter_set = method.speed=0.5; method.speed=1\n";
  expect_equal_runs(*launch(kCyclonePeer + " loses", lock));
  if (kFastPeer.empty()) GTEST_SKIP() << "there is no Fast DDS 2";
  expect_equal_runs(*launch(kFastPeer + " late", lock));
}

TEST_F(Ros2NodesTest, AParameterThatANodeDoesNotTakeIsAnErrorWithItsReason) {
  const auto refused = [](const std::string& set, std::initializer_list<std::string> words,
                          const std::string& arguments = "") {
    return throws_error(ErrorKind::Usage, "my.ini:5: [method.a] parameter_set", words, [&] {
      const IniFile ini =
          IniFile::from_text("[method.a]\nadapter = ros2\nlaunch = exec " + kCyclonePeer + " " +
                                 arguments + "\nstartup_time = " + (set == "sped=1" ? "10" : "60") +
                                 "\nparameter_set = method." + set + "\n",
                             "my.ini");
      read_ros2_method(ini, "method.a")(RobotModel(), SensorModel())->check();
    });
  };
  EXPECT_TRUE(refused("speed=3", {"the node /method refuses speed = 3: it is beyond 1"}));
  EXPECT_TRUE(refused("speed=fast", {"parameter speed of the node /method is a double", "'fast'"}));
  EXPECT_TRUE(refused("count=2.5", {"parameter count", "is an integer, not '2.5'"}));
  EXPECT_TRUE(refused("on=1", {"parameter on", "is a bool, not '1'"}));
  EXPECT_TRUE(refused("list=1", {"parameter list", "is an array"}));
  EXPECT_TRUE(refused("sped=1", {"no parameter sped of the node /method after 10 s"}));
  EXPECT_TRUE(refused("speed=0.5", {"does not keep its value"}, "forgetful"));
}

TEST_F(Ros2NodesTest, WhatIsMissingAtTheStartIsNamed) {
  SensorModel sensor;
  const auto refused = [&](const std::string& keys, std::initializer_list<std::string> words) {
    return throws_error(ErrorKind::Usage, "my.ini:3: [method.a] launch", words, [&] {
      const IniFile ini = IniFile::from_text("[method.a]\nadapter = ros2\n" + keys, "my.ini");
      read_ros2_method(ini, "method.a")(RobotModel(), sensor)->check();
    });
  };
  EXPECT_TRUE(refused("launch = exec sleep 100\nstartup_time = 0.3\n",
                      {"no reader of /scan", "no publisher of /cmd_vel", "0.3 s"}));
  sensor.lasers.resize(2);
  sensor.lasers[0].name = "left";
  sensor.lasers[1].name = "right";
  EXPECT_TRUE(refused("launch = exec sleep 100\nstartup_time = 0.3\n",
                      {"no reader of /scan_left, no reader of /scan_right"}));
  sensor.lasers.clear();
  EXPECT_TRUE(refused("launch = exec " + kCyclonePeer + "\nstartup_time = 2\nbarrier = other\n",
                      {"no node /other"}));
  EXPECT_TRUE(refused("launch = exec " + kCyclonePeer + " wrong_type\n",
                      {"/cmd_vel has the type geometry_msgs::msg::dds_::PoseStamped_", "Twist"}));
  EXPECT_TRUE(refused("launch = exit 7\n", {"exit status 7"}));
}

TEST_F(Ros2NodesTest, ADomainThatAnotherProgramUsesIsPassedOver) {
  const ExternalProcess stranger("exec " + kCyclonePeer, {{"ROS_DOMAIN_ID", "42"}});
  {
    const auto waiting = make("domain = 42\n");  // until it is there
    EXPECT_EQ(run(*waiting).trajectory.hash(), expected_hash());
  }
  expect_equal_runs(*launch(kCyclonePeer));
}

}  // namespace
}  // namespace slalom
