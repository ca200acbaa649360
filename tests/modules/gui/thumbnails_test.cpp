#include "list_files.h"

#include <slalom/gui/jobs.h>
#include <slalom/gui/palette.h>
#include <slalom/gui/thumbnails.h>
#include <slalom/scenario/grid_map.h>

#include <array>
#include <chrono>
#include <cmath>
#include <thread>

namespace slalom {
namespace {

using Pixel = std::array<int, 4>;

Pixel pixel(const Thumbnail& picture, int x, int y) {
  const std::uint8_t* at = &picture.rgba[4 * static_cast<std::size_t>(y * picture.size + x)];
  return {at[0], at[1], at[2], at[3]};
}

Pixel pixel_of(const nanogui::Color& color) {
  Pixel pixel;
  for (std::size_t i = 0; i < 4; ++i)
    pixel[i] = static_cast<int>(std::lround(255 * color[static_cast<Eigen::Index>(i)]));
  return pixel;
}

const Pixel kFloor = pixel_of(palette().floor), kObstacle = pixel_of(palette().obstacle);

/// A place twice as wide as high: the picture has 16 see-through rows above and below.
const Bounds kWide{10, 20, 30, 30};

TEST(Thumbnails, ShowObstaclesStartAndGoalWhereTheyAre) {
  const Thumbnail picture = make_thumbnail(Scenario::continuous(
      "", kWide, {{}, {{{{10, 25}, {20, 25}, {20, 30}, {10, 30}}}}}, {12, 22, 0}, {28, 22}));
  ASSERT_EQ(picture.size, 64);
  ASSERT_EQ(picture.rgba.size(), 64U * 64 * 4);
  EXPECT_EQ(pixel(picture, 32, 3)[3], 0);
  EXPECT_EQ(pixel(picture, 32, 60)[3], 0);
  EXPECT_EQ(pixel(picture, 10, 20), kObstacle);  // the polygon is the upper left quarter
  EXPECT_EQ(pixel(picture, 45, 20), kFloor);
  EXPECT_EQ(pixel(picture, 25, 44), kFloor);
  // 3.2 pixels a metre; rows 16 to 48 are y = 30 to 20.
  EXPECT_EQ(pixel(picture, 6, 41), pixel_of(palette().start));
  EXPECT_EQ(pixel(picture, 57, 41), pixel_of(palette().goal));
  EXPECT_EQ(pixel(picture, 12, 41), pixel_of(palette().start)) << "the heading, to the right";
  EXPECT_EQ(pixel(picture, 6, 34), kFloor);
}

TEST(Thumbnails, ShowCellsLargerAndSmallerThanPixels) {
  for (const int cells : {8, 1000}) {
    auto map = make_grid_map(cells, cells, 8.0 / cells, {0, 0});
    for (int y = cells / 2; y < cells; ++y)
      for (int x = cells / 2; x < cells; ++x) map.setCell(x, y, 0);
    const Thumbnail picture = make_thumbnail(Scenario::grid("", map, {1, 1, 0}, {7, 1}));
    EXPECT_EQ(pixel(picture, 48, 16), kObstacle) << cells;
    EXPECT_EQ(pixel(picture, 16, 16), kFloor) << cells;
    EXPECT_EQ(pixel(picture, 32, 44), kFloor) << cells;
  }
}

TEST(Thumbnails, DoNotLoseThinWalls) {
  auto map = make_grid_map(2000, 2000, 0.01, {0, 0});
  for (int y = 0; y < 2000; ++y) map.setCell(1015, y, 0);  // 1 of 31 cells in a pixel
  const Thumbnail picture = make_thumbnail(Scenario::grid("", map, {1, 1, 0}, {19, 1}));
  const int dark = (kFloor[0] + kObstacle[0]) / 2 + 4;
  EXPECT_LT(pixel(picture, 32, 10)[0], dark);
  EXPECT_EQ(pixel(picture, 40, 10), kFloor);
}

TEST(Thumbnails, OfPlacesAsNarrowAsALineAreStillPictures) {
  const Thumbnail picture =
      make_thumbnail(Scenario::continuous("", {0, 0, 1000, 0.5}, {}, {1, 0.2, 0}, {999, 0.2}), 32);
  EXPECT_EQ(picture.rgba.size(), 32U * 32 * 4);
  EXPECT_EQ(pixel(picture, 16, 15), kFloor);
}

TEST(Thumbnails, HaveNoWallsWhereCellsReachOutOfThePlace) {
  const Thumbnail picture =
      make_thumbnail(Scenario::continuous("", {0, 0, 10, 8.03}, {}, {1, 1, 0}, {9, 1}));
  // 64 * 8.03 / 10 = 51.4 rows, from the 6th on.
  EXPECT_EQ(pixel(picture, 30, 6), kFloor);
  EXPECT_EQ(pixel(picture, 63, 20), kFloor);
}

TEST(Thumbnails, OfPointsShowThem) {
  mrpt::maps::CSimplePointsMap points;
  points.insertPointFast(5, 5, 0);
  const Thumbnail picture =
      make_thumbnail(Scenario::points("", {0, 0, 10, 10}, points, {1, 1, 0}, {9, 1}));
  EXPECT_LT(pixel(picture, 32, 31)[0], kFloor[0] - 50);
  EXPECT_EQ(pixel(picture, 40, 20), kFloor);
}

TEST(RecentlyUsed, DropsWhatWasNotUsedForTheLongest) {
  std::vector<int> dropped;
  RecentlyUsed<int> kept(2, [&](int& number) { dropped.push_back(number); });
  kept.put("a", 1);
  kept.put("b", 2);
  ASSERT_NE(kept.find("a"), nullptr);
  kept.put("c", 3);
  EXPECT_EQ(dropped, std::vector<int>{2});
  EXPECT_EQ(kept.find("b"), nullptr);
  EXPECT_EQ(*kept.find("a"), 1);
  kept.put("a", 4);
  EXPECT_EQ(*kept.find("a"), 4);
  EXPECT_EQ(kept.size(), 2U);
  kept.clear();
  EXPECT_EQ(dropped, (std::vector<int>{2, 1, 4, 3}));
}

class ThumbnailMakers : public ListFiles {
 protected:
  void finish() {
    while (!jobs_.idle()) {
      jobs_.poll();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  Jobs jobs_;
};

TEST_F(ThumbnailMakers, MakeWhatIsWantedAndNoMoreOfWhatScrolledBy) {
  const std::string path = make_list("a.scenarios", 30);
  std::vector<std::string> wanted, later;
  for (int i = 0; i < 12; ++i) wanted.push_back(hash_of(i));
  for (int i = 20; i < 26; ++i) later.push_back(hash_of(i));
  ThumbnailMaker maker(jobs_);
  std::map<std::string, int> ready;
  maker.on_ready = [&](const std::string& hash, const Thumbnail& picture) {
    EXPECT_EQ(picture.rgba, make_thumbnail(ScenarioList::open(path).read(hash)).rgba);
    ++ready[hash];
  };
  maker.want(path, wanted);
  maker.want(path, later);  // before the first few are there
  finish();
  for (const std::string& hash : later) EXPECT_EQ(ready[hash], 1);
  EXPECT_EQ(ready.count(wanted[11]), 0U);
  EXPECT_EQ(maker.missing(), 0U);
}

TEST_F(ThumbnailMakers, GiveEmptyPicturesOfWhatCannotBeRead) {
  ThumbnailMaker maker(jobs_);
  std::vector<int> sizes;
  maker.on_ready = [&](const std::string&, const Thumbnail& picture) {
    sizes.push_back(picture.size);
  };
  maker.want(make_list("a.scenarios", 2), {"0123456789abcdef0123456789abcdef", hash_of(1)});
  finish();
  EXPECT_EQ(sizes, (std::vector<int>{0, 64}));
  maker.want(folder_ / "missing", {hash_of(0)});
  finish();
  EXPECT_EQ(sizes, (std::vector<int>{0, 64, 0}));
}

TEST_F(ThumbnailMakers, MayEndBeforeTheirWork) {
  auto maker = std::make_unique<ThumbnailMaker>(jobs_);
  maker->on_ready = [](const std::string&, const Thumbnail&) { FAIL(); };
  maker->want(make_list("a.scenarios", 2), {hash_of(0)});
  maker.reset();
  finish();
}

}  // namespace
}  // namespace slalom
