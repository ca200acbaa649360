// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"
#include "png_file.h"
#include "studio_fixture.h"

#include <mrpt/img/CImage.h>

#include <cmath>
#include <cstdlib>

namespace slalom {
namespace {

using mrpt::img::CImage;

/// A channel that differs by more counts as different; less is the rounding of anti-aliased edges
/// and of the kept pictures.
constexpr int kMaxChannelDifference = 40;
/// The largest fraction of different pixels.
constexpr double kMaxDifferent = 5e-4;
/// Kept pictures have so many levels of each channel, to be small.
constexpr int kLevels = 16;

const char* const kPictureCampaign = R"([campaign]
name        = pictures
seed        = 5
methods     = nd, vff
[scenarios]
generator = random
count     = 6
[generator.random]
width         = 8
height        = 6
min_distance  = 4
max_obstacles = 12
max_size      = 0.5
[robot]
radius = 0.2
[method.nd]
adapter = mrpt_holonomic
class   = CHolonomicND
[method.vff]
adapter = mrpt_holonomic
class   = CHolonomicVFF
)";

CImage picture_of(const std::filesystem::path& path) {
  CImage picture;
  if (!picture.loadFromFile(path)) ADD_FAILURE() << path << " cannot be read";
  return picture;
}

/// The fraction of pixels that differ; 1 if the sizes do.
double different_fraction(const CImage& a, const CImage& b) {
  if (a.getWidth() != b.getWidth() || a.getHeight() != b.getHeight()) return 1;
  const unsigned width = static_cast<unsigned>(a.getWidth()),
                 height = static_cast<unsigned>(a.getHeight());
  std::size_t different = 0;
  for (unsigned y = 0; y < height; ++y)
    for (unsigned x = 0; x < width; ++x) {
      int largest = 0;
      for (unsigned channel = 0; channel < 3; ++channel)
        largest = std::max(largest, std::abs(a.at<std::uint8_t>(x, y, channel) -
                                             b.at<std::uint8_t>(x, y, channel)));
      if (largest > kMaxChannelDifference) ++different;
    }
  return static_cast<double>(different) / (static_cast<double>(width) * height);
}

/// A value with kLevels levels.
std::uint8_t reduced(std::uint8_t value) {
  constexpr double kStep = 255.0 / (kLevels - 1);
  return static_cast<std::uint8_t>(std::lround(kStep * std::round(value / kStep)));
}

void keep(const CImage& picture, const std::string& path) {
  std::string rgb;
  for (unsigned y = 0; y < picture.getHeight(); ++y)
    for (unsigned x = 0; x < picture.getWidth(); ++x)
      for (const unsigned channel : {2U, 1U, 0U})  // MRPT stores BGR
        rgb += static_cast<char>(reduced(picture.at<std::uint8_t>(x, y, channel)));
  write_flat_png(path, static_cast<std::uint32_t>(picture.getWidth()),
                 static_cast<std::uint32_t>(picture.getHeight()), rgb);
}

/// The window with the runs of a campaign, compared with kept pictures, tests/apps/pictures.
class StudioScreenshot : public StudioTest {
 protected:
  void SetUp() override {
    StudioTest::SetUp();
    if (IsSkipped()) return;
    make_once([this] {
      write("pictures.ini", kPictureCampaign);
      ASSERT_EQ(run("slalom-evaluate pictures.ini -o out --quiet").status, 0);
    });
  }

  /// Plays the script and compares its picture. With SLALOM_KEEP_PICTURES in the environment it is
  /// kept instead.
  void expect_as_kept(const std::string& name, const std::string& script,
                      const std::string& arguments) const {
    const auto taken = folder_ / (name + ".png");
    const auto kept = std::filesystem::path(kSource) / "tests/apps/pictures" / (name + ".png");
    expect_played(script + "move status at 0.5 0.5\nwait idle\nscreenshot " + taken.string() + "\n",
                  "out/campaign.scenarios --results out/runs.results " + arguments);
    if (std::getenv("SLALOM_KEEP_PICTURES") != nullptr) {
      keep(picture_of(taken), kept);
      EXPECT_EQ(different_fraction(picture_of(taken), picture_of(kept)), 0) << "by the reduction";
      return;
    }
    const double different = different_fraction(picture_of(taken), picture_of(kept));
    if (different <= kMaxDifferent) return;
    const auto copy = std::filesystem::path(testing::TempDir()) / (name + ".png");
    std::filesystem::copy_file(taken, copy, std::filesystem::copy_options::overwrite_existing);
    ADD_FAILURE() << different << " of the pixels of " << copy << " differ from " << kept
                  << "; docs/guide/studio.md says how to keep it if it is right";
  }
};

TEST_F(StudioScreenshot, At1280x800ShowsRunsLegendAndDescriptors) {
  expect_as_kept("studio_1280x800",
                 "size 1280 800\n"
                 "wait idle\n"
                 "click replay slider at 0.5 0.5\n",
                 "");
}

TEST_F(StudioScreenshot, At1920x1080ShowsASortedListAndTheDistanceField) {
  expect_as_kept("studio_1920x1080",
                 "size 1920 1080\n"
                 "wait idle\n"
                 "do layer.distance_field\n"
                 "do list.sort\n"
                 "click choices \"choice density\"\n"
                 "click filter\n"
                 "type \"success.vff < 1 or density > 0\"\n"
                 "key Enter\n"
                 "click list \"row 2\"\n",
                 "");
}

TEST_F(StudioScreenshot, AtTwiceTheScaleShowsTheMenuOfAScenario) {
  expect_as_kept("studio_2x",
                 "size 960 540\n"
                 "wait idle\n"
                 "click list \"row 1\" right\n",
                 "--scale 2");
}

TEST_F(StudioScreenshot, InTheLightThemeShowsAFormOnTheWindow) {
  expect_as_kept("studio_light",
                 "size 1280 800\n"
                 "wait idle\n"
                 "do view.light_theme\n"
                 "click list \"row 2\"\n"
                 "wait idle\n"
                 "do list.create_index\n",
                 "");
}

TEST_F(StudioScreenshot, ShowsAGridOfPicturesAndARangeOfTimesOfRunsColoredBySpeed) {
  expect_as_kept("studio_grid",
                 "size 1280 800\n"
                 "wait idle\n"
                 "do view.grid\n"
                 "do coloring.speed\n"
                 "drag plot_speed plot at 0.2 0.5 to plot_speed plot at 0.6 0.5\n"
                 "click replay slider at 0.5 0.5\n",
                 "");
}

TEST_F(StudioScreenshot, ShowsTheActionsWithTwoWords) {
  expect_as_kept("studio_actions",
                 "size 1280 800\n"
                 "wait idle\n"
                 "do coloring.clearance\n"
                 "key Ctrl+K\n"
                 "type \"file open\"\n",
                 "");
}

TEST_F(StudioScreenshot, ShowsTheRunsOfAnEditedScenario) {
  expect_as_kept("studio_run",
                 "size 1280 800\n"
                 "wait idle\n"
                 "do tool.goal\n"
                 "click view \"at 1 3\"\n"
                 "key F9\n"
                 "wait idle\n",
                 "");
}

TEST_F(StudioScreenshot, AChangeOfOneLineOfTheLegendIsADifference) {
  expect_played(
      "size 1280 800\n"
      "wait idle\n"
      "move status at 0.5 0.5\n"
      "wait idle\n"
      "screenshot one.png\n"
      "screenshot same.png\n"
      "do layer.voronoi\n"
      "wait idle\n"
      "screenshot other.png\n",
      "out/campaign.scenarios");
  const CImage one = picture_of(folder_ / "one.png");
  EXPECT_EQ(different_fraction(one, picture_of(folder_ / "same.png")), 0);
  keep(one, folder_ / "kept.png");
  EXPECT_EQ(different_fraction(one, picture_of(folder_ / "kept.png")), 0) << "by the reduction";
  EXPECT_GT(different_fraction(one, picture_of(folder_ / "other.png")), kMaxDifferent);
}

}  // namespace
}  // namespace slalom
