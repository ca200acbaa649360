// SPDX-License-Identifier: BSD-3-Clause
#include "map_files.h"

#include <slalom/map_formats/arena_scenario.h>

#include <arena_file.h>
#include <error_text.h>

namespace slalom {
namespace {

testing::AssertionResult refuses_arena(const std::string& text, const std::string& message) {
  return throws_error(ErrorKind::File, message, {}, [&] { arena_scenario_from_text(text, "f"); });
}

std::string with_people(const std::string& people) {
  return R"({"robots": [{"start": [1, 2, 0.5], "goal": [5, 2, 0]}], "obstacles": {"dynamic": [)" +
         people + "]}}";
}

TEST(ArenaScenario, PeopleWalkAlongTheirWaypointsAndBack) {
  // 3 m, 4 m and the diagonal of 5 m, at 1 m/s.
  const ArenaScenario scenario = arena_scenario_from_text(
      with_people(R"({"name": "a", "pos": [0, 0, 0], "waypoints": [[3, 0, 0], [3, 4]]})"), "f");
  EXPECT_EQ(scenario.start, mrpt::math::TPose2D(1, 2, 0.5));
  EXPECT_EQ(scenario.goal, mrpt::math::TPoint2D(5, 2));
  const Mover expected = {
      "1 a", 0.3, {{0, {0, 0}}, {3, {3, 0}}, {7, {3, 4}}, {12, {0, 0}}}, MoverEnd::Loop};
  EXPECT_EQ(scenario.movers, Movers{expected});
}

TEST(ArenaScenario, TheirSpeedIsVmaxAndWithoutAWayTheyStand) {
  const ArenaScenario scenario = arena_scenario_from_text(
      with_people(R"({"pos": [0, 0], "vmax": 2, "waypoints": [[0, 0], [3, 0]]}, {"pos": [1, 1]})"),
      "f");
  ASSERT_EQ(scenario.movers.size(), 2U);
  EXPECT_EQ(scenario.movers[0].waypoints.size(), 3U);
  EXPECT_EQ(scenario.movers[0].waypoints[1].t, 1.5);
  const Mover standing = {"2", 0.3, {{0, {1, 1}}}, MoverEnd::Stop};
  EXPECT_EQ(scenario.movers[1], standing);
}

TEST(ArenaScenario, SaysWhatIsLeftOut) {
  const ArenaScenario scenario = arena_scenario_from_text(
      R"({"robots": [{"start": [1, 2], "goal": [5, 2]}, {}, {}], "resets": 5,
          "obstacles": {"static": [{"model": "shelf"}], "interactive": [{}]}})",
      "f");
  EXPECT_EQ(scenario.message,
            "left out: 2 other robots; left out: 1 model; left out: 1 interactive obstacle; "
            "resets: [campaign] repetitions = 5");
}

TEST(ArenaScenario, ErrorsNameThePlace) {
  EXPECT_TRUE(refuses_arena("{", "f: is not JSON"));
  EXPECT_TRUE(refuses_arena("{}", "f: has no 'robots'"));
  EXPECT_TRUE(refuses_arena(R"({"robots": [], "obstacles": {}})", "f: robots: is empty"));
  EXPECT_TRUE(refuses_arena(R"({"robots": [{"goal": [1, 2]}], "obstacles": {}})",
                            "f: robots[0]: has no 'start'"));
  EXPECT_TRUE(refuses_arena(R"({"robots": [{"start": [1]}], "obstacles": {}})",
                            "f: robots[0]: start: is not a position"));
  EXPECT_TRUE(refuses_arena(R"({"robots": [{"start": [1, "a"]}], "obstacles": {}})",
                            "f: robots[0]: start: is not a number"));
  EXPECT_TRUE(refuses_arena(with_people(R"({"pos": [0, 0], "waypoints": [[1, 1]], "vmax": -1})"),
                            "f: obstacles: dynamic[0]: vmax: is -1"));
  EXPECT_TRUE(refuses_arena(with_people(R"({"pos": [0, 0], "waypoints": 3})"),
                            "f: obstacles: dynamic[0]: waypoints: is not a list"));
}

TEST(ArenaScenario, NeedsTheMapOfItsWorld) {
  const MapFolder folder;
  std::ofstream(folder.path("x.json")) << with_people("");
  EXPECT_TRUE(throws_error(ErrorKind::File, folder.path("x.json") + ": there is no ",
                           {"map/map.yaml", "expected the folder of a world of Arena"},
                           [&] { import_arena_scenario(folder.path("x.json"), {}); }));
}

}  // namespace
}  // namespace slalom
