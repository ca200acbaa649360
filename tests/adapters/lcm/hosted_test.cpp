#include "error_text.h"
#include "lcm_fixture.h"

#include <slalom/library/library_method.h>

namespace slalom {
namespace {

/// follow_the_gap as a plug-in in this process and in slalom-lcm-method.
class Hosted : public LcmTest {
 protected:
  static std::unique_ptr<Method> in_process(const std::string& keys, const RobotModel& robot,
                                            const SensorModel& sensor) {
    const IniFile ini =
        IniFile::from_text("[method.a]\nadapter = library\nplugin = " FOLLOW_THE_GAP "\n" + keys);
    return make_library_method({ini, "method.a", robot, sensor});
  }

  static std::unique_ptr<Method> hosted(const std::string& keys, const RobotModel& robot = {},
                                        const SensorModel& sensor = {}) {
    const IniFile ini = IniFile::from_text(
        "[method.a]\nadapter = lcm\n"
        "launch = exec slalom-lcm-method --plugin " FOLLOW_THE_GAP "\n" +
            keys,
        "campaign.ini");
    return make_lcm_method({ini, "method.a", robot, sensor});
  }

  /// A room with columns, the robot's way right through them.
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

  static SimulationResult drive(Method& method, const RobotModel& robot,
                                const SensorModel& sensor) {
    RunSetup setup;
    setup.robot = robot;
    setup.sensor = sensor;
    setup.odometry.turn_sigma = 0.01;
    return simulate(columns(), setup, 7, method);
  }
};

TEST_F(Hosted, AMethodDrivesTheSameInProcessAndOverLcm) {
  RobotModel disc, box;
  box.footprint = "0.2,0.1; -0.2,0.1; -0.2,-0.1; 0.2,-0.1";
  box.radius = std::hypot(0.2, 0.1);
  SensorModel paper, odd;
  odd.rays = 97;
  odd.aperture_deg = 239.7;
  odd.noise_sigma = 0.02;
  for (const RobotModel& robot : {disc, box})
    for (const SensorModel& sensor : {paper, odd}) {
      const auto here = in_process("look_ahead = 1.7\n", robot, sensor);
      const auto there = hosted("look_ahead = 1.7\n", robot, sensor);
      const SimulationResult expected = drive(*here, robot, sensor);
      for (int repetition = 0; repetition < 2; ++repetition) {
        const SimulationResult result = drive(*there, robot, sensor);
        EXPECT_EQ(result.trajectory.hash(), expected.trajectory.hash());
        EXPECT_EQ(result.detail, expected.detail);
      }
      EXPECT_GT(expected.trajectory.samples.size(), 20U) << expected.detail;
    }
}

TEST_F(Hosted, TwoMethodsOnOneAddressDoNotHearEachOther) {
  const auto one = hosted("look_ahead = 1.7\n"), other = hosted("look_ahead = 0.6\n");
  const auto alone = in_process("look_ahead = 1.7\n", {}, {});
  const auto alone_too = in_process("look_ahead = 0.6\n", {}, {});
  EXPECT_EQ(drive(*one, {}, {}).trajectory.hash(), drive(*alone, {}, {}).trajectory.hash());
  EXPECT_EQ(drive(*other, {}, {}).trajectory.hash(), drive(*alone_too, {}, {}).trajectory.hash());
  EXPECT_NE(drive(*one, {}, {}).trajectory.hash(), drive(*other, {}, {}).trajectory.hash());
}

TEST_F(Hosted, SettingsThatTheMethodDoesNotKnowAreRefused) {
  const std::string text = error_text(Culprit::Usage, [] { hosted("look_ahaed = 1\n"); });
  EXPECT_EQ(text.rfind("campaign.ini:3: [method.a] launch: the external process says: ", 0), 0U)
      << text;
  EXPECT_NE(text.find("follow_the_gap has no such parameter; expected 'look_ahead'"),
            std::string::npos)
      << text;
}

TEST_F(Hosted, WrongOptionsAreRefused) {
  const auto refusal = [](const std::string& keys) {
    return error_text(Culprit::Usage, [&] { make(keys); });
  };
  EXPECT_EQ(refusal("mode = quick\n"),
            "/somewhere/campaign.ini:3: [method.a] mode: 'quick' is not valid; expected one of "
            "lockstep, realtime");
  EXPECT_EQ(refusal("channel = A_NAME_THAT_IS_LONGER_THAN_IT_MAY\n"),
            "/somewhere/campaign.ini:3: [method.a] channel: 'A_NAME_THAT_IS_LONGER_THAN_IT_MAY' is "
            "no channel; expected 1 to 24 characters");
  EXPECT_EQ(refusal("url = nonsense://\n"),
            "/somewhere/campaign.ini:3: [method.a] url: LCM cannot be used with 'nonsense://'; "
            "expected a provider's address and, for udpm, a network interface with multicast");
}

}  // namespace
}  // namespace slalom
