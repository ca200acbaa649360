// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/random.h>
#include <slalom/robot/holonomic_drive.h>

#include <gtest/gtest.h>
#include <mrpt/kinematics/CVehicleVelCmd_Holo.h>

#include <cmath>

namespace slalom {
namespace {

RobotModel holonomic() {
  RobotModel robot;
  robot.kinematics = Kinematics::Holonomic;
  robot.forward_only = false;
  return robot;
}

void simulate(Vehicle& vehicle, double seconds) {
  for (int i = 0; i < std::lround(seconds / 0.01); ++i) vehicle.advance(0.01);
}

TEST(HolonomicDrive, MovesSidewaysWithoutTurning) {
  HolonomicDrive vehicle(holonomic());
  vehicle.start_at({1, 2, M_PI / 2});
  vehicle.command(0, 0, 0.5);
  simulate(vehicle, 3);
  // It accelerates to 0.5 m/s with 1 m/s^2 over 0.125 m, then moves 2.5 s: 1.375 m to its left, -x.
  const auto& pose = vehicle.getCurrentGTPose();
  EXPECT_NEAR(pose.x, 1 - 1.375, 1e-9);
  EXPECT_NEAR(pose.y, 2, 1e-9);
  EXPECT_NEAR(pose.phi, M_PI / 2, 1e-12);
}

TEST(HolonomicDrive, KeepsItsLimitsUnderAnyCommand) {
  RandomEngine random(5);
  const RobotModel robot = holonomic();
  HolonomicDrive vehicle(robot);
  for (int i = 0; i < 20000; ++i) {
    if (i % 7 == 0)
      vehicle.command(uniform_real(random, -3, 3), uniform_real(random, -9, 9),
                      uniform_real(random, -3, 3));
    const double v = vehicle.v(), vy = vehicle.vy(), w = vehicle.w();
    vehicle.advance(0.01);
    EXPECT_LE(std::hypot(vehicle.v(), vehicle.vy()), robot.max_v + 1e-12);
    EXPECT_LE(std::abs(vehicle.w()), robot.max_w + 1e-12);
    EXPECT_LE(std::hypot(vehicle.v() - v, vehicle.vy() - vy), robot.max_accel_v * 0.01 + 1e-12);
    EXPECT_LE(std::abs(vehicle.w() - w), robot.max_accel_w * 0.01 + 1e-12);
  }
}

TEST(HolonomicDrive, ForwardOnlyExcludesBackwardMotion) {
  RobotModel robot = holonomic();
  robot.forward_only = true;
  HolonomicDrive vehicle(robot);
  vehicle.command(-1, 0, 0.5);
  simulate(vehicle, 2);
  EXPECT_EQ(vehicle.v(), 0);
  EXPECT_DOUBLE_EQ(vehicle.vy(), 0.5);
}

TEST(HolonomicDrive, CanBeCommandedThroughMrptsInterface) {
  HolonomicDrive ours(holonomic()), mrpts(holonomic());
  ours.command(0.6 * std::cos(0.7), 0.4, 0.6 * std::sin(0.7));
  mrpts.sendVelCmd(mrpt::kinematics::CVehicleVelCmd_Holo(0.6, 0.7, 0, 0.4));
  simulate(ours, 1.5);
  simulate(mrpts, 1.5);
  EXPECT_EQ(ours.getCurrentGTPose(), mrpts.getCurrentGTPose());
  EXPECT_NE(mrpts.getVelCmdType(), nullptr);
}

}  // namespace
}  // namespace slalom
