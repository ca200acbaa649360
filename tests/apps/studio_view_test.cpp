// SPDX-License-Identifier: BSD-3-Clause
#include "studio_fixture.h"

#include <cmath>
#include <cstdio>
#include <filesystem>

namespace slalom {
namespace {

/// A continuous scenario of 10 m x 6 m with a disc at (5, 5), a square at (7, 1), start (1, 3) and
/// goal (9, 3); and a grid with cells of 0.5 m, empty except for walls at the top and the bottom.
class StudioView : public StudioTest {
 protected:
  void SetUp() override {
    StudioTest::SetUp();
    if (IsSkipped()) return;
    make_once([this] {
      write("room.scenario.yaml", R"(name: room
representation: continuous
bounds: [0, 0, 10, 6]
start: [1, 3, 0]
goal: [9, 3]
discs:
  - [5, 5, 0.5]
polygons:
  - [[7, 1], [8, 1], [8, 2], [7, 2]]
)");
      write("cells.scenario.yaml", R"(name: cells
representation: grid
bounds: [0, 0, 4, 3]
start: [0.75, 1.25, 0]
goal: [3.25, 1.25]
resolution: 0.5
cells:
  - "########"
  - "........"
  - "........"
  - "........"
  - "........"
  - "########"
)");
      ASSERT_EQ(run("slalom-scenarios import room.scenario.yaml -o room.scenarios").status, 0);
      ASSERT_EQ(run("slalom-scenarios import cells.scenario.yaml -o cells.scenarios").status, 0);
    });
  }

  /// The current YAML of a scenario of a list.
  std::string exported(const std::string& name) const {
    const ProgramResult result = run("slalom-scenarios export " + name + ".scenarios --id " + name +
                                     " --format yaml -o now.scenario.yaml");
    EXPECT_EQ(result.status, 0) << result.err;
    return read("now.scenario.yaml");
  }
};

/// The numbers after `prefix` in the text of a view.
std::pair<double, double> numbers_after(const std::string& shown, const std::string& prefix) {
  const std::size_t at = shown.find(prefix);
  double x = -1, y = -1;
  if (at != std::string::npos)
    std::sscanf(shown.c_str() + at + prefix.size(), " %lf%*[^0-9]%lf", &x, &y);
  return {x, y};
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    ++found;
  return found;
}

constexpr double kPixel = 0.03;  // m, slightly more than a pixel in these windows

TEST_F(StudioView, ShowsAndHidesLayersOfAScenario) {
  expect_played(
      "wait idle\n"
      "expect view contains \"scenario room, continuous\"\n"
      "expect view contains \"Shortest path: on, 8.00 m\"\n"  // straight from x = 1 to 9
      "expect view contains \"Voronoi diagram: off\"\n"
      "click view \"layer voronoi\"\n"
      "expect view contains \"Voronoi diagram: on\"\n"
      "click view canvas\n"
      "key 2\n"
      "expect view contains \"Distance field: on, 0 to \"\n"
      "key 3\n"
      "expect view contains \"Voronoi diagram: off\"\n"
      "expect view contains \"Published path: off, NA: no path was published with this scenario\"\n"
      "click view legend\n"
      "key L\n"
      "click view \"layer start_goal\"\n"
      "expect view contains \"Start and goal: off\"\n"
      "screenshot view.png\n",
      "room.scenarios --settings s.ini");
  EXPECT_EQ(read("view.png").substr(1, 3), "PNG");
}

TEST_F(StudioView, ShowsPositionClearanceAndRangeScanAtTheMouse) {
  const std::string shown = expect_played(
      "wait idle\n"
      "expect view contains \"Range scan at the mouse: on, 181 rays\"\n"
      "move view \"at 2 2\"\n"
      "print view\n"
      "move view \"at 5 3\"\n"
      "expect view contains \"scan heading 0 deg\"\n"
      "click view canvas\n"
      "key Q\nkey Q\n"
      "expect view contains \"scan heading 10 deg\"\n"
      "drag view \"at 5 3\" to view \"at 5 4\" shift\n"
      "expect view contains \"scan heading 90 deg\"\n"
      "key W\n"
      "expect view contains \"scan heading 85 deg\"\n",
      "room.scenarios --settings s.ini");
  const auto [x, y] = numbers_after(shown, "pointer x");
  EXPECT_NEAR(x, 2, kPixel) << shown;
  EXPECT_NEAR(y, 2, kPixel) << shown;
  EXPECT_NEAR(numbers_after(shown, "clearance").first, 2, kPixel) << shown;  // to two walls
}

TEST_F(StudioView, ZoomsAndPansWithMouseAndKeys) {
  const std::string shown = expect_played(
      "wait idle\nprint view\n"
      "wheel 3 view \"at 5 3\"\nmove view \"at 5 3\"\nprint view\n"
      "key minus\nkey minus\nkey minus\n"
      "drag view \"at 5 3\" to view \"at 6 3\"\n"
      "key Left\nkey Right\nkey 0\nprint view\n",
      "room.scenarios --settings s.ini");
  std::vector<double> scales;
  for (std::size_t at = shown.find("scale "); at != std::string::npos;
       at = shown.find("scale ", at + 1))
    if (shown.compare(at, 10, "scale bar ") != 0) scales.push_back(std::stod(shown.substr(at + 6)));
  ASSERT_EQ(scales.size(), 3U) << shown;
  EXPECT_NEAR(scales[1] / scales[0], 1.25 * 1.25 * 1.25, 0.01);
  EXPECT_DOUBLE_EQ(scales[2], scales[0]);
}

TEST_F(StudioView, MovesStartAndGoalUndoably) {
  const std::string shown = expect_played(
      "wait idle\n"
      "click view \"tool goal\"\n"
      "click view \"at 8 4\"\n"
      "wait idle\n"
      "click view \"tool start\"\n"
      "drag view \"at 2 3\" to view \"at 2 4\"\n"
      "wait idle\n"
      "print view\n"
      "key Ctrl+Z\n"
      "wait idle\n"
      "expect view contains \"start 1.000 3.000 m, 0.0 deg\"\n"
      "key Ctrl+Z\n"
      "wait idle\n"
      "expect view contains \"goal 9.000 3.000\"\n"
      "key Ctrl+Y\n"
      "wait idle\n"
      "expect view lacks \"goal 9.000 3.000\"\n"
      "click view \"tool goal\"\n"
      "drag view \"at 8 4\" to view \"at 7 4\"\n"
      "wait idle\n"
      "expect view contains \"m, 180.0 deg\"\n"
      "click view \"at 8 4\"\n"
      "wait idle\n"
      "expect view lacks \"m, 180.0 deg\"\n",
      "room.scenarios --settings s.ini");
  EXPECT_NEAR(numbers_after(shown, "goal").first, 8, kPixel) << shown;
  EXPECT_NEAR(numbers_after(shown, "goal").second, 4, kPixel) << shown;
  EXPECT_NEAR(numbers_after(shown, "start").first, 2, kPixel) << shown;
  EXPECT_NE(shown.find("90.0 deg"), std::string::npos) << shown;
}

TEST_F(StudioView, AddsMovesAndDeletesObstacles) {
  const std::string before = run("slalom-scenarios list room.scenarios --json").out;
  expect_played(
      "wait idle\n"
      "click view \"tool disc\"\n"
      "drag view \"at 3 1\" to view \"at 3 1.4\"\n"
      "wait idle\n"
      "click view \"tool polygon\"\n"
      "click view \"at 2 4\"\n"
      "click view \"at 3 4\"\n"
      "click view \"at 3 5\"\n"
      "key Enter\n"
      "wait idle\n"
      "click view \"tool move\"\n"
      "drag view \"at 7.5 1.5\" to view \"at 7.5 4.5\"\n"
      "wait idle\n"
      "click view \"tool delete\"\n"
      "click view \"at 5 5\"\n"
      "wait idle\n",
      "room.scenarios --settings s.ini");
  const std::string now = exported("room");
  EXPECT_EQ(count(now, "discs"), 1U) << now;
  EXPECT_EQ(now.find("[5, 5, 0.5]"), std::string::npos) << now;
  EXPECT_EQ(now.find("[7, 1]"), std::string::npos) << now;
  EXPECT_NE(run("slalom-scenarios list room.scenarios --json").out, before);  // another hash
}

TEST_F(StudioView, EditsWithTheKeyboardOnly) {
  // The pointer starts in the center and moves 3 x 10 pixels up.
  const std::string shown = expect_played(
      "wait idle\n"
      "click view canvas\n"
      "key G\n"
      "expect view contains \"tool goal\"\n"
      "key Shift+Up\nkey Shift+Up\nkey Shift+Up\n"
      "print view\n"
      "key Enter\nkey Enter\n"
      "wait idle\n"
      "print view\n"
      "key Escape\n"
      "expect view contains \"tool look\"\n",
      "room.scenarios --settings s.ini");
  const auto pointer = numbers_after(shown, "pointer x");
  const auto goal = numbers_after(shown.substr(shown.rfind("\ngoal ")), "goal");
  EXPECT_NEAR(goal.first, pointer.first, 0.001) << shown;
  EXPECT_NEAR(goal.second, pointer.second, 0.001) << shown;
}

TEST_F(StudioView, PaintsAndErasesCells) {
  expect_played(
      "wait idle\n"
      "click view \"tool paint\"\n"
      "click view \"at 2.25 1.75\"\n"
      "wait idle\n"
      "click view \"tool erase\"\n"
      "drag view \"at 1.25 2.75\" to view \"at 2.25 2.75\"\n"
      "wait idle\n"
      "click view \"tool disc\"\n"
      "expect view contains \"consists of cells\"\n"
      "expect view contains \"tool erase\"\n",
      "cells.scenarios --settings s.ini");
  const std::string now = exported("cells");
  EXPECT_NE(now.find("##...###"), std::string::npos) << now;
  EXPECT_NE(now.find("....#..."), std::string::npos) << now;
}

TEST_F(StudioView, ShowsMoversAtAnInstantAndPlaysThem) {
  write("walk.scenario.yaml",
        read("room.scenario.yaml") +
            "movers:\n"
            "  - {id: a, radius: 0.5, after: stop, waypoints: [[0, 3, 4], [4, 3, 2]]}\n"
            "  - {id: b, radius: 0.2, after: stop, waypoints: [[2, 6, 4], [8, 4, 4]]}\n");
  ASSERT_EQ(run("slalom-scenarios import walk.scenario.yaml -o walk.scenarios").status, 0);
  expect_played(
      "size 1280 800\n"
      "wait idle\n"
      "expect view contains \"Obstacles: on, 2 moving obstacles\"\n"
      "expect view contains \"moving obstacle a at 0.00 s: 3.000 4.000 m, radius 0.5 m\"\n"
      "expect view contains \"moving obstacle b at 0.00 s: not there\"\n"
      "expect timeline contains \"time 0.00 of 8.00 s, paused\"\n"
      "screenshot begin.png\n"
      "click timeline slider\n"
      "expect view contains \"moving obstacle a at 4.00 s: 3.000 2.000 m\"\n"
      "expect view contains \"moving obstacle b at 4.00 s: 5.333 4.000 m\"\n"  // 2 of 6 s of 2 m
      "screenshot later.png\n"
      "key Home\n"
      "do view.play\n"
      "wait until timeline contains \"time 8.00 of 8.00 s, paused\"\n"
      "expect view contains \"moving obstacle b at 8.00 s: 4.000 4.000 m\"\n",
      "walk.scenarios");
  EXPECT_NE(read("begin.png"), read("later.png"));
  const ProgramResult still = play("wait idle\nclick timeline slider\n", "room.scenarios");
  EXPECT_EQ(still.status, 1) << "nothing moves: there is no timeline";
  EXPECT_NE(still.err.find("unknown element 'timeline'"), std::string::npos) << still.err;
}

TEST_F(StudioView, ShowsPeopleAtTheirStartAndAsTheyWalkedInARun) {
  write("hall.scenario.yaml",
        "name: hall\nrepresentation: continuous\nbounds: [0, 0, 8, 6]\nstart: [0.75, 3, 0]\n"
        "goal: [7.25, 3]\npeople:\n  - id: anna\n    radius: 0.25\n    speed: 1.3\n"
        "    start: [7, 3.1]\n    route: [[1, 3]]\ndiscs: []\npolygons: []\n");
  write("hall.ini",
        "[campaign]\nmethods = nd\n[scenarios]\nlist = hall.scenarios\n[people]\nnotices = 0\n"
        "[metrics]\nenabled = path_length\ndescriptors = density\n"
        "[method.nd]\nadapter = mrpt_holonomic\nclass = CHolonomicND\n[record]\nrawlog = all\n");
  ASSERT_EQ(run("slalom-scenarios import hall.scenario.yaml -o hall.scenarios").status, 0);
  ASSERT_EQ(run("slalom-evaluate hall.ini -o out --quiet").status, 0);
  const std::string start =
      "expect view contains \"person anna at 0.00 s: 7.000 3.100 m, radius 0.25 m\"\n";
  expect_played("wait idle\nexpect view contains \"Obstacles: on, 1 person\"\n" + start,
                "hall.scenarios");
  // She does not notice the robot: in 2 s she has gone 2.6 m straight to (1, 3).
  const double angle = std::atan2(0.1, 6);
  const auto walked = [&](const std::string& shown) {
    const auto [x, y] = numbers_after(shown, "person anna at 2.00 s:");
    EXPECT_NEAR(x, 7 - 2.6 * std::cos(angle), 0.002);
    EXPECT_NEAR(y, 3.1 - 2.6 * std::sin(angle), 0.002);
  };
  const std::string script = "wait idle\nclick replay slider\nkey Home\n" + start +
                             "key Shift+Right\nkey Shift+Right\nprint view\n";
  walked(expect_played(script, "hall.scenarios --results out/runs.results"));
  ASSERT_FALSE(std::filesystem::is_empty(folder_ / "out/runs.rawlogs"));
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "out/runs.rawlogs")) {
    write("script.txt", script);
    const ProgramResult replay =
        run(environment() + "slalom-replay play out/runs.rawlogs/" +
            entry.path().filename().string() + " --gui --script script.txt");
    EXPECT_EQ(replay.status, 0) << replay.err;
    walked(replay.out);
  }
}

TEST_F(StudioView, DrawsEditsMovesAndDeletesMoversUndoably) {
  expect_played(
      "size 1280 800\n"
      "wait idle\n"
      "click view \"tool mover\"\n"
      "click view \"at 3 4\"\n"
      "click view \"at 5 4\"\n"
      "move view \"at 5 2\"\n"
      "screenshot drawn.png\n"
      "click view \"at 5 2\"\n"
      "key Enter\n"
      "wait idle\n"
      "expect status contains \"Add moving obstacle\"\n"
      "expect view contains \"moving obstacle mover_1 at 0.00 s\"\n"
      "do edit.movers\n"
      "click dialog \"field waypoints.0\"\n"
      "key Ctrl+A\n"
      "type \"0 3 4; 2 5 4; 1 5 2\"\n"
      "key Enter\n"
      "expect dialog contains \"increasing times\"\n"
      "screenshot dialog.png\n"
      "key Ctrl+A\n"
      "type \"0 3 4; 2 5 4; 8 5 1\"\n"
      "key Enter\n"
      "wait idle\n"
      "expect status contains \"Edit moving obstacles\"\n"
      "expect timeline contains \"of 8.00 s\"\n"
      "key Ctrl+Z\n"
      "wait idle\n"
      "expect timeline lacks \"of 8.00 s\"\n"
      "key Ctrl+Y\n"
      "wait idle\n"
      "click view \"tool move\"\n"
      "drag view \"mover mover_1\" to view \"at 2 5\"\n"
      "wait idle\n"
      "expect status contains \"Move moving obstacle\"\n",
      "room.scenarios");
  EXPECT_NE(exported("room").find("mover_1"), std::string::npos);
  const std::string shown = expect_played(
      "wait idle\n"
      "print view\n"
      "click timeline\n"
      "key End\n"
      "expect timeline contains \"time 8.00 of 8.00 s\"\n"  // the move keeps the times
      "print view\n"
      "key Home\n"
      "click view \"tool delete\"\n"
      "click view \"mover mover_1\"\n"
      "wait idle\n"
      "expect status contains \"Delete moving obstacle\"\n"
      "expect view lacks \"moving obstacle mover_1\"\n",
      "room.scenarios");
  const auto [x0, y0] = numbers_after(shown, "moving obstacle mover_1 at 0.00 s:");
  EXPECT_NEAR(x0, 2, 2 * kPixel);
  EXPECT_NEAR(y0, 5, 2 * kPixel);
  const auto [x8, y8] = numbers_after(shown, "moving obstacle mover_1 at 8.00 s:");
  EXPECT_NEAR(x8, 4, 2 * kPixel) << "from (5, 1), as the start from (3, 4)";
  EXPECT_NEAR(y8, 2, 2 * kPixel);
  EXPECT_EQ(exported("room").find("movers"), std::string::npos);
}

TEST_F(StudioView, DrawsEditsMovesAndDeletesPeopleUndoably) {
  expect_played(
      "size 1280 800\n"
      "wait idle\n"
      "click view \"tool person\"\n"
      "click view \"at 0.1 4\"\n"
      "key Enter\n"
      "wait idle\n"
      "expect view contains \"status room: person 'person_1': starts in a wall\"\n"
      "expect view lacks \"person person_1\"\n"
      "click view \"at 3 4\"\n"
      "click view \"at 5 4\"\n"
      "move view \"at 5 2\"\n"
      "screenshot drawn.png\n"
      "click view \"at 5 2\"\n"
      "key Enter\n"
      "wait idle\n"
      "expect status contains \"Add person\"\n"
      "expect view contains \"person person_1 at 0.00 s\"\n"
      "do edit.people\n"
      "click dialog \"field start.0\"\n"
      "key Ctrl+A\n"
      "type \"0.1 4\"\n"
      "key Enter\n"
      "expect dialog contains \"starts in a wall\"\n"
      "screenshot dialog.png\n"
      "key Ctrl+A\n"
      "type \"3 4.5\"\n"
      "key Enter\n"
      "wait idle\n"
      "expect status contains \"Edit people\"\n"
      "expect view contains \"person person_1 at 0.00 s: 3.000 4.500 m\"\n"
      "key Ctrl+Z\n"
      "wait idle\n"
      "expect view lacks \"3.000 4.500 m\"\n"
      "key Ctrl+Y\n"
      "wait idle\n"
      "click view \"tool move\"\n"
      "drag view \"person person_1\" to view \"at 2 5\"\n"
      "wait idle\n"
      "expect status contains \"Move start of a person\"\n"
      "drag view \"at 5 2\" to view \"at 6 1\"\n"
      "wait idle\n"
      "expect status contains \"Move point of a route\"\n",
      "room.scenarios");
  EXPECT_NE(exported("room").find("person_1"), std::string::npos);
  const std::string shown = expect_played(
      "wait idle\n"
      "print view\n"
      "click view \"tool delete\"\n"
      "click view \"person person_1\"\n"
      "wait idle\n"
      "expect status contains \"Delete person\"\n"
      "expect view lacks \"person person_1\"\n",
      "room.scenarios");
  const auto [x, y] = numbers_after(shown, "person person_1 at 0.00 s:");
  EXPECT_NEAR(x, 2, 2 * kPixel);
  EXPECT_NEAR(y, 5, 2 * kPixel);
  EXPECT_EQ(exported("room").find("people"), std::string::npos);
}

TEST_F(StudioView, ReportsInvalidEditsAndContinues) {
  expect_played(
      "wait idle\n"
      "click view \"tool goal\"\n"
      "click view \"at 5 5\"\n"  // in the disc
      "wait idle\n"
      "expect view contains \"status room: \"\n"
      "expect view contains \"goal 9.000 3.000\"\n"
      "click view \"at 8 4\"\n"
      "wait idle\n"
      "expect view lacks \"goal 9.000 3.000\"\n",
      "room.scenarios --settings s.ini");
}

}  // namespace
}  // namespace slalom
