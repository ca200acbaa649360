// SPDX-License-Identifier: BSD-3-Clause
#include "studio_fixture.h"

#include <cmath>

namespace slalom {
namespace {

/// Two MRPT methods, two repetitions in two small scenarios.
const char* const kCampaign = R"([campaign]
name        = overlay
seed        = 5
repetitions = 2
methods     = nd, vff
[scenarios]
generator = random
count     = 2
[generator.random]
width         = 6
height        = 6
min_distance  = 3
max_obstacles = 6
max_size      = 0.4
[method.nd]
adapter = mrpt_holonomic
class   = CHolonomicND
[method.vff]
adapter = mrpt_holonomic
class   = CHolonomicVFF
[record]
rawlog = all
)";

/// A campaign in "out": results, scenarios and recorded runs.
class StudioResults : public StudioTest {
 protected:
  void SetUp() override {
    StudioTest::SetUp();
    if (IsSkipped()) return;
    make_once([this] {
      write("overlay.ini", kCampaign);
      ASSERT_EQ(run("slalom-evaluate overlay.ini -o out --quiet").status, 0);
    });
  }

  std::string expect_overlaid(const std::string& script) const {
    return expect_played(script, "out/campaign.scenarios --results out/runs.results");
  }

  /// Parses "time 1.25 of 9.30 s, ..." of the replay.
  static std::pair<double, double> time_of(const std::string& text) {
    std::pair<double, double> time = {-1, -1};
    const std::size_t at = text.rfind("time ");
    if (at != std::string::npos)
      std::sscanf(text.c_str() + at, "time %lf of %lf s", &time.first, &time.second);
    return time;
  }

  /// The time in every text of the replay, and the duration in the last one.
  static std::pair<std::vector<double>, double> times_of(const std::string& shown) {
    std::pair<std::vector<double>, double> found;
    for (std::size_t at = shown.find("time "); at != std::string::npos;
         at = shown.find("time ", at + 1)) {
      const auto [time, end] = time_of(shown.substr(at, shown.find('\n', at) - at));
      found.first.push_back(time);
      found.second = end;
    }
    return found;
  }

  std::string a_log() const {
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "out/runs.rawlogs"))
      if (entry.path().string().find("_nd_0") != std::string::npos)
        return "out/runs.rawlogs/" + entry.path().filename().string();
    return "none";
  }
  ProgramResult replay(const std::string& script) const {
    write("script.txt", script);
    return run(environment() + "slalom-replay play " + a_log() + " --gui --script script.txt");
  }
};

TEST_F(StudioResults, AreShownOnTopOfTheCurrentScenario) {
  const std::string shown = expect_overlaid(
      "wait idle\n"
      "expect results contains \"Results: runs.results, campaign overlay\"\n"
      "expect runs contains \"nd: shown, \"\n"
      "expect runs contains \"vff 1: shown, \"\n"
      "expect view contains \"trajectory nd 0, \"\n"
      "expect view contains \"trajectory vff 1, \"\n"
      "print runs\n"
      "click list \"row 1\"\n"
      "wait idle\n"
      "expect view contains \"trajectory nd 0, \"\n"
      "print runs\n");
  // Another scenario, other lengths.
  const std::size_t second = shown.find("nd: ", shown.find("vff 1: "));
  ASSERT_NE(second, std::string::npos) << shown;
  EXPECT_NE(shown.substr(0, second), shown.substr(second));
}

TEST_F(StudioResults, HaveMoversWhereTheyAreAtTheTimeOfTheReplay) {
  ASSERT_EQ(run("slalom-evaluate overlay.ini --set scenarios.walkers=1 --set scenarios.count=1 "
                "--set campaign.repetitions=1 -o walked --quiet")
                .status,
            0);
  const std::string shown = expect_played(
      "wait idle\n"
      "click replay slider\n"
      "key Home\n"
      "expect view contains \" at 0.00 s: \"\n"
      "print view\n"
      "key Shift+Right\n"
      "expect replay contains \"time 1.00 of \"\n"
      "expect view contains \" at 1.00 s: \"\n"
      "print view\n",
      "walked/campaign.scenarios --results walked/runs.results");
  const auto position_at = [&shown](const std::string& time) {
    const std::size_t at = shown.find(" at " + time + " s: ");
    std::pair<double, double> position = {0, 0};
    if (at != std::string::npos)
      std::sscanf(shown.c_str() + at, " at %*f s: %lf %lf", &position.first, &position.second);
    return position;
  };
  const auto [x0, y0] = position_at("0.00");
  const auto [x1, y1] = position_at("1.00");
  const double walked = std::hypot(x1 - x0, y1 - y0);
  EXPECT_GT(walked, 0) << shown;
  EXPECT_LT(walked, 1.002) << "at most 1 m/s, and the rounding of the text";
}

TEST_F(StudioResults, AreShownAndHiddenByMouseAndKeys) {
  expect_overlaid(
      "wait idle\n"
      "click runs \"row nd\"\n"
      "expect runs contains \"nd 1: hidden\"\n"
      "expect view lacks \"trajectory nd\"\n"
      "expect plot_speed lacks \"nd\"\n"
      "click runs \"row nd 1\"\n"
      "expect view contains \"trajectory nd 1\"\n"
      "expect view lacks \"trajectory nd 0\"\n"
      "key Up\n"
      "key Space\n"
      "expect view contains \"trajectory nd 0\"\n"
      "key A\n"
      "expect view lacks \"trajectory \"\n"
      "expect replay contains \"time 0.00 of 0.00 s\"\n"
      "click runs all\n"
      "expect view contains \"trajectory vff 0\"\n");
}

TEST_F(StudioResults, FilterAndSortTheListAndAreReplayedFromItsMenu) {
  expect_overlaid(
      "wait idle\n"
      "click filter\n"
      "type \"Success.nd >= 0 and outcome.vff is not na\"\n"
      "key Enter\n"
      "expect list contains \", 2 scenarios\"\n"
      "click list sort\n"
      "click choices \"choice results of nd...\"\n"
      "click choices \"choice outcome.nd\"\n"
      "expect list contains \"sort: outcome.nd, ascending\"\n"
      "expect rows contains \", outcome.nd \"\n"
      "click list \"row 1\"\n"
      "wait idle\n"
      "click list \"row 1\" right\n"
      "expect popup contains \"Replay runs\"\n"
      "expect rows contains \"current, selected\"\n"
      "click popup list.replay\n"
      "wait until replay contains playing\n"
      "do file.close_results\n"
      "wait idle\n"
      "expect list contains \"unknown field\"\n"
      "expect list contains \"sort: list order\"\n");
}

TEST_F(StudioResults, AreReplayedByTheSliderAndThePlots) {
  const std::string shown = expect_overlaid(
      "wait idle\n"
      "click replay slider at 0.25 0.5\n"
      "print replay\n"
      "click plot_clearance plot\n"
      "expect plot_speed contains \"marker \"\n"
      "print replay\n"
      "click replay slider\n"
      "key Home\n"
      "key Right\n"
      "key Shift+Right\n"
      "print replay\n");
  const auto [times, duration] = times_of(shown);
  ASSERT_EQ(times.size(), 3U) << shown;
  EXPECT_GT(duration, 2);
  EXPECT_NEAR(times[0], duration / 4, duration / 50);
  EXPECT_NEAR(times[1], duration / 2, duration / 25);
  EXPECT_DOUBLE_EQ(times[2], 1.1);
}

TEST_F(StudioResults, HavePlotsOfARangeOfTimes) {
  const std::string shown = expect_overlaid(
      "wait idle\n"
      "click replay slider at 0.25 0.5\n"
      "print replay\n"
      "drag plot_speed plot at 0.75 0.5 to plot_speed plot at 0.5 0.5\n"
      "expect plot_speed contains \"times \"\n"
      "expect plot_clearance contains \"times \"\n"
      "print replay\n"
      "click plot_clearance plot\n"
      "print replay\n"
      "click plot_speed plot at 0.25 0.5 double\n"
      "expect plot_speed lacks \"times \"\n"
      "print replay\n"
      "drag plot_speed plot at 0.2 0.5 to plot_speed plot at 0.4 0.5\n"
      "click runs \"row vff\"\n"
      "expect plot_clearance contains \"times \"\n"
      "key 0\n"
      "expect plot_clearance lacks \"times \"\n");
  const auto [times, duration] = times_of(shown);
  ASSERT_EQ(times.size(), 4U) << shown;
  EXPECT_DOUBLE_EQ(times[1], times[0]) << "the drag";
  EXPECT_NEAR(times[2], 0.625 * duration, duration / 50) << "the middle of the range";
  EXPECT_DOUBLE_EQ(times[3], times[2]) << "the double click";
}

TEST_F(StudioResults, AreColoredBySpeedOrClearanceAndReadAtTheMouse) {
  expect_overlaid(
      "wait idle\n"
      "expect view lacks \"color bar\"\n"
      "click view\n"
      "key C\n"
      "expect view contains \"color bar speed 0.00 to \"\n"
      "expect view contains \" m/s\"\n"
      "key C\n"
      "expect view contains \"color bar clearance 0.00 to \"\n"
      "do layer.trajectories\n"
      "expect view lacks \"color bar\"\n"
      "do layer.trajectories\n"
      "key C\n"
      "expect view lacks \"color bar\"\n"
      "do coloring.speed\n"
      "move view start\n"
      "expect view contains \"status nd 0 at 0.\"\n"
      "expect view contains \" m/s, clearance \"\n"
      "move view \"color bar\"\n"
      "move view \"at 0.1 0.1\"\n"
      "expect view contains \"status x 0.\"\n");
}

TEST_F(StudioResults, ArePlayedUntilTheEnd) {
  const std::string shown = expect_overlaid(
      "wait idle\n"
      "click replay slower\n"
      "expect replay contains \"0.5x\"\n"
      "click replay play\n"
      "wait until replay contains playing\n"
      "wait until replay lacks \"time 0.0\"\n"
      "click replay play\n"
      "expect replay contains paused\n"
      "print replay\n"
      "click replay slider at 0.98 0.5\n"
      "key Space\n"
      "wait until replay contains paused\n"
      "print replay\n");
  const auto [times, duration] = times_of(shown);
  ASSERT_EQ(times.size(), 2U) << shown;
  EXPECT_GE(times[0], 0.1);
  EXPECT_DOUBLE_EQ(times[1], duration);
}

TEST_F(StudioResults, LeaveMostOfTheWindowToTheScenario) {
  const std::vector<std::pair<int, int>> sizes = {{1024, 700}, {1280, 800}, {1920, 1080}};
  std::string script = "wait idle\n";
  for (const auto& [width, height] : sizes)
    script += "size " + std::to_string(width) + " " + std::to_string(height) +
              "\nwait idle\nexpect descriptors contains density\nexpect runs contains nd\n"
              "print view\n";
  const std::string shown =
      expect_played(script, "out/campaign.scenarios --results out/runs.results");
  std::size_t at = 0;
  for (const auto& [width, height] : sizes) {
    at = shown.find("\nmap ", at + 1);
    ASSERT_NE(at, std::string::npos) << shown;
    double map_width = 0, map_height = 0;
    ASSERT_EQ(std::sscanf(shown.c_str() + at, "\nmap %lf x %lf", &map_width, &map_height), 2);
    EXPECT_GT(map_height, height / 2) << width << " x " << height;
    EXPECT_GT(map_width, 0.6 * width) << width << " x " << height;
  }
}

TEST_F(StudioResults, ReportWhyThereAreNone) {
  make_list(1, "other.scenarios", 99);
  write("broken.results", "no results");
  expect_played(
      "wait idle\n"
      "expect results contains \"runs.results contains no runs of this scenario.\"\n"
      "key Ctrl+R\n"
      "type broken.results\n"
      "key Enter\n"
      "wait idle\n"
      "expect status contains \"broken.results\"\n"
      "expect results contains \"runs.results\"\n"
      "do file.close_results\n"
      "expect view lacks \"trajectory \"\n",
      "other.scenarios --results out/runs.results");
}

TEST_F(StudioResults, OfARecordedRunAreReplayedInTheirOwnWindow) {
  const ProgramResult result = replay(
      "wait idle\n"
      "expect replay contains \"time 0.00 of \"\n"
      "expect view contains \"trajectory nd 0, \"\n"
      "expect runs contains \"nd: shown, \"\n"
      "expect plot_clearance contains \"marker 0.000\"\n"
      "click plot_speed plot\n"
      "key Right\n"
      "screenshot run.png\n"
      "print replay\n");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NEAR(time_of(result.out).first, time_of(result.out).second / 2, 1);
  EXPECT_GT(std::filesystem::file_size(folder_ / "run.png"), 10000U);
}

TEST_F(StudioResults, CannotBeReplayedWithoutADisplay) {
  expect_failure("env -u DISPLAY -u WAYLAND_DISPLAY slalom-replay play " + a_log() + " --gui", 1,
                 {"cannot open a window", "--png DIR", "xvfb-run"});
  expect_failure("slalom-replay play " + a_log(), 2, {"--gui or --png DIR"});
  EXPECT_EQ(replay("click lits\n").status, 1);
}

}  // namespace
}  // namespace slalom
