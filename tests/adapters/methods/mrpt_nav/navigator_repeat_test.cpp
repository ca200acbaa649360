// SPDX-License-Identifier: BSD-3-Clause
#include "navigator_fixture.h"
#include "places.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <sstream>

namespace slalom {
namespace {

using Hashes = std::vector<std::string>;

/// The same runs in another process.
Hashes hashes_of_process(const std::string& config, int count, double max_time) {
  std::ostringstream command;
  command << kPrograms << "/navigator_runs" << ' ' << config << ' ' << count << ' ' << max_time;
  FILE* pipe = popen(command.str().c_str(), "r");
  if (pipe == nullptr) return {};
  Hashes hashes;
  char line[128];
  while (std::fgets(line, sizeof line, pipe) != nullptr)
    hashes.push_back(std::string(line).substr(0, 32));
  return pclose(pipe) == 0 ? hashes : Hashes{};
}

/// Whether a list contains different hashes, so that equality is significant.
bool is_varied(const Hashes& hashes) {
  return std::any_of(hashes.begin(), hashes.end(), [&](const auto& h) { return h != hashes[0]; });
}

// The small .ini enables everything that has state or reads a clock: the delays model, the velocity
// filter, an obstacle filter over 100 s, and the hysteresis of the holonomic method.
TEST(NavigatorRepeat, HundredRunsAreTheSameTwiceInOneProcessAndInAnother) {
  const std::string config = test_config("small_navigator.ini");
  const auto method = load_navigator_with(config);
  const Hashes first = hashes_of_runs(*method, 100, 4);
  ASSERT_EQ(first.size(), 100U);
  EXPECT_TRUE(is_varied(first));
  EXPECT_EQ(hashes_of_runs(*method, 100, 4), first);
  EXPECT_EQ(hashes_of_process(config, 100, 4), first);
}

TEST(NavigatorRepeat, StockConfigurationRepeatsCompleteRunsInOneProcessAndInAnother) {
  const auto method = load_navigator_with(stock_config());
  const Hashes first = hashes_of_runs(*method, 6, 60);
  EXPECT_TRUE(is_varied(first));
  EXPECT_EQ(hashes_of_runs(*method, 6, 60), first);
  EXPECT_EQ(hashes_of_process(stock_config(), 6, 60), first);
}

TEST(NavigatorRepeat, ARunDoesNotDependOnPreviousRuns) {
  const std::string config = test_config("small_navigator.ini");
  const auto used = load_navigator_with(config);
  for (const int seed : {3, 4, 3}) {
    const World room = random_navigator_room(seed);
    const auto unused = load_navigator_with(config);
    EXPECT_EQ(run_navigator(*used, room).trajectory.hash(),
              run_navigator(*unused, room).trajectory.hash())
        << seed;
  }
}

// A target in an obstacle starts counters of the navigator that cannot be reset.
TEST(NavigatorRepeat, ABlockedTargetDoesNotAffectTheNextRun) {
  Primitives blocked;
  blocked.discs = {{{9, 5}, 0.5}};
  const World blocked_world = navigator_room(blocked), free_world = navigator_room_with_discs();
  const std::string config = test_config("small_navigator.ini");
  const auto used = load_navigator_with(config);
  const Hashes expected = {
      run_navigator(*load_navigator_with(config), blocked_world).trajectory.hash(),
      run_navigator(*load_navigator_with(config), free_world).trajectory.hash()};
  // Runs that end before, during and after the navigator's counting.
  for (const double max_time : {6.9, 7.3, 7.5, 30.0}) run_navigator(*used, blocked_world, max_time);
  EXPECT_EQ(run_navigator(*used, blocked_world).trajectory.hash(), expected[0]);
  EXPECT_EQ(run_navigator(*used, free_world).trajectory.hash(), expected[1]);
}

}  // namespace
}  // namespace slalom
