// SPDX-License-Identifier: BSD-3-Clause
#include "finish_jobs.h"
#include "list_files.h"

#include <slalom/scenario/grid_map.h>
#include <slalom/studio/jobs.h>
#include <slalom/studio/palette.h>
#include <slalom/studio/thumbnails.h>

#include <array>
#include <cmath>

namespace slalom {
namespace {

using Pixel = std::array<int, 4>;

Pixel pixel(const Thumbnail& picture, int x, int y) {
  const std::uint8_t* at = &picture.rgba[4 * static_cast<std::size_t>(y * picture.size + x)];
  return {at[0], at[1], at[2], at[3]};
}

Pixel pixel_of(const Color& color) {
  return {color.R, color.G, color.B, color.A};
}

const Pixel kFree = pixel_of(palette().free_space), kObstacle = pixel_of(palette().obstacle);

/// Twice as wide as high: the image has 16 transparent rows above and below.
const Bounds kWide{10, 20, 30, 30};

TEST(Thumbnails, ShowObstaclesStartAndGoalWhereTheyAre) {
  const Thumbnail picture = make_thumbnail(Scenario::continuous(
      "", kWide, {{}, {{{{10, 25}, {20, 25}, {20, 30}, {10, 30}}}}}, {12, 22, 0}, {28, 22}));
  ASSERT_EQ(picture.size, 64);
  ASSERT_EQ(picture.rgba.size(), 64U * 64 * 4);
  EXPECT_EQ(pixel(picture, 32, 3)[3], 0);
  EXPECT_EQ(pixel(picture, 32, 60)[3], 0);
  EXPECT_EQ(pixel(picture, 10, 20), kObstacle);  // the polygon is the upper left quarter
  EXPECT_EQ(pixel(picture, 45, 20), kFree);
  EXPECT_EQ(pixel(picture, 25, 44), kFree);
  // 3.2 pixels per meter; rows 16 to 48 are y = 30 to 20.
  EXPECT_EQ(pixel(picture, 6, 41), pixel_of(palette().start));
  EXPECT_EQ(pixel(picture, 57, 41), pixel_of(palette().goal));
  EXPECT_EQ(pixel(picture, 12, 41), pixel_of(palette().start)) << "the heading, to the right";
  EXPECT_EQ(pixel(picture, 6, 34), kFree);
}

TEST(Thumbnails, HaveSymbolsInProportionToTheirSize) {
  const Thumbnail picture =
      make_thumbnail(Scenario::continuous("", kWide, {}, {12, 22, 0}, {28, 22}), 128);
  // 6.4 pixels per meter; the goal is at 115.2, 83.2, with a radius of 7 pixels.
  EXPECT_EQ(pixel(picture, 109, 83), pixel_of(palette().goal));
  EXPECT_EQ(pixel(picture, 107, 83), kFree);
}

TEST(Thumbnails, ShowMoversWhereTheyAreAtTheBeginning) {
  const auto walk = [](double t, double x, double y) {
    return std::vector<Waypoint>{{t, {x, y}}, {t + 5, {x + 3, y}}};
  };
  const Movers movers = {{"large", 1, walk(0, 20, 25), MoverEnd::Stop},
                         {"small", 0.01, walk(0, 25, 28), MoverEnd::Stop},
                         {"later", 1, walk(1, 13, 28), MoverEnd::Stop}};
  const Thumbnail picture = make_thumbnail(
      Scenario::continuous("", kWide, {}, {12, 22, 0}, {28, 22}).with_movers(movers));
  // 3.2 pixels per meter; rows 16 to 48 are y = 30 to 20.
  const Pixel mover = pixel_of(palette().mover);
  EXPECT_EQ(pixel(picture, 32, 32), mover);
  EXPECT_EQ(pixel(picture, 34, 32), mover) << "within 3.2 pixels";
  EXPECT_EQ(pixel(picture, 37, 32), kFree);
  EXPECT_EQ(pixel(picture, 48, 22), mover) << "too small to be seen otherwise";
  EXPECT_EQ(pixel(picture, 9, 22), kFree) << "not present at the beginning";
}

TEST(Thumbnails, ShowPeopleWhereTheyStart) {
  const Thumbnail picture =
      make_thumbnail(Scenario::continuous("", kWide, {}, {12, 22, 0}, {28, 22})
                         .with_people({{"there", 1, 1, {20, 25}, {{25, 25}}},
                                       {"later", 1, 1, {13, 28}, {{14, 28}}, 1}}));
  // 3.2 pixels per meter; rows 16 to 48 are y = 30 to 20.
  EXPECT_EQ(pixel(picture, 32, 32), pixel_of(palette().person));
  EXPECT_EQ(pixel(picture, 37, 32), kFree);
  EXPECT_EQ(pixel(picture, 9, 22), kFree) << "not present at the beginning";
}

TEST(Thumbnails, ShowCellsLargerAndSmallerThanPixels) {
  for (const int cells : {8, 1000}) {
    auto map = make_grid_map(cells, cells, 8.0 / cells, {0, 0});
    for (int y = cells / 2; y < cells; ++y)
      for (int x = cells / 2; x < cells; ++x) map.setCell(x, y, 0);
    const Thumbnail picture = make_thumbnail(Scenario::grid("", map, {1, 1, 0}, {7, 1}));
    EXPECT_EQ(pixel(picture, 48, 16), kObstacle) << cells;
    EXPECT_EQ(pixel(picture, 16, 16), kFree) << cells;
    EXPECT_EQ(pixel(picture, 32, 44), kFree) << cells;
  }
}

TEST(Thumbnails, ShowThinWalls) {
  auto map = make_grid_map(2000, 2000, 0.01, {0, 0});
  for (int y = 0; y < 2000; ++y) map.setCell(1015, y, 0);  // 1 of 31 cells in a pixel
  const Thumbnail picture = make_thumbnail(Scenario::grid("", map, {1, 1, 0}, {19, 1}));
  const int dark = (kFree[0] + kObstacle[0]) / 2 + 4;
  EXPECT_LT(pixel(picture, 32, 10)[0], dark);
  EXPECT_EQ(pixel(picture, 40, 10), kFree);
}

TEST(Thumbnails, ShowVeryNarrowScenarios) {
  const Thumbnail picture =
      make_thumbnail(Scenario::continuous("", {0, 0, 1000, 0.5}, {}, {1, 0.2, 0}, {999, 0.2}), 32);
  EXPECT_EQ(picture.rgba.size(), 32U * 32 * 4);
  EXPECT_EQ(pixel(picture, 16, 15), kFree);
}

TEST(Thumbnails, HaveNoWallsWhereCellsExceedTheBounds) {
  const Thumbnail picture =
      make_thumbnail(Scenario::continuous("", {0, 0, 10, 8.03}, {}, {1, 1, 0}, {9, 1}));
  // 64 * 8.03 / 10 = 51.4 rows, from the 6th on.
  EXPECT_EQ(pixel(picture, 30, 6), kFree);
  EXPECT_EQ(pixel(picture, 63, 20), kFree);
}

TEST(Thumbnails, ShowPoints) {
  mrpt::maps::CSimplePointsMap points;
  points.insertPointFast(5, 5, 0);
  const Thumbnail picture =
      make_thumbnail(Scenario::points("", {0, 0, 10, 10}, points, {1, 1, 0}, {9, 1}));
  EXPECT_LT(pixel(picture, 32, 31)[0], kFree[0] - 50);
  EXPECT_EQ(pixel(picture, 40, 20), kFree);
}

TEST(LruCache, EvictsTheLeastRecentlyUsedItem) {
  std::vector<int> evicted;
  LruCache<int> cache(2, [&](int& number) { evicted.push_back(number); });
  cache.put("a", 1);
  cache.put("b", 2);
  ASSERT_NE(cache.find("a"), nullptr);
  cache.put("c", 3);
  EXPECT_EQ(evicted, std::vector<int>{2});
  EXPECT_EQ(cache.find("b"), nullptr);
  EXPECT_EQ(*cache.find("a"), 1);
  cache.set_capacity(3);
  cache.put("a", 4);
  EXPECT_EQ(*cache.find("a"), 4);
  EXPECT_EQ(cache.size(), 2U);
  cache.clear();
  EXPECT_EQ(evicted, (std::vector<int>{2, 1, 4, 3}));
}

class ThumbnailMakers : public ListFiles {
 protected:
  void finish() { finish_jobs(jobs_); }
  Jobs jobs_;
};

TEST_F(ThumbnailMakers, DrawOnlyWhatWasRequestedLast) {
  const std::string path = make_list("a.scenarios", 30);
  std::vector<std::string> early, later;
  for (int i = 0; i < 12; ++i) early.push_back(hash_of(i));
  for (int i = 20; i < 26; ++i) later.push_back(hash_of(i));
  std::map<std::string, int> ready;
  ThumbnailMaker maker(jobs_, [&](const std::string& hash, const Thumbnail& picture) {
    EXPECT_EQ(picture.rgba, make_thumbnail(ScenarioList::open(path).read(hash)).rgba);
    ++ready[hash];
  });
  maker.request(path, early);
  maker.request(path, later);  // before the first batch is ready
  finish();
  for (const std::string& hash : later) EXPECT_EQ(ready[hash], 1);
  EXPECT_EQ(ready.count(early[11]), 0U);
  EXPECT_EQ(maker.pending_count(), 0U);
}

TEST_F(ThumbnailMakers, ReturnEmptyThumbnailsOnReadErrors) {
  std::vector<int> sizes;
  ThumbnailMaker maker(
      jobs_, [&](const std::string&, const Thumbnail& picture) { sizes.push_back(picture.size); });
  maker.request(make_list("a.scenarios", 2), {"0123456789abcdef0123456789abcdef", hash_of(1)});
  finish();
  EXPECT_EQ(sizes, (std::vector<int>{0, 64}));
  maker.request(folder_ / "missing", {hash_of(0)});
  finish();
  EXPECT_EQ(sizes, (std::vector<int>{0, 64, 0}));
}

TEST_F(ThumbnailMakers, DrawInTheSizeThatWasRequestedLast) {
  const std::string path = make_list("a.scenarios", 9);
  std::map<std::string, int> sizes;
  ThumbnailMaker maker(jobs_, [&](const std::string& hash, const Thumbnail& picture) {
    sizes[hash] = picture.size;
  });
  maker.request(path, {hash_of(0)});
  maker.request(path, {hash_of(7), hash_of(8)}, 128);
  finish();
  EXPECT_EQ(sizes,
            (std::map<std::string, int>{{hash_of(0), 64}, {hash_of(7), 128}, {hash_of(8), 128}}));
}

TEST_F(ThumbnailMakers, MayBeDestroyedBeforeTheirJobsEnd) {
  auto maker =
      std::make_unique<ThumbnailMaker>(jobs_, [](const std::string&, const Thumbnail&) { FAIL(); });
  maker->request(make_list("a.scenarios", 2), {hash_of(0)});
  maker.reset();
  finish();
}

}  // namespace
}  // namespace slalom
