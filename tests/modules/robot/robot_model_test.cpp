#include <slalom/core/error.h>
#include <slalom/robot/robot_model.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

template <typename Options>
std::string message_of(const std::string& section, const std::string& line) {
  try {
    read_options<Options>(IniFile::from_text("[" + section + "]\n" + line + "\n"), section);
  } catch (const Error& error) {
    return error.culprit() == Culprit::Usage ? error.what() : "wrong culprit";
  }
  return "";
}

TEST(SensorModel, DefaultsToThePapersOneRayPerDegree) {
  const SensorModel sensor;
  EXPECT_EQ(sensor.rays, 181);
  EXPECT_DOUBLE_EQ(sensor.aperture(), M_PI);
}

TEST(RobotModel, DefaultsToThePapersForwardMotionOnly) {
  const RobotModel robot;
  EXPECT_TRUE(robot.forward_only);
  EXPECT_EQ(robot.kinematics, "diff_drive");
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

TEST(RobotModel, RefusesWhatCannotBe) {
  EXPECT_NE(message_of<RobotModel>("robot", "radius = 0").find("radius"), std::string::npos);
  EXPECT_NE(message_of<RobotModel>("robot", "kinematics = hover").find("diff_drive"),
            std::string::npos);
  EXPECT_NE(message_of<RobotModel>("robot", "max_velocity = 1").find("max_v"), std::string::npos);
  EXPECT_NE(message_of<SensorModel>("sensor", "rays = 1").find("rays"), std::string::npos);
  EXPECT_NE(message_of<SensorModel>("sensor", "aperture_deg = 361").find("aperture_deg"),
            std::string::npos);
}

TEST(RobotModel, APolygonsRadiusIsThatOfTheDiscThatEnclosesIt) {
  const RobotModel robot = read_robot_model(
      IniFile::from_text("[robot]\nfootprint = 0.3,0.4; -0.3,0.4; -0.3,-0.4; 0.3,-0.4\n"));
  EXPECT_DOUBLE_EQ(robot.radius, 0.5);
  EXPECT_DOUBLE_EQ(robot.shape().inscribed_radius(), 0.3);
}

TEST(RobotModel, AFootprintIsToldWhatItLacks) {
  const auto message = [](const std::string& lines) {
    try {
      read_robot_model(IniFile::from_text("[robot]\n" + lines, "a.ini"));
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message("footprint = 1,0; 0,1\n"),
            "a.ini:2: [robot] footprint: '1,0; 0,1' is no footprint; expected 3 to 64 corners");
  EXPECT_EQ(message("radius = 0.3\nfootprint = 1,0; 0,1; -1,-1\n"),
            "a.ini:3: [robot] footprint: stands beside a radius; expected radius or footprint");
}

}  // namespace
}  // namespace slalom
