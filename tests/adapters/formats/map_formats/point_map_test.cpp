// SPDX-License-Identifier: BSD-3-Clause
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

TEST(PointMap, SkipsTheNumberOfPoints) {
  EXPECT_EQ(points("2\n1.5 2 0\n-3 0.25 0\n"), kTwo);
}

TEST(PointMap, ReadsOnlyPointsInTheHeightRange) {
  PointMapOptions options;
  options.z_min = 0.1;
  options.z_max = 2;
  EXPECT_EQ(points("0 0 0\n1.5 2 0.1\n-3 0.25 2\n9 9 2.1\n", options), kTwo);
}

TEST(PointMap, ReadsTheColumnsThatAHeaderNames) {
  EXPECT_EQ(points("x,y\n1.5,2\n-3,0.25\n"), kTwo);
  EXPECT_EQ(points("tag,X,Y,direction\nblue_cone,1.5,2,0\ncar_start,-3,0.25,0.1\n"), kTwo);
  PointMapOptions options;
  options.z_min = 0.1;
  EXPECT_EQ(points("# cones\nz y x\n0.2 2 1.5\n0.2 0.25 -3\n0 9 9\n", options), kTwo);
}

testing::AssertionResult rejects(const std::string& text, const std::string& where,
                                 const std::string& word) {
  return throws_error(ErrorKind::File, where + ": ", {word, "x y or x y z, in m"},
                      [&] { parse_point_map(text, "points.xyz", {}); });
}

TEST(PointMap, ReportsTheLineOfErrors) {
  EXPECT_TRUE(rejects("1 2\n3 x\n", "points.xyz:2", "invalid number"));
  EXPECT_TRUE(rejects("1 2\n3\n", "points.xyz:2", "one number"));
  EXPECT_TRUE(rejects("5\n4\n", "points.xyz:2", "one number"));
  EXPECT_TRUE(rejects("1 nan\n", "points.xyz:1", "invalid number"));
  EXPECT_TRUE(rejects("1 1e300\n", "points.xyz:1", "out of range"));
  EXPECT_TRUE(rejects("", "points.xyz", "no points"));
  EXPECT_TRUE(rejects("# nothing\n", "points.xyz", "no points"));
}

TEST(PointMap, ReportsAHeaderWithoutXAndY) {
  EXPECT_TRUE(rejects("a,b\n1,2\n", "points.xyz:1", "invalid number"));
  EXPECT_TRUE(rejects("x,z\n1,2\n", "points.xyz:1", "invalid number"));
  EXPECT_TRUE(rejects("tag,x,y\nblue,1\n", "points.xyz:2", "fewer fields than the header has"));
  EXPECT_TRUE(rejects("tag,x,y\nblue,1,two\n", "points.xyz:2", "invalid number"));
}

TEST(PointMap, BecomesAScenarioAroundItsPoints) {
  const MapFolder folder;
  const std::string path = folder.write("posts.xyz", "1.5 2\n-3 0.25\n");
  PointMapOptions options;
  options.margin = 1;
  const Scenario scenario = point_map_scenario(path, options);
  EXPECT_EQ(scenario.name(), "posts");
  EXPECT_EQ(scenario.representation(), Representation::Points);
  EXPECT_EQ(scenario.bounds(), (Bounds{-4, -0.75, 2.5, 3}));
  options.margin = 0;
  EXPECT_TRUE(throws_error(ErrorKind::Usage, path + ": ", {"margin 0 m"},
                           [&] { point_map_scenario(path, options); }));
  EXPECT_TRUE(throws_error(ErrorKind::File, "/nowhere/a.xyz: ", {"cannot be read"},
                           [] { point_map_scenario("/nowhere/a.xyz", {}); }));
}

TEST(PointMap, IsRecognizedByItsExtension) {
  EXPECT_TRUE(is_point_map("a/b.xyz") && is_point_map("b.txt") && is_point_map("b.pts"));
  EXPECT_FALSE(is_point_map("b.yaml") || is_point_map("xyz") || is_point_map("b.gridmap.gz"));
}

}  // namespace
}  // namespace slalom
