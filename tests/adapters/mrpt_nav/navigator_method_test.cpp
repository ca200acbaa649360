#include "error_text.h"
#include "navigator_drive.h"

#include <gtest/gtest.h>

namespace slalom {
namespace {

std::string stock() {
  return std::string("config = ") + kStockConfig + "\n";
}

TEST(NavigatorMethod, StockConfigurationDrivesToTheGoalInAFreeRoom) {
  const auto method = load_navigator(stock());
  const SimulationResult result = drive(*method, navigator_room());
  EXPECT_EQ(result.outcome, Outcome::Success) << result.detail;
  // 7.8 m to the edge of the goal at up to 1 m/s.
  EXPECT_GT(result.trajectory.duration(), 7.8);
  EXPECT_LT(result.trajectory.duration(), 25);
}

TEST(NavigatorMethod, StockConfigurationGetsRoundDiscs) {
  const auto method = load_navigator(stock());
  const SimulationResult result = drive(*method, navigator_room_with_discs());
  EXPECT_EQ(result.outcome, Outcome::Success) << result.detail;
}

}  // namespace
}  // namespace slalom
