// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "lcm_fixture.h"
#include "places.h"

#include <slalom/library/library_method.h>

namespace slalom {
namespace {

/// follow_the_gap as a plug-in in this process and hosted by slalom-lcm-method.
class Hosted : public LcmTest {
 protected:
  static std::unique_ptr<Method> in_process(const std::string& keys, const RobotModel& robot,
                                            const SensorModel& sensor) {
    const IniFile ini = IniFile::from_text(
        "[method.a]\nadapter = library\nplugin = " + kFollowTheGap + "\n" + keys);
    return read_library_method(ini, "method.a")(robot, sensor);
  }

  static std::unique_ptr<Method> hosted(const std::string& keys, const RobotModel& robot = {},
                                        const SensorModel& sensor = {}) {
    const IniFile ini = IniFile::from_text(std::string("[method.a]\nadapter = lcm\n"
                                                       "launch = exec slalom-lcm-method --plugin " +
                                                       kFollowTheGap + "\n") +
                                               kLongDeadlines + keys,
                                           "campaign.ini");
    return read_lcm_method(ini, "method.a")(robot, sensor);
  }

  /// A room with columns on the straight line from start to goal.
  static const World& columns() {
    static const World world = [] {
      Primitives obstacles;
      for (int i = 0; i < 6; ++i)
        obstacles.discs.push_back({{2.0 + i, i % 2 == 0 ? 4.7 : 5.4}, 0.3});
      return World(
          Scenario::continuous("columns", {0, 0, 10, 10}, obstacles, {0.7, 5, 0.2}, {9, 5}), 0.05);
    }();
    return world;
  }

  static SimulationResult run(Method& method, const RobotModel& robot, const SensorModel& sensor) {
    RunSetup setup;
    setup.robot = robot;
    setup.sensor = sensor;
    setup.odometry.turn_sigma = 0.01;
    return simulate(columns(), setup, 7, method);
  }
};

TEST_F(Hosted, AMethodGivesTheSameRunsInProcessAndOverLcm) {
  RobotModel disc, box;
  box.footprint = "0.2,0.1; -0.2,0.1; -0.2,-0.1; 0.2,-0.1";
  box.radius = std::hypot(0.2, 0.1);
  SensorModel standard, unusual;
  unusual.rays = 97;
  unusual.aperture_deg = 239.7;
  unusual.noise_sigma = 0.02;
  for (const RobotModel& robot : {disc, box})
    for (const SensorModel& sensor : {standard, unusual}) {
      const auto local = in_process("look_ahead = 1.7\n", robot, sensor);
      const auto remote = hosted("look_ahead = 1.7\n", robot, sensor);
      const SimulationResult expected = run(*local, robot, sensor);
      for (int repetition = 0; repetition < 2; ++repetition) {
        const SimulationResult result = run(*remote, robot, sensor);
        EXPECT_EQ(result.trajectory.hash(), expected.trajectory.hash());
        EXPECT_EQ(result.detail, expected.detail);
      }
      EXPECT_GT(expected.trajectory.samples.size(), 20U) << expected.detail;
    }
}

TEST_F(Hosted, AMethodGetsTheHeadingOfAGoalOverLcm) {
  const World turned(columns().scenario().with_goal_heading(-2), 0.05);
  const auto local = in_process("", {}, {}), remote = hosted("");
  for (const World* world : {&turned, &columns(), &turned}) {
    const SimulationResult expected = simulate(*world, {}, 7, *local);
    EXPECT_EQ(expected.outcome, Outcome::Success) << expected.detail;
    EXPECT_EQ(simulate(*world, {}, 7, *remote).trajectory.hash(), expected.trajectory.hash());
  }
}

TEST_F(Hosted, TwoMethodsOnOneUrlDoNotInterfere) {
  const auto one = hosted("look_ahead = 1.7\n"), other = hosted("look_ahead = 0.6\n");
  const auto alone = in_process("look_ahead = 1.7\n", {}, {});
  const auto alone_too = in_process("look_ahead = 0.6\n", {}, {});
  EXPECT_EQ(run(*one, {}, {}).trajectory.hash(), run(*alone, {}, {}).trajectory.hash());
  EXPECT_EQ(run(*other, {}, {}).trajectory.hash(), run(*alone_too, {}, {}).trajectory.hash());
  EXPECT_NE(run(*one, {}, {}).trajectory.hash(), run(*other, {}, {}).trajectory.hash());
}

TEST_F(Hosted, UnknownSettingsAreRefused) {
  EXPECT_TRUE(throws_error(
      ErrorKind::Usage, "campaign.ini:3: [method.a] launch: ",
      {"external process reported", "follow_the_gap", "unknown parameter", "expected 'look_ahead'"},
      [] { hosted("look_ahaed = 1\n"); }));
}

TEST_F(Hosted, InvalidOptionsAreRefused) {
  const auto refuses = [](const std::string& key, const std::string& value,
                          std::initializer_list<std::string> words) {
    return throws_error(ErrorKind::Usage, "/somewhere/campaign.ini:3: [method.a] " + key + ": ",
                        words, [&] { make(key + " = " + value + "\n"); });
  };
  EXPECT_TRUE(refuses("mode", "quick", {"'quick'", "lockstep, realtime"}));
  EXPECT_TRUE(refuses("channel", "A_NAME_THAT_IS_LONGER_THAN_IT_MAY",
                      {"'A_NAME_THAT_IS_LONGER_THAN_IT_MAY'", "expected 1 to 24 characters"}));
  EXPECT_TRUE(refuses("url", "nonsense://", {"LCM", "'nonsense://'", "multicast"}));
}

TEST_F(Hosted, IsMadeFromOptionsOfAProgram) {
  LcmOptions options;
  options.launch = "exec slalom-lcm-method --plugin " + kFollowTheGap;
  options.settings = {{"look_ahead", "1.7"}};
  const auto method = lcm_method(options)({}, {});
  EXPECT_EQ(run(*method, {}, {}).trajectory.hash(),
            run(*in_process("look_ahead = 1.7\n", {}, {}), {}, {}).trajectory.hash());
  options.channel = "";
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "lcm_method.channel: ", {"1 to 24 characters"},
                           [&] { lcm_method(options); }));
}

}  // namespace
}  // namespace slalom
