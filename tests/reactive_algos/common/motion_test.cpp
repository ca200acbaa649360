#include "common/motion.h"
#include "common/settings.h"
#include "observations.h"

#include <gtest/gtest.h>

namespace reactive {
namespace {

TEST(Wrapped, BringsAnglesIntoOneTurn) {
  EXPECT_NEAR(wrapped(3 * kPi), kPi, 1e-12);
  EXPECT_NEAR(wrapped(-kPi), kPi, 1e-12);
  EXPECT_NEAR(wrapped(-0.5), -0.5, 1e-12);
}

TEST(Moved, DrivesACircle) {
  // Radius v / w = 2 m; a quarter of it takes (pi / 2) / 0.5 s.
  const Pose quarter = moved({0, 0, 0}, {1, 0.5}, kPi);
  EXPECT_NEAR(quarter.x, 2, 1e-9);
  EXPECT_NEAR(quarter.y, 2, 1e-9);
  EXPECT_NEAR(quarter.phi, kPi / 2, 1e-9);
  EXPECT_NEAR(moved({1, 2, kPi / 2}, {1, 0}, 3).y, 5, 1e-9);
}

TEST(FreeArc, EndsWhereTheDiscTouches) {
  const LocalMap map = map_of({{2, -4, 2, 4}});
  // Straight ahead the disc of 0.25 m touches after 1.75 m.
  EXPECT_NEAR(free_arc(map.clearance(), {}, {0.5, 0}, 0.25, 5), 1.75, 0.03);
  // On a circle of 1 m to the left its centre reaches x = 1 only: 0.75 m of room remain.
  EXPECT_NEAR(free_arc(map.clearance(), {}, {0.5, 0.5}, 0.25, 5), 5, 1e-9);
  EXPECT_NEAR(free_arc(map.clearance(), {}, {0, 1}, 0.25, 5), 5, 1e-9);
}

TEST(RadiusToKeep, IsLessWhereTheRobotCameTooNear) {
  Robot robot;
  robot.radius = 0.25;
  EXPECT_NEAR(radius_to_keep(map_of({}).clearance(), {}, robot, 0.1), 0.35, 1e-9);
  const LocalMap near = map_of({{0.3, -1, 0.3, 1}});
  EXPECT_NEAR(radius_to_keep(near.clearance(), {}, robot, 0.1), 0.295, 0.01);
}

TEST(TurnOnTheSpot, BeginsAndEndsAtDifferentAngles) {
  TurnOnTheSpot turn(1.2, 0.4);
  EXPECT_FALSE(turn.wanted(1.1));
  EXPECT_TRUE(turn.wanted(1.3));
  EXPECT_TRUE(turn.wanted(0.5));
  EXPECT_FALSE(turn.wanted(0.3));
}

TEST(TurnOnTheSpot, DoesNotTurnBackWhenTheWayPassesStraightBehind) {
  TurnOnTheSpot turn(1.2, 0.4);
  EXPECT_TRUE(turn.wanted(3.0));
  EXPECT_TRUE(turn.wanted(-3.0));
  EXPECT_GT(turn.speeds(-3.0, {}).w, 0);
  // Once the way is ahead on the other side, that side counts.
  EXPECT_TRUE(turn.wanted(-1.0));
  EXPECT_LT(turn.speeds(-1.0, {}).w, 0);
}

TEST(TurningSpeed, CanBeStoppedWithinTheAngle) {
  const Robot robot;
  for (const double angle : {-2.0, -0.3, 0.05, 0.4, 3.0}) {
    const double w = turning_speed(angle, robot);
    EXPECT_LE(w * w / (2 * robot.max_accel_w), std::abs(angle));
    EXPECT_GT(w * angle, 0);
    EXPECT_LE(std::abs(w), robot.max_w);
  }
}

struct Numbers {
  double a = 1, b = 2;
};
constexpr Setting<Numbers> kNumbers[] = {{{"a", "1", "m", "at least 0"}, &Numbers::a},
                                         {{"b", "2", "-", "bounded"}, &Numbers::b, 1, 3}};

std::string refusal(const char* key, const char* text) {
  Numbers numbers;
  char error[200] = "";
  return apply(kNumbers, key, text, numbers, error, sizeof error) ? "" : error;
}

TEST(Settings, TakeNumbersOfTheirRange) {
  Numbers numbers;
  char error[200];
  EXPECT_TRUE(apply(kNumbers, "b", "2.5", numbers, error, sizeof error));
  EXPECT_EQ(numbers.b, 2.5);
  EXPECT_EQ(refusal("a", "-1"), "a = '-1' is no number >= 0");
  EXPECT_EQ(refusal("b", "4"), "b = '4' is no number in [1, 3]");
  for (const char* text : {"nan", "inf", "1x", "", "x"}) EXPECT_NE(refusal("a", text), "") << text;
  EXPECT_EQ(refusal("c", "1"), "unknown parameter c");
}

}  // namespace
}  // namespace reactive
