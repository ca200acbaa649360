#include <slalom/gui/scale_bar.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

TEST(ScaleBar, IsTheLongestRoundLengthThatFits) {
  // 140 pixels at 30 pixels per m are 4.67 m: 2 m fit, 5 m do not.
  const ScaleBar bar = ScaleBar::choose(30, 140);
  EXPECT_DOUBLE_EQ(bar.metres, 2);
  EXPECT_DOUBLE_EQ(bar.pixels, 60);
  EXPECT_DOUBLE_EQ(ScaleBar::choose(28, 140).metres, 5);   // exactly
  EXPECT_DOUBLE_EQ(ScaleBar::choose(140, 140).metres, 1);  // exactly
  EXPECT_DOUBLE_EQ(ScaleBar::choose(20000, 140).metres, 0.005);
  EXPECT_DOUBLE_EQ(ScaleBar::choose(0.01, 140).metres, 10000);
}

TEST(ScaleBar, FillsAtLeastTwoFifthsOfTheRoom) {
  for (double scale = 0.01; scale < 20000; scale *= 1.07) {
    const ScaleBar bar = ScaleBar::choose(scale, 140);
    EXPECT_LE(bar.pixels, 140 * (1 + 1e-6)) << scale;
    EXPECT_GE(bar.pixels, 140 * 0.4 * (1 - 1e-6)) << scale;  // steps of at most 2.5
  }
}

TEST(ScaleBar, IsToldInTheUnitThatSuitsIt) {
  EXPECT_EQ((ScaleBar{0.005, 0}.text()), "5 mm");
  EXPECT_EQ((ScaleBar{0.2, 0}.text()), "20 cm");
  EXPECT_EQ((ScaleBar{50, 0}.text()), "50 m");
  EXPECT_EQ((ScaleBar{2000, 0}.text()), "2 km");
}

}  // namespace
}  // namespace slalom
