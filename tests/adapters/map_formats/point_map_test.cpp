#include "map_files.h"

#include <slalom/map_formats/point_map.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

std::vector<std::pair<float, float>> points(const std::string& text,
                                            const PointMapOptions& options = {}) {
  const auto map = parse_point_map(text, "points.xyz", options);
  std::vector<std::pair<float, float>> all;
  for (std::size_t i = 0; i < map.size(); ++i)
    all.emplace_back(map.getPointsBufferRef_x()[i], map.getPointsBufferRef_y()[i]);
  return all;
}

const std::vector<std::pair<float, float>> kTwo = {{1.5F, 2.0F}, {-3.0F, 0.25F}};

TEST(PointMap, ReadsTwoOrMoreColumns) {
  EXPECT_EQ(points("1.5 2\n-3 0.25\n"), kTwo);
  EXPECT_EQ(points("# a scan\n1.5,2,0.3\r\n\n-3 ; 0.25 ; 0.4 % far\n"), kTwo);
  EXPECT_EQ(points("1.5\t2\t0\t255\n-3\t0.25\t0\t7"), kTwo);
}

TEST(PointMap, LeavesOutTheCountInFront) {
  EXPECT_EQ(points("2\n1.5 2 0\n-3 0.25 0\n"), kTwo);
}

TEST(PointMap, TakesOnlyTheHeightsAskedFor) {
  PointMapOptions options;
  options.z_min = 0.1;
  options.z_max = 2;
  EXPECT_EQ(points("0 0 0\n1.5 2 0.1\n-3 0.25 2\n9 9 2.1\n", options), kTwo);
}

std::string refused(const std::string& text) {
  return error_text(Culprit::File, [&] { parse_point_map(text, "points.xyz", {}); });
}

TEST(PointMap, NamesTheLineThatIsWrong) {
  EXPECT_EQ(refused("1 2\n3 x\n"),
            "points.xyz:2: has no finite number; expected x y or x y z, in m");
  EXPECT_EQ(refused("1 2\n3\n"), "points.xyz:2: has one number; expected x y or x y z, in m");
  EXPECT_EQ(refused("5\n4\n"), "points.xyz:2: has one number; expected x y or x y z, in m");
  EXPECT_EQ(refused("1 nan\n"), "points.xyz:1: has no finite number; expected x y or x y z, in m");
  EXPECT_EQ(refused("1 1e300\n"), "points.xyz:1: is too far away; expected x y or x y z, in m");
  EXPECT_EQ(refused(""), "points.xyz: holds no points; expected x y or x y z, in m");
  EXPECT_EQ(refused("# nothing\n"), "points.xyz: holds no points; expected x y or x y z, in m");
}

TEST(PointMap, BecomesAPlaceAroundItsPoints) {
  const MapFolder folder;
  const std::string path = folder.write("posts.xyz", "1.5 2\n-3 0.25\n");
  PointMapOptions options;
  options.margin = 1;
  const Scenario scenario = point_map_scenario(path, options);
  EXPECT_EQ(scenario.name(), "posts");
  EXPECT_EQ(scenario.representation(), Representation::Points);
  EXPECT_EQ(scenario.bounds(), (Bounds{-4, -0.75, 2.5, 3}));
  options.margin = 0;
  EXPECT_TRUE(has(error_text(Culprit::Usage, [&] { point_map_scenario(path, options); }),
                  "a margin of 0 m"));
  EXPECT_EQ(error_text(Culprit::File, [] { point_map_scenario("/nowhere/a.xyz", {}); }),
            "/nowhere/a.xyz: cannot be read; expected a map file");
}

TEST(PointMap, IsKnownByItsName) {
  EXPECT_TRUE(is_point_map("a/b.xyz") && is_point_map("b.txt") && is_point_map("b.pts"));
  EXPECT_FALSE(is_point_map("b.yaml") || is_point_map("xyz") || is_point_map("b.gridmap.gz"));
}

}  // namespace
}  // namespace slalom
