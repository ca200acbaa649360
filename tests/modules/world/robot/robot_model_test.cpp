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

SensorModel sensor_of(const std::string& text) {
  return read_sensor_model(IniFile::from_text(text, "a.ini"));
}

TEST(SensorModel, LasersHaveTheRaysOfTheSensorUnlessTheySayOtherwise) {
  const SensorModel sensor = sensor_of(
      "[laser.rear]\nx = -0.3\nyaw = 3.14\n[laser.front]\nx = 0.2\nrays = 91\nmax_range = 4\n"
      "[sensor]\nrays = 721\naperture_deg = 270\nmax_range = 10\n");
  ASSERT_EQ(sensor.lasers.size(), 2U);
  const LaserModel &front = sensor.lasers[0], &rear = sensor.lasers[1];  // by name
  EXPECT_EQ(front.name, "front");
  EXPECT_EQ(front.x, 0.2);
  EXPECT_EQ(front.rays, 91);
  EXPECT_EQ(front.max_range, 4);
  EXPECT_EQ(front.aperture_deg, 270);
  EXPECT_EQ(rear.yaw, 3.14);
  EXPECT_EQ(rear.rays, 721);
  EXPECT_EQ(rear.max_range, 10);
  EXPECT_EQ(sensor.rays, 721);
}

TEST(SensorModel, WithoutLasersWhatMeasuresIsAtTheCenter) {
  const auto lasers = sensor_of("[sensor]\nrays = 31\n").all_lasers();
  ASSERT_EQ(lasers.size(), 1U);
  EXPECT_EQ(lasers[0].name, "");
  EXPECT_EQ(lasers[0].rays, 31);
  EXPECT_EQ(lasers[0].x, 0);
  EXPECT_EQ(sensor_of("[laser.a]\n[laser.b]\n").all_lasers().size(), 2U);
}

TEST(SensorModel, RefusesLasersThatCannotBe) {
  const auto refused = [](const std::string& text, const std::string& where,
                          std::initializer_list<std::string> words) {
    return throws_error(ErrorKind::Usage, "a.ini" + where, words, [&] { sensor_of(text); });
  };
  EXPECT_TRUE(refused("[laser.a]\nx = 1000\n", ":2: [laser.a] x", {"[-100, 100]"}));
  EXPECT_TRUE(refused("[laser.a]\nz = 1\n", ":2: [laser.a] ", {"z"}));
  EXPECT_TRUE(refused("[laser.a b]\nx = 1\n", ": [laser.a b]", {"'a b'", "letters"}));
  EXPECT_TRUE(refused("[laser.]\nx = 1\n", ": [laser.]", {"letters"}));
  EXPECT_TRUE(refused("[laser.a]\nrange_min = 8\n", ":2: [laser.a] range_min",
                      {"8 m", "less than max_range, 8 m"}));
  EXPECT_TRUE(refused("[laser.a]\nraw = true\n[laser.b]\n", ":2: [laser.a] raw",
                      {"2 lasers", "expected one"}));
  EXPECT_TRUE(refused("[laser.a]\nraw = true\nrays = 7\n", ":2: [laser.a] raw",
                      {"other rays than [sensor]"}));
  SensorModel twins;
  twins.lasers.resize(2);
  twins.lasers[0].name = twins.lasers[1].name = "a";
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "laser a", {"two lasers have the name 'a'"}, [&] {
    twins.check_lasers([](const std::string& name, const std::string& key) {
      return "laser " + name + " " + key;
    });
  }));
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

TEST(RobotModel, APolygonThatRotatesInPlaceIsNeitherADiscNorACar) {
  RobotModel robot;
  EXPECT_FALSE(robot.turning_polygon());
  robot.footprint = "0.4,0.2; -0.4,0.2; -0.4,-0.2; 0.4,-0.2";
  ASSERT_TRUE(robot.turning_polygon());
  EXPECT_EQ(robot.turning_polygon()->half_width(), 0.2);
  robot.min_turning_radius = 0.5;
  EXPECT_FALSE(robot.turning_polygon());
}

}  // namespace
}  // namespace slalom
