// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "temporary_folder.h"

#include <slalom/core/random.h>
#include <slalom/robot/robot_model.h>
#include <slalom/ros_parameters/resolve.h>
#include <slalom/simulation/simulate.h>

#include <gtest/gtest.h>

#include <complex>
#include <fstream>

namespace slalom {
namespace {

class Urdf : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  IniFile resolve(const std::string& text) {
    IniFile ini = IniFile::from_text(text, folder_ / "a.ini");
    reports_ = resolve_ros_parameters(ini);
    return ini;
  }
  /// [robot] of an .ini with these keys beside the file.
  IniFile robot(const std::string& urdf, const std::string& keys = "") {
    write("r.urdf", "<robot name=\"r\">\n" + urdf + "</robot>\n");
    return resolve("[robot]\nfrom = r.urdf\n" + keys);
  }
  testing::AssertionResult refuses(const std::string& urdf, const std::string& where,
                                   std::initializer_list<std::string> words,
                                   ErrorKind kind = ErrorKind::File) {
    return throws_error(kind, folder_ / "r.urdf" + where, words, [&] { robot(urdf); });
  }

  const TemporaryFolder folder_;
  std::vector<RosParameterReport> reports_;
};

std::string link(const std::string& name, const std::string& geometry,
                 const std::string& origin = "") {
  return "<link name=\"" + name + "\"><collision>" + origin + "<geometry>" + geometry +
         "</geometry></collision></link>\n";
}
std::string joint(const std::string& parent, const std::string& child, const std::string& inside,
                  const std::string& type = "fixed") {
  return "<joint name=\"to_" + child + "\" type=\"" + type + "\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/>" + inside + "</joint>\n";
}
const std::string kBox = "<box size=\"0.84 0.42 0.3\"/>";

TEST_F(Urdf, ABoxBeforeTheRearAxleIsARectangle) {
  const IniFile ini = robot(link("base_link", kBox, "<origin xyz=\"0.3 0 0.15\"/>"));
  const Footprint shape = read_robot_model(ini).shape();
  ASSERT_EQ(shape.corners().size(), 4U);
  EXPECT_NEAR(shape.half_width(), 0.21, 1e-9);
  EXPECT_NEAR(shape.inscribed_radius(), 0.12, 1e-9) << "behind the axle";
  EXPECT_NEAR(shape.enclosing_radius(), std::hypot(0.72, 0.21), 1e-9);
  EXPECT_FALSE(ini.get("robot", "from"));
  EXPECT_EQ(reports_.at(0).mapped.size(), 1U);
}

TEST_F(Urdf, ACylinderAroundTheCenterIsADisc) {
  const IniFile ini = robot(link("base_link", "<cylinder radius=\"0.18\" length=\"0.1\"/>") +
                            link("wheel", "<sphere radius=\"0.03\"/>") +
                            joint("base_link", "wheel", "<origin xyz=\"0 0.1 0\"/>"));
  EXPECT_EQ(ini.get("robot", "radius"), "0.18");
  EXPECT_FALSE(ini.get("robot", "footprint"));
}

TEST_F(Urdf, WheelsThatLieAreSeenFromAbove) {
  // A wheel of 0.1 m radius and 0.04 m width, turned onto its side by its joint.
  const Footprint shape =
      read_robot_model(
          robot(link("base_link", "<box size=\"0.1 0.1 0.1\"/>") +
                link("wheel", "<cylinder radius=\"0.1\" length=\"0.04\"/>") +
                joint("base_link", "wheel", "<origin xyz=\"0 0.2 0\" rpy=\"-1.5707963 0 0\"/>")))
          .shape();
  double left = 0, ahead = 0;
  for (const auto& corner : shape.corners()) {
    left = std::max(left, corner.y);
    ahead = std::max(ahead, corner.x);
  }
  EXPECT_NEAR(left, 0.22, 1e-4);
  EXPECT_GE(ahead, 0.1 - 1e-4);
  EXPECT_LT(ahead, 0.101) << "the polygon around a circle";
}

TEST_F(Urdf, ASphereIsRoundHoweverItsLinkIsTurned) {
  const Footprint shape =
      read_robot_model(
          robot(link("base_link", "<box size=\"0.1 0.1 0.1\"/>") +
                link("wheel", "<sphere radius=\"0.2\"/>") +
                joint("base_link", "wheel", "<origin xyz=\"0.1 0 0\" rpy=\"1.2 0.7 0\"/>")))
          .shape();
  EXPECT_NEAR(shape.half_width(), 0.2, 2e-3);
  EXPECT_NEAR(shape.enclosing_radius(), 0.3, 2e-3);
}

/// Chains of joints that turn about z, with boxes: the same corners by complex numbers.
TEST_F(Urdf, TheFootprintContainsAllCornersOfAnyChain) {
  RandomEngine engine(4);
  const auto draw = [&] { return std::round(1000 * uniform_real(engine, -1, 1)) / 1000; };
  for (int repetition = 0; repetition < 50; ++repetition) {
    std::string text = link("base_link", "<box size=\"0.2 0.2 0.2\"/>");
    std::vector<std::complex<double>> corners = {
        {0.1, 0.1}, {0.1, -0.1}, {-0.1, 0.1}, {-0.1, -0.1}};
    std::complex<double> at = 0, turn = 1;
    for (int i = 0; i < 3; ++i) {
      const std::string name = "l" + std::to_string(i);
      const double x = draw(), y = draw(), yaw = 3 * draw(), length = 0.5 + 0.4 * draw();
      text += link(name, "<box size=\"" + std::to_string(length) + " 0.1 0.1\"/>");
      text += joint(i == 0 ? "base_link" : "l" + std::to_string(i - 1), name,
                    "<origin xyz=\"" + std::to_string(x) + " " + std::to_string(y) +
                        " 0\" rpy=\"0 0 " + std::to_string(yaw) + "\"/>");
      at += turn * std::complex<double>(x, y);
      turn *= std::polar(1.0, yaw);
      for (const double u : {-0.5, 0.5})
        for (const double v : {-0.05, 0.05})
          corners.push_back(at + turn * std::complex<double>(u * length, v));
    }
    const auto polygon = read_robot_model(robot(text)).shape().corners();
    double area = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      area += a.x * b.y - a.y * b.x;
      const double side = std::hypot(b.x - a.x, b.y - a.y);
      double nearest = 1;
      for (const auto& c : corners) {
        const double inside =
            ((b.x - a.x) * (c.imag() - a.y) - (b.y - a.y) * (c.real() - a.x)) / side;
        EXPECT_GT(inside, -2e-4);
        nearest = std::min(nearest, inside);
      }
      EXPECT_LT(nearest, 2e-4) << "each side touches a box";
    }
    EXPECT_GT(area, 0);
  }
}

TEST_F(Urdf, AMeshIsNamedWithTheWayIn) {
  const std::string mesh = link("base_link", "<mesh filename=\"a.stl\"/>");
  EXPECT_TRUE(refuses(mesh, ":2: base_link", {"is a mesh", "[robot] footprint"}, ErrorKind::Usage));
  EXPECT_EQ(robot(mesh, "radius = 0.3\n").get("robot", "radius"), "0.3");
  EXPECT_EQ(reports_.at(0).without_counterpart.size(), 1U);
  EXPECT_TRUE(refuses("<link name=\"base_link\"/>\n", ": no link has a collision shape",
                      {"[robot] footprint"}, ErrorKind::Usage));
}

TEST_F(Urdf, TwoWheelsWithLimitsGiveThoseOfTheRobot) {
  const std::string wheel = "<cylinder radius=\"0.05\" length=\"0.02\"/>";
  const auto at = [](const std::string& y) {
    return "<origin xyz=\"0 " + y +
           " 0\" rpy=\"-1.5707963 0 0\"/><axis xyz=\"0 0 1\"/><limit velocity=\"10\" "
           "effort=\"1\"/>";
  };
  const std::string text = link("base_link", kBox) + link("left", wheel) + link("right", wheel) +
                           joint("base_link", "left", at("0.2"), "continuous") +
                           joint("base_link", "right", at("-0.2"), "continuous");
  const RobotModel model = read_robot_model(robot(text));
  EXPECT_NEAR(model.max_v, 0.5, 1e-9);
  EXPECT_NEAR(model.max_w, 0.5 / 0.2, 1e-9);
  EXPECT_EQ(robot(text, "max_v = 0.4\n").get("robot", "max_v"), "0.4");
  EXPECT_EQ(reports_.at(0).overridden.size(), 1U);
}

TEST_F(Urdf, LasersHaveTheirPosesAndScans) {
  const std::string text =
      link("base_link", kBox) + "<link name=\"base_scan\"/>\n" +
      joint("base_link", "base_scan", "<origin xyz=\"0.3 0.1 0.2\" rpy=\"0 0 0.5\"/>") +
      "<gazebo reference=\"base_scan\"><sensor type=\"ray\" name=\"s\"><ray><scan><horizontal>"
      "<samples>360</samples><min_angle>-1</min_angle><max_angle>2</max_angle></horizontal></scan>"
      "<range><min>0.1</min><max>3.5</max></range></ray></sensor></gazebo>\n";
  const IniFile ini = robot(text);
  EXPECT_EQ(ini.get("laser.base_scan", "x"), "0.3");
  EXPECT_EQ(ini.get("laser.base_scan", "y"), "0.1");
  EXPECT_EQ(ini.get("laser.base_scan", "yaw"), "1") << "the middle of the scan";
  EXPECT_EQ(ini.get("laser.base_scan", "rays"), "360");
  EXPECT_EQ(ini.get("laser.base_scan", "max_range"), "3.5");
  EXPECT_NEAR(std::stod(*ini.get("laser.base_scan", "aperture_deg")), 3 * 180 / M_PI, 1e-3);
  const std::string second = "<gazebo reference=\"base_scan\"><sensor type=\"lidar\"/></gazebo>\n";
  EXPECT_EQ(robot(text + second).get("laser.base_scan_", "x"), "0.3");
  EXPECT_FALSE(robot(text, "[laser.mine]\nx = 0\n").has_section("laser.base_scan"));
}

/// A laser at the base with these rays and angles.
std::string laser(const std::string& samples, const std::string& half_angle = "1") {
  return link("base_link", kBox) +
         "<gazebo reference=\"base_link\"><sensor type=\"ray\"><ray><scan><horizontal><samples>" +
         samples + "</samples><min_angle>-" + half_angle + "</min_angle><max_angle>" + half_angle +
         "</max_angle></horizontal></scan></ray></sensor></gazebo>\n";
}

TEST_F(Urdf, RaysThatALaserCannotHaveAreRefusedAsTheyAre) {
  for (const std::string samples : {"2000000", "-1e+300", "10.5"})
    EXPECT_TRUE(throws_error(ErrorKind::Usage, folder_ / "r.urdf",
                             {"laser.base_link.rays", "'" + samples + "'", "[2, 100000]"},
                             [&] { read_sensor_model(robot(laser(samples))); }));
}

TEST_F(Urdf, AWholeTurnMayBeWrittenWithFewDigits) {
  EXPECT_EQ(robot(laser("360", "3.1416")).get("laser.base_link", "aperture_deg"), "360");
  EXPECT_TRUE(throws_error(ErrorKind::Usage, folder_ / "r.urdf", {"aperture_deg", "[1, 360]"},
                           [&] { read_sensor_model(robot(laser("360", "3.2"))); }));
}

TEST_F(Urdf, TooManyLasersAreRefused) {
  std::string sensors;
  for (int i = 0; i < 101; ++i) sensors += "<sensor type=\"ray\"/>\n";
  EXPECT_TRUE(refuses(
      link("base_link", kBox) + "<gazebo reference=\"base_link\">\n" + sensors + "</gazebo>\n",
      ":104", {"one laser too many", "at most 100"}));
}

TEST_F(Urdf, MethodsGetAScanAsWideAsThoseOfTheLasers) {
  const SensorModel front = read_sensor_model(robot(laser("401", "2")));
  EXPECT_NEAR(front.aperture(), 4, 1e-9);
  EXPECT_EQ(front.rays, 401);
  EXPECT_EQ(front.max_range, SensorModel().max_range);
  EXPECT_EQ(reports_.at(0).mapped.back().result, "[sensor] rays = 401");
  EXPECT_EQ(
      read_sensor_model(robot(laser("401", "2"), "[sensor]\naperture_deg = 90\n")).aperture_deg,
      90);
  const std::string behind =
      "<link name=\"rear\"/>\n" +
      joint("base_link", "rear", "<origin xyz=\"-0.3 0 0.2\" rpy=\"0 0 3.1415926535\"/>") +
      "<gazebo reference=\"rear\"><sensor type=\"ray\"><ray><scan><horizontal><samples>11</samples>"
      "<min_angle>-1</min_angle><max_angle>1</max_angle></horizontal></scan><range><max>12</max>"
      "</range></ray></sensor></gazebo>\n";
  const SensorModel both = read_sensor_model(robot(laser("401", "2") + behind));
  EXPECT_EQ(both.aperture_deg, 360);
  EXPECT_EQ(both.rays, 1 + std::lround(2 * M_PI * 100)) << "100 rays per rad as in front";
  EXPECT_EQ(both.max_range, 12);
}

TEST_F(Urdf, LasersHaveNamesOfSections) {
  const std::string text = link("base_link", kBox) + "<link name=\"b] [campaign\"/>\n" +
                           joint("base_link", "b] [campaign", "") +
                           "<gazebo reference=\"b] [campaign\"><sensor type=\"ray\"/></gazebo>\n";
  const IniFile ini = robot(text);
  EXPECT_TRUE(ini.has_section("laser.b___campaign"));
}

TEST_F(Urdf, TheParametersOfNav2HaveTheLimitsAndTheFirstShape) {
  write("r.urdf", "<robot name=\"r\">\n" + link("base_link", kBox) + "</robot>\n");
  write("nav.yaml",
        "controller_server:\n  ros__parameters:\n    FollowPath:\n"
        "      plugin: dwb_core::DWBLocalPlanner\n      max_vel_x: 0.3\n"
        "local_costmap:\n  local_costmap:\n    ros__parameters:\n      robot_radius: 0.2\n");
  const IniFile ini = resolve("[robot]\nfrom = r.urdf, nav.yaml\n");
  EXPECT_EQ(ini.get("robot", "max_v"), "0.3");
  EXPECT_EQ(ini.get("robot", "radius"), "0.2");
  EXPECT_FALSE(ini.get("robot", "footprint"));
}

TEST_F(Urdf, WhatIsNoRobotIsRefusedWithItsLine) {
  EXPECT_TRUE(refuses("<xacro:include filename=\"a\"/>\n", ":2", {"xacro", "FILE > robot.urdf"}));
  EXPECT_TRUE(refuses(link("a", "<box size=\"1 1\"/>"), ":2", {"box", "2 numbers", "3"}));
  EXPECT_TRUE(refuses(link("a", "<cylinder radius=\"-1\" length=\"1\"/>"), ":2", {"radius = -1"}));
  EXPECT_TRUE(refuses(link("a", "<box size=\"1 0 1\"/>"), ":2", {"a side is not above 0"}));
  EXPECT_TRUE(refuses(link("a", "<cone/>"), ":2", {"<cone>", "sphere"}));
  EXPECT_TRUE(refuses(link("a", kBox) + joint("a", "b", ""), ":3", {"child 'b' is not a link"}));
  EXPECT_TRUE(refuses(link("a", kBox) + link("b", kBox), ":1", {"2 root links"}));
  EXPECT_TRUE(refuses(link("a", kBox) + link("a", kBox), ":3", {"'a'"}));
  EXPECT_TRUE(refuses(link("a", kBox) + link("b", kBox) + link("c", kBox) + joint("b", "c", "") +
                          joint("c", "b", ""),
                      ":1", {"circle"}));
  write("s.urdf", "<sdf/>");
  EXPECT_TRUE(throws_error(ErrorKind::File, folder_ / "s.urdf:1", {"<sdf> is not a robot"},
                           [&] { resolve("[robot]\nfrom = s.urdf\n"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, folder_ / "a.ini", {"describes a robot", "[robot]"},
                           [&] { resolve("[sensor]\nfrom = s.urdf\n"); }));
}

TEST_F(Urdf, TheSimulationHasThePeriodAndTheTolerancesOfTheController) {
  write("nav.yaml",
        "controller_server:\n  ros__parameters:\n    controller_frequency: 20.0\n"
        "    general_goal_checker:\n      plugin: \"nav2_controller::SimpleGoalChecker\"\n"
        "      xy_goal_tolerance: 0.15\n      yaw_goal_tolerance: 0.4\n");
  const auto options =
      read_options<SimulationOptions>(resolve("[simulation]\nfrom = nav.yaml\n"), "simulation");
  EXPECT_EQ(options.control_period, 0.05);
  EXPECT_EQ(options.goal_tolerance, 0.15);
  EXPECT_EQ(options.goal_heading_tolerance, 0.4);
  write("base.yaml",
        "move_base:\n  controller_frequency: 5\nDWAPlannerROS:\n  xy_goal_tolerance: 0.1\n");
  const IniFile ini = resolve("[simulation]\nfrom = base.yaml\ncontrol_period = 0.1\n");
  EXPECT_EQ(ini.get("simulation", "control_period"), "0.1");
  EXPECT_EQ(ini.get("simulation", "goal_tolerance"), "0.1");
}

TEST_F(Urdf, TheStepOfTheSimulationDividesThePeriodOfAnyFrequency) {
  for (const double frequency : {30.0, 7.0, 12.5, 20.0, 200.0}) {
    write("nav.yaml", "controller_server:\n  ros__parameters:\n    controller_frequency: " +
                          std::to_string(frequency) + "\n");
    const auto options =
        read_options<SimulationOptions>(resolve("[simulation]\nfrom = nav.yaml\n"), "simulation");
    EXPECT_NO_THROW(options.check([](const std::string& key) { return key; })) << frequency;
    EXPECT_LE(options.step, SimulationOptions().step);
    EXPECT_GT(options.step, SimulationOptions().step / 2 - 1e-9) << frequency;
  }
}

}  // namespace
}  // namespace slalom
