// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "places.h"

#include <slalom/core/read_file.h>
#include <slalom/robot/robot_model.h>
#include <slalom/ros_parameters/resolve.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace slalom {
namespace {

class RosParameters : public testing::Test {
 protected:
  RosParameters() { std::filesystem::create_directories(folder_); }
  ~RosParameters() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    const std::string path = folder_ + "/" + name;
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }

  /// An .ini beside the files, resolved.
  IniFile resolve(const std::string& text) {
    IniFile ini = IniFile::from_text(text, folder_ + "/a.ini");
    reports_ = resolve_ros_parameters(ini);
    return ini;
  }

  /// A method whose controller has this class and these parameters in lines.
  IniFile resolve_controller(const std::string& kind, const std::string& lines,
                             const std::string& keys = "") {
    write("nav.yaml", "controller_server:\n  ros__parameters:\n    FollowPath:\n      plugin: \"" +
                          kind + "\"\n" + lines);
    return resolve("[method.m]\nfrom = nav.yaml\n" + keys);
  }

  /// Whether the controller is refused at nav.yaml:5, the line of its first parameter.
  testing::AssertionResult refuses(const std::string& parameter,
                                   std::initializer_list<std::string> words) {
    return throws_error(ErrorKind::Usage, folder_ + "/nav.yaml:5: ", words, [&] {
      resolve_controller("dwb_core::DWBLocalPlanner", "      " + parameter + "\n");
    });
  }

  const std::string folder_ = (std::filesystem::temp_directory_path() /
                               ("slalom_ros_parameters_" + std::to_string(getpid())))
                                  .string();
  std::vector<RosParameterReport> reports_;
};

const std::string kDwb = "dwb_core::DWBLocalPlanner";
const std::string kRpp = "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController";
const std::string kMppi = "nav2_mppi_controller::MPPIController";
const std::string kAll = "[method.m]\nfrom = " + kRosParameters;

std::string value(const IniFile& ini, const std::string& section, const std::string& key) {
  return ini.get(section, key).value_or("(none)");
}

TEST_F(RosParameters, EveryKeyOfTheDefaultFilesIsMappedOrHasAReason) {
  for (const char* name : {"/humble.yaml", "/jazzy.yaml"}) {
    resolve(kAll + name + "\n");
    ASSERT_EQ(reports_.size(), 1U);
    EXPECT_TRUE(reports_[0].unknown.empty()) << reports_[0].listing();
    for (const RosParameterReport::Line& line : reports_[0].without_counterpart)
      EXPECT_FALSE(line.result.empty()) << line.parameter;
  }
}

TEST_F(RosParameters, DwbBecomesDwaLocalPlanner) {
  const IniFile ini = resolve(kAll + "/humble.yaml\n");
  const std::vector<std::pair<std::string, std::string>> expected = {
      {"adapter", "library"},
      {"plugin", "libslalom_dwa_local_planner.so"},
      {"min_vel_x", "-0.1"},
      {"max_vel_x", "0.6"},
      {"max_vel_theta", "1.2"},
      {"min_vel_trans", "0.05"},
      {"min_vel_theta", "0.3"},
      {"acc_lim_x", "1.5"},
      {"acc_lim_theta", "2.5"},
      {"vx_samples", "8"},
      {"vth_samples", "21"},
      {"sim_time", "1.5"},
      {"sim_granularity", "0.04"},
      {"angular_sim_granularity", "0.05"},
      {"occdist_scale", "0.03"},
      {"path_distance_bias", "10"},  // 20 * 0.5: MapGridCritic::getScale() of dwb_critics
      {"goal_distance_bias", "5"},
      {"forward_point_distance", "0.2"},
      {"width", "4"},
      {"resolution", "0.04"},
      {"inflation_radius", "0.6"},
      {"cost_scaling_factor", "4"},
      {"obstacle_range", "3.5"},
      {"raytrace_range", "4"}};
  for (const auto& [key, text] : expected) EXPECT_EQ(value(ini, "method.m", key), text) << key;
  EXPECT_EQ(ini.keys("method.m").size(), expected.size());
}

TEST_F(RosParameters, MppiTakesItsHorizonInControlPeriodsAndItsControlCostPerTemperature) {
  const std::string method = kAll + "/jazzy.yaml\n[robot]\nradius = 0.25\n";
  const IniFile ini = resolve(method);
  EXPECT_EQ(value(ini, "method.m", "steps"), "40");  // 40 * 0.1 s / 0.1 s
  EXPECT_EQ(value(ini, "method.m", "samples"), "500");
  EXPECT_EQ(value(ini, "method.m", "noise_v"), "0.075");  // 0.15 * sqrt(0.1 s / 0.4 s)
  EXPECT_EQ(value(ini, "method.m", "noise_w"), "0.25");
  EXPECT_NEAR(std::stod(value(ini, "method.m", "control_cost")), 0.02 / 0.2, 1e-12);
  EXPECT_NEAR(std::stod(value(ini, "method.m", "comfort")), 0.6 - 0.25, 1e-12);
  EXPECT_EQ(value(resolve(method + "[simulation]\ncontrol_period = 0.05\n"), "method.m", "steps"),
            "80");
}

TEST_F(RosParameters, RobotsHaveTheFootprintOfTheCostmapAndTheLimitsOfTheController) {
  const RobotModel mppi =
      read_robot_model(resolve("[robot]\nfrom = " + kRosParameters + "/jazzy.yaml\n"));
  EXPECT_EQ(mppi.shape().corners().size(), 4U);
  EXPECT_NEAR(mppi.radius, std::hypot(0.3, 0.2), 1e-12);
  EXPECT_EQ(mppi.max_v, 0.7);
  EXPECT_EQ(mppi.max_w, 1.4);
  EXPECT_EQ(mppi.max_accel_v, 2);
  EXPECT_EQ(mppi.max_accel_w, 2.5);
  EXPECT_EQ(mppi.min_turning_radius, 0.3);
  EXPECT_TRUE(mppi.forward_only);
  const RobotModel dwb =
      read_robot_model(resolve("[robot]\nfrom = " + kRosParameters + "/humble.yaml\n"));
  EXPECT_EQ(dwb.radius, 0.2);
  EXPECT_EQ(dwb.max_v, 0.6);
  EXPECT_FALSE(dwb.forward_only);
}

TEST_F(RosParameters, TheSpeedAheadIsAtMostThatOfAnyDirection) {
  // Both planners reject what is faster; a negative limit is none (KinematicParameters of dwb).
  const std::string dwb = "      max_vel_x: 0.5\n      max_speed_xy: ";
  for (const auto& [limit, speed] : {std::pair("0.3", "0.3"), {"0.8", "0.5"}, {"-1.0", "0.5"}}) {
    EXPECT_EQ(value(resolve_controller(kDwb, dwb + limit + "\n"), "method.m", "max_vel_x"), speed);
    const IniFile robot = resolve("[robot]\nfrom = nav.yaml\n");
    EXPECT_EQ(value(robot, "robot", "max_v"), speed) << limit;
  }
  write("dwa.yaml", "DWAPlannerROS: {max_vel_x: 0.5, max_vel_trans: 0.3}\n");
  EXPECT_EQ(value(resolve("[robot]\nfrom = dwa.yaml\n"), "robot", "max_v"), "0.3");
}

TEST_F(RosParameters, LimitsThatTheControllerDoesNotHaveAreThoseOfTheSmoother) {
  write("nav.yaml",
        "FollowPath: {plugin: \"" + kRpp +
            "\", desired_linear_vel: 0.4}\n"
            "velocity_smoother: {max_velocity: [0.9, 0, 2.5], max_accel: [1.5, 0, 4]}\n");
  const RobotModel robot = read_robot_model(resolve("[robot]\nfrom = nav.yaml\n"));
  EXPECT_EQ(robot.max_v, 0.4);
  EXPECT_EQ(robot.max_w, 2.5);
  EXPECT_EQ(robot.max_accel_v, 1.5);
  EXPECT_EQ(robot.max_accel_w, 4);
}

TEST_F(RosParameters, TheSensorSeesAsFarAsTheSourcesOfTheCostmap) {
  write("nav.yaml",
        "local_costmap: {layer: {scan: {obstacle_max_range: 2.5}, depth: {obstacle_max_range: "
        "4}}}\n");
  EXPECT_EQ(value(resolve("[sensor]\nfrom = nav.yaml\n"), "sensor", "max_range"), "4");
}

TEST_F(RosParameters, KeysOfTheIniOverrideTheFile) {
  const IniFile ini =
      resolve(kAll + "/humble.yaml\nsim_time = 3\n[robot]\nradius = 0.3\nfrom = " + kRosParameters +
              "/jazzy.yaml\n");
  EXPECT_EQ(value(ini, "method.m", "sim_time"), "3");
  EXPECT_EQ(value(ini, "robot", "radius"), "0.3");
  EXPECT_FALSE(ini.get("robot", "footprint"));
  for (const RosParameterReport& report : reports_) EXPECT_EQ(report.overridden.size(), 1U);
}

TEST_F(RosParameters, TheIniHasNoTraceOfTheFile) {
  const std::string text =
      resolve(kAll + "/humble.yaml\n[robot]\nfrom = " + kRosParameters + "/humble.yaml\n")
          .canonical_text();
  EXPECT_EQ(text.find("yaml"), std::string::npos) << text;
  EXPECT_EQ(text.find("from"), std::string::npos) << text;
}

TEST_F(RosParameters, RegulatedPurePursuitIsRegulatedOnlyWhereItsFlagsSaySo) {
  const std::string lines =
      "      lookahead_dist: 0.7\n      min_lookahead_dist: 0.2\n      max_lookahead_dist: 1.1\n"
      "      regulated_linear_scaling_min_radius: 0.8\n      cost_scaling_dist: 0.55\n"
      "      max_allowed_time_to_collision_up_to_carrot: 2\n      rotate_to_heading_min_angle: "
      "0.6\n";
  const IniFile on = resolve_controller(
      kRpp, lines + "      use_velocity_scaled_lookahead_dist: true\n", "[robot]\nradius = 0.25\n");
  const auto& lines_on = reports_[0].without_counterpart;
  EXPECT_EQ(std::count_if(lines_on.begin(), lines_on.end(),
                          [](const auto& line) {
                            return line.parameter == "FollowPath.lookahead_dist = 0.7";
                          }),
            1);
  EXPECT_EQ(value(on, "method.m", "min_lookahead_dist"), "0.2");
  EXPECT_EQ(value(on, "method.m", "max_lookahead_dist"), "1.1");
  EXPECT_EQ(value(on, "method.m", "regulated_linear_scaling_min_radius"), "0.8");
  EXPECT_NEAR(std::stod(value(on, "method.m", "cost_scaling_dist")), 0.55 - 0.25, 1e-12);
  EXPECT_EQ(value(on, "method.m", "rotate_to_heading_min_angle"), "0.6");
  const IniFile off = resolve_controller(
      kRpp,
      lines +
          "      use_velocity_scaled_lookahead_dist: no\n      use_collision_detection: False\n"
          "      use_regulated_linear_velocity_scaling: no\n"
          "      use_cost_regulated_linear_velocity_scaling: off\n"
          "      use_rotate_to_heading: false\n");
  EXPECT_EQ(value(off, "method.m", "min_lookahead_dist"), "0.7");
  EXPECT_EQ(value(off, "method.m", "max_lookahead_dist"), "0.7");
  EXPECT_EQ(value(off, "method.m", "regulated_linear_scaling_min_radius"), "0");
  EXPECT_EQ(value(off, "method.m", "cost_scaling_dist"), "0");
  EXPECT_EQ(value(off, "method.m", "max_allowed_time_to_collision_up_to_carrot"), "0");
  EXPECT_NEAR(std::stod(value(off, "method.m", "rotate_to_heading_min_angle")), M_PI, 1e-12);
  EXPECT_TRUE(reports_[0].unknown.empty()) << reports_[0].listing();
}

TEST_F(RosParameters, ARotationShimIsItsPrimaryController) {
  const IniFile ini =
      resolve_controller("nav2_rotation_shim_controller::RotationShimController",
                         "      primary_controller: \"" + kRpp +
                             "\"\n      angular_dist_threshold: 0.8\n      lookahead_time: 1.2\n");
  EXPECT_EQ(value(ini, "method.m", "plugin"), "libslalom_regulated_pure_pursuit.so");
  EXPECT_EQ(value(ini, "method.m", "lookahead_time"), "1.2");
  EXPECT_TRUE(reports_[0].unknown.empty()) << reports_[0].listing();
}

TEST_F(RosParameters, FilesOfMoveBaseNeedNoSectionsOfNodes) {
  write("common.yaml",
        "footprint: [[0.3, 0.2], [-0.3, 0.2], [-0.3, -0.2], [0.3, -0.2]]\n"
        "obstacle_layer: {scan: {obstacle_range: 3.5, raytrace_range: 4}}\n");
  write("local.yaml", "local_costmap: {width: 5.0, resolution: 0.1, static_map: false}\n");
  write("planner.yaml",
        "controller_patience: 4\nDWAPlannerROS: {max_vel_trans: 0.5, max_rot_vel: 1, "
        "occdist_scale: 0.02, min_rot_vel: -0.3}\n");
  const std::string files = "from = common.yaml, local.yaml, planner.yaml\n";
  const IniFile ini = resolve("[method.m]\n" + files + "[robot]\n" + files);
  EXPECT_EQ(read_robot_model(ini).shape().corners().size(), 4U);
  EXPECT_EQ(value(ini, "robot", "max_w"), "1");
  EXPECT_EQ(value(ini, "method.m", "plugin"), "libslalom_dwa_local_planner.so");
  EXPECT_EQ(value(ini, "method.m", "width"), "5");
  EXPECT_EQ(value(ini, "method.m", "obstacle_range"), "3.5");
  EXPECT_EQ(value(ini, "method.m", "raytrace_range"), "4");
  EXPECT_EQ(value(ini, "method.m", "controller_patience"), "4");
  EXPECT_EQ(value(ini, "method.m", "min_vel_theta"), "0.3");
}

TEST_F(RosParameters, OtherPlannersOfMoveBaseBecomeTheirMethods) {
  write("a.yaml",
        "move_base:\n  TrajectoryPlannerROS: {pdist_scale: 0.9, gdist_scale: 0.6, sim_time: 2}\n"
        "  EBandPlannerROS: {k_prop: 3, num_iterations_eband_optimization: 5}\n"
        "  TebLocalPlannerROS: {max_vel_x: 0.4, weight_obstacle: 50}\n");
  const IniFile rollout = resolve("[method.m]\nfrom = a.yaml\ncontroller = TrajectoryPlannerROS\n");
  EXPECT_EQ(value(rollout, "method.m", "plugin"), "libslalom_trajectory_rollout.so");
  EXPECT_NEAR(std::stod(value(rollout, "method.m", "gamma")), 0.9 / 0.6, 1e-12);
  EXPECT_EQ(value(rollout, "method.m", "horizon"), "2");
  const IniFile bands = resolve("[method.m]\nfrom = a.yaml\ncontroller = EBandPlannerROS\n");
  EXPECT_EQ(value(bands, "method.m", "num_iterations_eband_optimization"), "5");
  const IniFile robot = resolve("[robot]\nfrom = a.yaml\ncontroller = TebLocalPlannerROS\n");
  EXPECT_EQ(value(robot, "robot", "max_v"), "0.4");
  EXPECT_TRUE(throws_error(ErrorKind::Usage, folder_ + "/a.yaml:4: ", {"TebLocalPlannerROS"}, [&] {
    resolve("[method.m]\nfrom = a.yaml\ncontroller = TebLocalPlannerROS\n");
  }));
}

TEST_F(RosParameters, NamespacesAreLookedThrough) {
  write("a.yaml",
        "/robot1/local_costmap:\n  local_costmap:\n    ros__parameters: {robot_radius: 0.2}\n");
  EXPECT_EQ(value(resolve("[robot]\nfrom = a.yaml\n"), "robot", "radius"), "0.2");
  write("b.yaml",
        "r1: {local_costmap: {robot_radius: 0.2}}\nr2: {local_costmap: {robot_radius: 0.3}}\n");
  EXPECT_TRUE(throws_error(ErrorKind::Usage, folder_ + "/b.yaml:2: r2.local_costmap",
                           {"r1.local_costmap", "one robot"},
                           [&] { resolve("[robot]\nfrom = b.yaml\n"); }));
}

TEST_F(RosParameters, UnknownParametersAreNamedWithTheirLine) {
  resolve_controller(kDwb, "      sim_tiem: 2\n");
  ASSERT_EQ(reports_[0].unknown.size(), 1U);
  EXPECT_TRUE(mentions(reports_[0].summary(), {"nav.yaml:5: ", "FollowPath.sim_tiem"}));
}

TEST_F(RosParameters, ValuesOfOtherKindsAreNamedWithWhatIsExpected) {
  EXPECT_TRUE(refuses("max_vel_x: fast", {"FollowPath.max_vel_x", "'fast'", "number"}));
  EXPECT_TRUE(refuses("max_vel_x: .inf", {"'.inf'", "a finite number"}));
  EXPECT_TRUE(refuses("max_vel_x:", {"''", "number"}));
  EXPECT_TRUE(refuses("max_vel_x: [1, 2]", {"is a list", "number"}));
  EXPECT_TRUE(refuses("vx_samples: 2.5", {"'2.5'", "integer"}));
  EXPECT_TRUE(refuses("max_vel_x: $(var speed)", {"'$(var speed)'", "substitution"}));
}

/// Like rcl_yaml_param_parser and rosparam, a later value overwrites an earlier one.
TEST_F(RosParameters, TheLastValueOfAKeyThatIsGivenTwiceCountsWithANoteOfBothLines) {
  const IniFile ini = resolve_controller(
      "my::Shim", "      max_vel_x: 1\n      plugin: " + kDwb + "\n      max_vel_x: 2\n");
  EXPECT_EQ(value(ini, "method.m", "max_vel_x"), "2");
  EXPECT_EQ(value(ini, "method.m", "plugin"), "libslalom_dwa_local_planner.so");
  const std::string file = folder_ + "/nav.yaml:", name = ": controller_server.FollowPath.";
  EXPECT_EQ(reports_[0].repeated,
            (std::vector<std::string>{file + "6" + name + "plugin, which replaces line 4",
                                      file + "7" + name + "max_vel_x, which replaces line 5"}));
  for (const std::string& text : {reports_[0].summary(), reports_[0].listing()})
    EXPECT_TRUE(mentions(text, {"given twice", "replaces line 4", "replaces line 5"}));
}

/// ObstacleFootprintCritic::getScale() of dwb_critics: resolution * scale; BaseObstacleCritic has
/// the scale itself.
TEST_F(RosParameters, TheScaleOfObstacleFootprintIsPerCell) {
  const auto resolved = [&](const std::string& critic, const std::string& costmap) {
    write("a.yaml", "A: {plugin: \"" + kDwb + "\", " + critic + ".scale: 0.02}\nlocal_costmap: {" +
                        costmap + "}\n");
    return value(resolve("[method.m]\nfrom = a.yaml\n"), "method.m", "occdist_scale");
  };
  EXPECT_EQ(std::stod(resolved("ObstacleFootprint", "resolution: 0.05")), 0.05 * 0.02);
  EXPECT_EQ(std::stod(resolved("ObstacleFootprint", "width: 3")), 0.1 * 0.02) << "Nav2's default";
  EXPECT_EQ(resolved("BaseObstacle", "resolution: 0.05"), "0.02");
}

TEST_F(RosParameters, CriticsThatAreNotListedHaveNoEffect) {
  const IniFile ini =
      resolve_controller(kDwb,
                         "      critics: [PathDist, BaseObstacle]\n      PathDist.scale: 32\n"
                         "      GoalDist.scale: 24\n      ObstacleFootprint.scale: 0.5\n"
                         "      BaseObstacle.scale: 0.02\n");
  EXPECT_EQ(value(ini, "method.m", "path_distance_bias"), "16");
  EXPECT_EQ(value(ini, "method.m", "occdist_scale"), "0.02");
  EXPECT_FALSE(ini.get("method.m", "goal_distance_bias"));
  EXPECT_TRUE(mentions(reports_[0].listing(), {"FollowPath.GoalDist.scale: critics does not list",
                                               "FollowPath.ObstacleFootprint.scale: critics"}));
}

/// Its parameter use_velocity_scaled_lookahead_dist is false and lookahead_dist 0.6 by default.
TEST_F(RosParameters, TheLookAheadOfRegulatedPurePursuitIsFixedUnlessItIsScaled) {
  const std::string limits = "      min_lookahead_dist: 0.2\n      max_lookahead_dist: 1.1\n";
  const std::string fixed = "      lookahead_dist: 0.7\n";
  const auto look_ahead = [&](const std::string& lines) {
    const IniFile ini = resolve_controller(kRpp, lines);
    return value(ini, "method.m", "min_lookahead_dist") + " " +
           value(ini, "method.m", "max_lookahead_dist");
  };
  EXPECT_EQ(look_ahead(fixed), "0.7 0.7");
  EXPECT_EQ(look_ahead(limits + fixed), "0.7 0.7");
  EXPECT_EQ(look_ahead(limits), "0.6 0.6");
  EXPECT_EQ(look_ahead(limits + fixed + "      use_velocity_scaled_lookahead_dist: true\n"),
            "0.2 1.1");
}

/// The variance of a distance after `T` is T * duration of a sample * std^2.
TEST_F(RosParameters, NoiseOfMppiSpreadsRolloutsAsInNav2) {
  const std::string lines = "      model_dt: 0.05\n      vx_std: 0.2\n      wz_std: 0.4\n";
  const IniFile ini =
      resolve_controller(kMppi, lines, "hold = 2\n[simulation]\ncontrol_period = 0.2\n");
  const double v = std::stod(value(ini, "method.m", "noise_v"));
  const double w = std::stod(value(ini, "method.m", "noise_w"));
  EXPECT_NEAR(2 * 0.2 * v * v, 0.05 * 0.2 * 0.2, 1e-12);
  EXPECT_NEAR(2 * 0.2 * w * w, 0.05 * 0.4 * 0.4, 1e-12);
}

TEST_F(RosParameters, LayersAndSourcesThatAreNotInUseDoNotSetTheRangeOfTheSensor) {
  const std::string scan = "scan: {obstacle_max_range: 2.5}, ";
  const auto range = [&](const std::string& costmap) {
    write("nav.yaml", "local_costmap: {" + costmap + "}\n");
    return value(resolve("[sensor]\nfrom = nav.yaml\n"), "sensor", "max_range");
  };
  const std::string depth = "depth: {obstacle_max_range: 4}";
  EXPECT_EQ(range("a_layer: {" + scan + depth + "}"), "4");
  EXPECT_EQ(range("a_layer: {observation_sources: scan, " + scan + depth + "}"), "2.5");
  EXPECT_EQ(range("a_layer: {observation_sources: scan depth, " + scan + depth + "}"), "4");
  EXPECT_EQ(range("a_layer: {" + scan + "}, b_layer: {enabled: False, " + depth + "}"), "2.5");
  EXPECT_EQ(range("plugins: [a_layer], a_layer: {" + scan + "}, b_layer: {" + depth + "}"), "2.5");
  EXPECT_EQ(range("plugins: [{name: a_layer}], a_layer: {" + scan + "}, b_layer: {" + depth + "}"),
            "4")
      << "ROS 1";
  EXPECT_EQ(range("observation_sources: scan, " + scan + depth), "2.5");
}

TEST_F(RosParameters, ParametersOfACostmapInMoveBaseAreListedOnce) {
  write("dump.yaml",
        "move_base:\n  DWAPlannerROS: {max_vel_x: 0.2}\n  local_costmap: {inflation_radius: 1}\n"
        "  global_costmap: {inflation_radius: 2}\n  controller_patience: 4\n");
  const IniFile ini = resolve("[method.m]\nfrom = dump.yaml\n");
  EXPECT_EQ(value(ini, "method.m", "inflation_radius"), "1");
  EXPECT_EQ(value(ini, "method.m", "controller_patience"), "4");
  EXPECT_TRUE(reports_[0].unknown.empty()) << reports_[0].listing();
}

TEST_F(RosParameters, FootprintsAreChecked) {
  const auto refused = [&](const std::string& footprint, const std::string& word) {
    write("a.yaml", "local_costmap:\n  footprint: " + footprint + "\n");
    return throws_error(ErrorKind::Usage, folder_ + "/a.yaml:2: local_costmap.footprint", {word},
                        [&] { resolve("[robot]\nfrom = a.yaml\n"); });
  };
  EXPECT_TRUE(refused("\"[[1, 1], [2, 2]]\"", "3 to"));
  EXPECT_TRUE(refused("\"[[1, 1], [-1, -1], [1, -1], [-1, 1]]\"", "do not meet"));
  EXPECT_TRUE(refused("[[1, 0], [-1, 1], [x, -1]]", "corners"));
  EXPECT_TRUE(refused("$(var footprint)", "substitution"));
  write("a.yaml", "move_base: {footprint: [[0.3, 0.2], [-0.3, 0.2], [-0.3, -0.2], [0.3, -0.2]]}\n");
  const auto above = resolve("[robot]\nfrom = a.yaml\n");
  EXPECT_EQ(value(above, "robot", "footprint"), "0.3,0.2;-0.3,0.2;-0.3,-0.2;0.3,-0.2")
      << "of move_base";
  write("a.yaml", "local_costmap: {footprint: \"[]\", robot_radius: 0.3}\n");
  EXPECT_EQ(value(resolve("[robot]\nfrom = a.yaml\n"), "robot", "radius"), "0.3");
}

TEST_F(RosParameters, AControllerMustBeChosenAndKnown) {
  write("a.yaml", "controller_server: {controller_plugins: [A, B], A: {plugin: \"" + kDwb +
                      "\"}, B: {plugin: \"my::Controller\"}}\n");
  const std::string ini = folder_ + "/a.ini:";
  EXPECT_TRUE(throws_error(ErrorKind::Usage, ini + "2: [method.m] from", {"controller = A or B"},
                           [&] { resolve("[method.m]\nfrom = a.yaml\n"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, ini + "3: [method.m] controller", {"'C'", "A, B"},
                           [&] { resolve("[method.m]\nfrom = a.yaml\ncontroller = C\n"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, folder_ + "/a.yaml:1: ", {"my::Controller", "DWB"},
                           [&] { resolve("[method.m]\nfrom = a.yaml\ncontroller = B\n"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, ini + "3: [method.m] plugin",
                           {"'A'", "libslalom_dwa_local_planner.so", "controller"}, [&] {
                             resolve("[method.m]\nfrom = a.yaml\nplugin = A\ncontroller = A\n");
                           }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, ini + "3: [method.m] adapter", {"library"}, [&] {
    resolve("[method.m]\nfrom = a.yaml\nadapter = python\ncontroller = A\n");
  }));
  write("b.yaml", "local_costmap: {robot_radius: 0.3}\n");
  EXPECT_TRUE(throws_error(ErrorKind::Usage, ini + "2: [method.m] from", {"no controller"},
                           [&] { resolve("[method.m]\nfrom = b.yaml\n"); }));
}

TEST_F(RosParameters, FilesThatAreNotParametersAreRefused) {
  const auto refused = [&](const std::string& text, const std::string& line,
                           std::initializer_list<std::string> words) {
    return throws_error(ErrorKind::File, write("a.yaml", text) + line, words,
                        [&] { resolve("[robot]\nfrom = a.yaml\n"); });
  };
  EXPECT_TRUE(refused("a: [1\nb: 2", ":2: ", {"not YAML"}));
  EXPECT_TRUE(refused("- 1\n", ":1: ", {"no keys"}));
  EXPECT_TRUE(refused("", "", {"no keys"}));
  EXPECT_TRUE(refused("a:\n  ? [b]\n  : 1\n", ":2: ", {"key"}));
  EXPECT_TRUE(refused("a: &a\n  b: *a\n", ":2: ", {"levels"}));  // without an end
  std::string aliases = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int i = 1; i < 10; ++i) {
    const std::string last = "*a" + std::to_string(i - 1);
    aliases += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + last;
    for (int k = 1; k < 10; ++k) aliases += ", " + last;
    aliases += "]\n";
  }
  EXPECT_TRUE(refused(aliases, ":1: ", {"5000 values"}));  // 10^10 of them
  EXPECT_TRUE(throws_error(ErrorKind::File, "missing.yaml: ", {},
                           [&] { resolve("[robot]\nfrom = missing.yaml\n"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, folder_ + "/a.ini:2: [robot] from", {"no file"},
                           [&] { resolve("[robot]\nfrom = ,\n"); }));
}

TEST_F(RosParameters, TextOfTheFileNeverBecomesAKeyOfTheIni) {
  EXPECT_TRUE(refuses("max_vel_x: \"1\\n[limits]\\nnetwork = true\"", {"number"}));
  write("a.yaml", "local_costmap: {footprint: \"[[1,1],[-1,1],[-1,-1],[1,-1]]\"}\n");
  EXPECT_EQ(value(resolve("[robot]\nfrom = a.yaml\n"), "robot", "footprint"),
            "1,1;-1,1;-1,-1;1,-1");
}

TEST_F(RosParameters, TheDiffWritesTheValuesOfTheIniIntoTheFile) {
  const std::string text =
      "FollowPath:  # the only one\n  plugin: " + kDwb +
      "\n  PathDist.scale: 32.0  # weight\n  more: {sim_time: 9}\n  sim_time: 1.7\n"
      "local_costmap: {width: 3, resolution: 0.05, a: {inflation_radius: 0.5}}\n";
  const std::string path = write("nav.yaml", text);
  const std::string keys =
      "[method.m]\nfrom = nav.yaml\npath_distance_bias = 20\nsim_time = 1.7\nresolution = 0.1\n"
      "width = 4.5\nvx_samples = 9\n";
  resolve(keys);
  EXPECT_EQ(
      ros_parameter_diff(reports_),
      "--- " + path + "\n+++ " + path +
          "\n@@ -3 +3 @@\n-  PathDist.scale: 32.0  # weight\n+  PathDist.scale: 40  # weight\n"
          "@@ -6 +6 @@\n-local_costmap: {width: 3, resolution: 0.05, a: {inflation_radius: "
          "0.5}}\n+local_costmap: {width: 4.5, resolution: 0.1, a: {inflation_radius: 0.5}}\n");
  EXPECT_EQ(reports_[0].not_in_file, (std::vector<std::string>{"FollowPath.vx_samples: 9"}));
  const std::string patch = write("tuned.diff", ros_parameter_diff(reports_));
  ASSERT_EQ(std::system(("patch -s -d / -p0 <" + patch).c_str()), 0);
  resolve(keys);
  EXPECT_EQ(ros_parameter_diff(reports_), "");
}

TEST_F(RosParameters, PatchAppliesADiffOfAdjacentLinesAndOfALastLineWithoutItsBreak) {
  const std::string head = "A:\n  plugin: " + kDwb + "\n";
  const std::string path = write("nav.yaml", head + "  sim_time: 1\n  vx_samples: 5");
  resolve("[method.m]\nfrom = nav.yaml\nsim_time = 2\nvx_samples = 6\n");
  const std::string patch = write("tuned.diff", ros_parameter_diff(reports_));
  ASSERT_EQ(std::system(("patch -s -d / -p0 <" + patch).c_str()), 0);
  EXPECT_EQ(read_text(path, "parameters", kMaxConfigSize), head + "  sim_time: 2\n  vx_samples: 6");
}

TEST_F(RosParameters, TheWayBackIsExactOrNone) {
  // A radius of 0.25 m is subtracted from cost_scaling_dist; a switch does not become a number.
  write("nav.yaml", "A:\n  plugin: " + kRpp +
                        "\n  cost_scaling_dist: 0.6\n  lookahead_dist: 0.5\n"
                        "  use_velocity_scaled_lookahead_dist: true\n"
                        "  use_rotate_to_heading: false\n");
  resolve(
      "[method.m]\nfrom = nav.yaml\ncost_scaling_dist = 0.2\nmin_lookahead_dist = 0.3\n"
      "rotate_to_heading_min_angle = 1\nmemory = 3\n");
  const std::vector<EditedRosParameters> edited = edit_ros_parameters(reports_);
  ASSERT_EQ(edited.size(), 1U);
  EXPECT_NE(edited[0].text.find("\n  cost_scaling_dist: 0.45\n  lookahead_dist: 0.5\n"),
            std::string::npos)
      << edited[0].text;
  EXPECT_EQ(reports_[0].not_in_file, (std::vector<std::string>{"A.min_lookahead_dist: 0.3"}));
  EXPECT_EQ(reports_[0].no_way_back,
            (std::vector<std::string>{"rotate_to_heading_min_angle", "memory"}));
}

TEST_F(RosParameters, TheDiffRefusesWhatItCannotWrite) {
  const std::string path = write("nav.yaml", "A:\n  plugin: " + kDwb +
                                                 "\n  sim_time: \"1.7\"\n"
                                                 "  max_vel_x: 1\n");
  resolve("[method.m]\nfrom = nav.yaml\nsim_time = 2\n");
  EXPECT_TRUE(throws_error(ErrorKind::File, path + ":3: ", {"'1.7'", "without quotes"},
                           [&] { ros_parameter_diff(reports_); }));
  resolve("[method.m]\nfrom = nav.yaml\nmax_vel_x = 2\n[robot]\nfrom = nav.yaml\nmax_v = 3\n");
  EXPECT_TRUE(throws_error(ErrorKind::Usage, path + ":4: ", {"3 and 2", "same value"},
                           [&] { ros_parameter_diff(reports_); }));
}

}  // namespace
}  // namespace slalom
