// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/robot/robot_model.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

template <typename Options>
::testing::AssertionResult refused(const std::string& section, const std::string& line,
                                   std::initializer_list<std::string> words) {
  const IniFile ini = IniFile::from_text("[" + section + "]\n" + line + "\n", "a.ini");
  return throws_error(ErrorKind::Usage, "a.ini:2: [" + section + "] ", words,
                      [&] { read_options<Options>(ini, section); });
}

TEST(SensorModel, DefaultsToOneRayPerDegree) {
  const SensorModel sensor;
  EXPECT_EQ(sensor.rays, 181);
  EXPECT_DOUBLE_EQ(sensor.aperture(), M_PI);
}

TEST(SensorModel, AnApertureInRadiansIsWarnedAbout) {
  const auto warning = [](const std::string& aperture) {
    return sensor_warning(
        IniFile::from_text("[sensor]\naperture_deg = " + aperture + "\n", "a.ini"));
  };
  EXPECT_EQ(warning("3.14"),
            "a.ini:2: [sensor] aperture_deg: 3.14 degrees looks like radians; expected 179.9 for "
            "that angle in degrees");
  EXPECT_NE(warning("6.283"), "");
  EXPECT_EQ(warning("6.4"), "");
  EXPECT_EQ(warning("wide"), "");
  EXPECT_EQ(sensor_warning(IniFile::from_text("")), "");
}

TEST(RobotModel, DefaultsToForwardMotionOnly) {
  const RobotModel robot;
  EXPECT_TRUE(robot.forward_only);
  EXPECT_EQ(robot.kinematics, Kinematics::DiffDrive);
}

TEST(RobotModel, IsReadFromAnIni) {
  const IniFile ini = IniFile::from_text(
      "[robot]\nradius = 0.3\nmax_v = 2\nforward_only = false\n[sensor]\naperture_deg = 90\n");
  const auto robot = read_options<RobotModel>(ini, "robot");
  EXPECT_EQ(robot.radius, 0.3);
  EXPECT_EQ(robot.max_v, 2);
  EXPECT_FALSE(robot.forward_only);
  EXPECT_EQ(robot.max_w, RobotModel().max_w);
  EXPECT_DOUBLE_EQ(read_options<SensorModel>(ini, "sensor").aperture(), M_PI / 2);
}

TEST(RobotModel, RefusesInvalidValues) {
  EXPECT_TRUE(refused<RobotModel>("robot", "radius = 0", {"radius"}));
  EXPECT_TRUE(refused<RobotModel>("robot", "kinematics = hover", {"diff_drive"}));
  EXPECT_TRUE(refused<RobotModel>("robot", "max_velocity = 1", {"max_v"}));
  EXPECT_TRUE(refused<SensorModel>("sensor", "rays = 1", {"rays"}));
  EXPECT_TRUE(refused<SensorModel>("sensor", "aperture_deg = 361", {"aperture_deg"}));
}

TEST(RobotModel, TheRadiusOfAPolygonIsThatOfItsEnclosingDisc) {
  const RobotModel robot = read_robot_model(
      IniFile::from_text("[robot]\nfootprint = 0.3,0.4; -0.3,0.4; -0.3,-0.4; 0.3,-0.4\n"));
  EXPECT_DOUBLE_EQ(robot.radius, 0.5);
  EXPECT_DOUBLE_EQ(robot.shape().inscribed_radius(), 0.3);
}

TEST(RobotModel, RefusesInvalidFootprints) {
  const auto read = [](const std::string& lines) {
    read_robot_model(IniFile::from_text("[robot]\n" + lines, "a.ini"));
  };
  EXPECT_TRUE(throws_error(
      ErrorKind::Usage, "a.ini:2: [robot] footprint: ", {"'1,0; 0,1'", "expected 3 to 64 corners"},
      [&] { read("footprint = 1,0; 0,1\n"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "a.ini:3: [robot] footprint: ",
                           {"radius", "expected", "radius or footprint"},
                           [&] { read("radius = 0.3\nfootprint = 1,0; 0,1; -1,-1\n"); }));
}

}  // namespace
}  // namespace slalom
