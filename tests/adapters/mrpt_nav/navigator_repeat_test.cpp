#include "navigator_drive.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <sstream>

namespace slalom {
namespace {

using Hashes = std::vector<std::string>;

/// The same runs in a fresh process.
Hashes hashes_of_process(const std::string& config, int count, double max_time) {
  std::ostringstream command;
  command << SLALOM_NAVIGATOR_RUNS << ' ' << config << ' ' << count << ' ' << max_time;
  FILE* pipe = popen(command.str().c_str(), "r");
  if (pipe == nullptr) return {};
  Hashes hashes;
  char line[128];
  while (std::fgets(line, sizeof line, pipe) != nullptr)
    hashes.push_back(std::string(line).substr(0, 32));
  return pclose(pipe) == 0 ? hashes : Hashes{};
}

/// Whether a list holds different hashes, so that to equal it says something.
bool is_varied(const Hashes& hashes) {
  return std::any_of(hashes.begin(), hashes.end(), [&](const auto& h) { return h != hashes[0]; });
}

// The small .ini switches on all that remembers or reads a clock: the delays model, the filter of
// speeds, a filter of obstacles that looks back 100 s, and the hysteresis of the holonomic method.
TEST(NavigatorRepeat, HundredRunsAreTheSameTwiceInOneProcessAndInAnother) {
  const std::string config = test_config("small_navigator.ini");
  const auto method = load_navigator_with(config);
  const Hashes first = hashes_of_runs(*method, 100, 4);
  ASSERT_EQ(first.size(), 100U);
  EXPECT_TRUE(is_varied(first));
  EXPECT_EQ(hashes_of_runs(*method, 100, 4), first);
  EXPECT_EQ(hashes_of_process(config, 100, 4), first);
}

TEST(NavigatorRepeat, StockConfigurationRepeatsWholeRunsInOneProcessAndInAnother) {
  const auto method = load_navigator_with(stock_config());
  const Hashes first = hashes_of_runs(*method, 6, 60);
  EXPECT_TRUE(is_varied(first));
  EXPECT_EQ(hashes_of_runs(*method, 6, 60), first);
  EXPECT_EQ(hashes_of_process(stock_config(), 6, 60), first);
}

TEST(NavigatorRepeat, ARunIsThatOfAFreshNavigatorWhateverCameBefore) {
  const std::string config = test_config("small_navigator.ini");
  const auto used = load_navigator_with(config);
  for (const int seed : {3, 4, 3}) {
    const World room = random_navigator_room(seed);
    const auto fresh = load_navigator_with(config);
    EXPECT_EQ(drive_navigator(*used, room).trajectory.hash(),
              drive_navigator(*fresh, room).trajectory.hash())
        << seed;
  }
}

// A target in an obstacle sets counters of the navigator going that nothing sets back.
TEST(NavigatorRepeat, ABlockedTargetLeavesNoTraceInTheNextRun) {
  Primitives blocked;
  blocked.discs = {{{9, 5}, 0.5}};
  const World hopeless = navigator_room(blocked), free = navigator_room_with_discs();
  const std::string config = test_config("small_navigator.ini");
  const auto used = load_navigator_with(config);
  const Hashes fresh = {drive_navigator(*load_navigator_with(config), hopeless).trajectory.hash(),
                        drive_navigator(*load_navigator_with(config), free).trajectory.hash()};
  // Ended at different moments: before, while and after the navigator counts.
  for (const double max_time : {6.9, 7.3, 7.5, 30.0}) drive_navigator(*used, hopeless, max_time);
  EXPECT_EQ(drive_navigator(*used, hopeless).trajectory.hash(), fresh[0]);
  EXPECT_EQ(drive_navigator(*used, free).trajectory.hash(), fresh[1]);
}

}  // namespace
}  // namespace slalom
