// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/random.h>
#include <slalom/methods/barrier_filter.h>
#include <slalom/methods/registry.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>

namespace slalom {
namespace {

/// Always the same command; reports what it is asked.
class ConstantMethod : public Method {
 public:
  explicit ConstantMethod(Command command) : command_(command) {}
  void reset(const NavigationTask& task) override { resets += static_cast<int>(task.seed); }
  Command step(const Observation&) override { return command_; }
  bool uses_tracks() const override { return true; }
  bool uses_map() const override { return true; }
  void finish(const std::string& outcome) override { outcomes += outcome; }

  static inline int resets = 0;
  static inline std::string outcomes;

 private:
  Command command_;
};

/// Scans of 361 rays all around, 8 m; range(angle) of the center.
mrpt::obs::CObservation2DRangeScan scan_of(const std::function<double(double angle)>& range) {
  constexpr std::size_t kRays = 361;
  mrpt::obs::CObservation2DRangeScan scan;
  scan.aperture = static_cast<float>(2 * M_PI);
  scan.maxRange = 8;
  scan.resizeScan(kRays);
  for (std::size_t i = 0; i < kRays; ++i) {
    const double meters = range(2 * M_PI * (static_cast<double>(i) / (kRays - 1) - 0.5));
    scan.setScanRange(i, static_cast<float>(std::min(meters, 8.0)));
    scan.setScanRangeValidity(i, meters < 8);
  }
  return scan;
}

/// A wall ahead, at x = distance.
double wall(double angle, double distance) {
  return std::cos(angle) > 0 ? distance / std::cos(angle) : 100;
}

struct Given {
  Command desired, measured;
  std::function<double(double)> range;
  RobotModel robot = {};
  BarrierFilterOptions options = {};
};

Command filtered(const Given& given) {
  const auto base = [&](const RobotModel&, const SensorModel&) {
    return std::make_unique<ConstantMethod>(given.desired);
  };
  const auto method = barrier_filter(base, given.options)(given.robot, {});
  NavigationTask task;
  task.control_period = 0.1;
  method->reset(task);
  const auto scan = scan_of(given.range);
  Observation observation;
  observation.v = given.measured.v;
  observation.vy = given.measured.vy;
  observation.w = given.measured.w;
  observation.scan = &scan;
  return method->step(observation);
}

TEST(BarrierFilter, LeavesCommandsInFreeSpace) {
  const Command command = filtered({{1, -0.7}, {1, 0}, [](double) { return 100.0; }});
  EXPECT_EQ(command.v, 1);
  EXPECT_EQ(command.w, -0.7);
}

TEST(BarrierFilter, SlowsTheRobotBeforeAWall) {
  // Disc of 0.25 m at a wall 0.35 m ahead, extended by 0.15 s * 0.4 m/s, margin 0.02 m: h is 0.02
  // m.
  const auto at = [](double distance) { return [=](double a) { return wall(a, distance); }; };
  EXPECT_NEAR(filtered({{0.4, 0}, {}, at(0.35)}).v, 5 * 0.02, 1e-6);
  RobotModel fast;
  fast.max_v = 3;
  fast.max_accel_v = 1;
  BarrierFilterOptions options;
  options.look_ahead = 0;
  // From rest it reaches only 0.1 m/s within a control period.
  EXPECT_EQ(filtered({{3, 0}, {}, at(0.77), fast, options}).v, 3);
  // At 1 m/s the braking distance counts: of 0.5 m 0.4 m are left after 0.1 s, sqrt(2 * 0.7 * 1
  // m/s^2 * 0.4 m).
  EXPECT_NEAR(filtered({{3, 0}, {1, 0}, at(0.77), fast, options}).v, std::sqrt(1.4 * 0.4), 1e-6);
  // A delay of 0.2 s leaves 0.2 m.
  fast.delay = 0.2;
  EXPECT_NEAR(filtered({{3, 0}, {1, 0}, at(0.77), fast, options}).v, std::sqrt(1.4 * 0.2), 1e-6);
}

TEST(BarrierFilter, NeverMovesNearerToWhatIsWithinTheMargin) {
  EXPECT_NEAR(filtered({{0.4, 0}, {}, [](double a) { return wall(a, 0.26); }}).v, 0, 1e-9);
  RobotModel both;
  both.forward_only = false;
  const Command back = filtered({{-0.4, 0}, {}, [](double a) { return wall(a, 0.26); }, both});
  EXPECT_EQ(back.v, -0.4) << "but away from it";
}

TEST(BarrierFilter, TurnsARobotFromAPostBesideItsPath) {
  // A post ahead on the left: the command straight ahead is turned to the right.
  const auto post = [](double angle) { return std::abs(angle - 0.4) < 0.03 ? 0.5 : 100; };
  const Command command = filtered({{1, 0}, {0.5, 0}, post});
  EXPECT_LT(command.v, 1);
  EXPECT_GT(command.v, 0);
  EXPECT_LT(command.w, 0);
  // A disc that rotates in place does not come nearer to anything.
  EXPECT_EQ(filtered({{0, 1.5}, {}, [](double) { return 0.26; }}).w, 1.5);
}

TEST(BarrierFilter, StopsTheCornerOfARectangle) {
  // The corner at (0.4, 0.2) is 0.447 m from the center; turning left it would touch a post there.
  RobotModel robot;
  robot.footprint = "0.4,0.2; -0.4,0.2; -0.4,-0.2; 0.4,-0.2";
  robot.set_radius_of_footprint("robot");
  const double corner = std::atan2(0.2, 0.4);
  const auto post = [=](double angle) {
    return std::abs(angle - corner - 0.15) < 0.02 ? 0.4 : 100;
  };
  EXPECT_LT(filtered({{0, 1}, {}, post, robot}).w, 0.5);
  EXPECT_EQ(filtered({{0, -1}, {}, post, robot}).w, -1);
  robot.footprint = "0.4,0.2; -0.4,0.2; -0.4,-0.2; 0.4,-0.2; 0.1,0";  // its hull is the rectangle
  EXPECT_LT(filtered({{0, 1}, {}, post, robot}).w, 0.5);
}

TEST(BarrierFilter, BrakesARobotThatAlreadyIsBesideThePost) {
  // The extended footprint contains the post; turning away from it is not enough, the disc must not
  // come nearer either.
  const auto post = [](double angle) { return std::abs(angle - 0.6) < 0.03 ? 0.265 : 100; };
  EXPECT_NEAR(filtered({{1, 0}, {0.05, 0}, post}).v, 0, 1e-3);
}

TEST(BarrierFilter, LetsAHolonomicRobotSlideAlongAWall) {
  RobotModel robot;
  robot.kinematics = Kinematics::Holonomic;
  robot.forward_only = false;
  const Command command =
      filtered({{0.6, 0.3, 0.6}, {0, 0, 0.5}, [](double a) { return wall(a, 0.28); }, robot});
  EXPECT_LE(command.v, 5 * 0.01 + 1e-6) << "the wall is 0.01 m beyond the margin";
  EXPECT_GT(command.vy, 0.3) << "slower, as the next points of the wall come nearer";
  EXPECT_EQ(command.w, 0.3);
}

TEST(BarrierFilter, KeepsTheTurningRadius) {
  RobotModel robot;
  robot.min_turning_radius = 0.5;
  const auto post = [](double angle) { return std::abs(angle - 0.4) < 0.03 ? 0.5 : 100; };
  const Command command = filtered({{1, 0}, {0.5, 0}, post, robot});
  EXPECT_GT(command.v, 0);
  EXPECT_LE(std::abs(command.w) * 0.5, command.v + 1e-9);
}

TEST(BarrierFilter, PassesOnACommandBeyondTheLimits) {
  const Command command = filtered({{7, 0}, {}, [](double a) { return wall(a, 0.3); }});
  EXPECT_EQ(command.v, 7) << "it ends the run, as without a filter";
}

TEST(BarrierFilter, IsTheBaseForEverythingElse) {
  const auto base = [](const RobotModel&, const SensorModel&) {
    return std::make_unique<ConstantMethod>(Command{});
  };
  const auto method = barrier_filter(base)({}, {});
  EXPECT_TRUE(method->uses_tracks());
  EXPECT_TRUE(method->uses_map());
  NavigationTask task;
  task.seed = 3;
  task.control_period = 0.1;
  ConstantMethod::resets = 0;
  method->reset(task);
  method->finish("success");
  EXPECT_EQ(ConstantMethod::resets, 3);
  EXPECT_EQ(ConstantMethod::outcomes, "success");
}

TEST(BarrierFilter, AllowsWhatItReturns) {
  // A filter around a filter changes nothing: the command is within all half planes and limits.
  RandomEngine engine(7);
  for (int i = 0; i < 300; ++i) {
    Given given;
    given.robot.forward_only = i % 2 == 0;
    given.options.look_ahead = 0;  // else the extension depends on the command
    if (i % 3 == 0) {
      given.robot.footprint = "0.3,0.2; -0.3,0.2; -0.3,-0.2; 0.3,-0.2";
      given.robot.set_radius_of_footprint("robot");
    }
    given.desired = {uniform_real(engine, given.robot.forward_only ? 0 : -1, 1),
                     uniform_real(engine, -1.5, 1.5)};
    given.measured = {uniform_real(engine, 0, 1), uniform_real(engine, -1, 1)};
    const double nearest = uniform_real(engine, 0.3, 1), phase = uniform_real(engine, 0, 6);
    given.range = [=](double angle) { return nearest + 0.3 * (1 + std::sin(3 * angle + phase)); };
    const Command once = filtered(given);
    std::string reason;
    EXPECT_TRUE(is_valid_command(once, given.robot, reason)) << reason;
    given.desired = once;
    const Command twice = filtered(given);
    EXPECT_NEAR(twice.v, once.v, 1e-6);
    EXPECT_NEAR(twice.w, once.w, 1e-6);
  }
}

}  // namespace
}  // namespace slalom
