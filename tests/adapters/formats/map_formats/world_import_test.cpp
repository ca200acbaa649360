// SPDX-License-Identifier: BSD-3-Clause
#include "map_files.h"

#include <slalom/map_formats/map_export.h>
#include <slalom/map_formats/map_task.h>
#include <slalom/map_formats/world_import.h>
#include <slalom/scenario/grid_map.h>
#include <slalom/scenario/occupancy.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

/// A model at a pose, with a shape at another pose in its link.
std::string model(const std::string& name, const std::string& pose, const std::string& shape,
                  const std::string& inner = "0 0 0 0 0 0") {
  return "<model name='" + name + "'><static>1</static><pose>" + pose +
         "</pose><link name='link'><collision name='c'><pose>" + inner + "</pose><geometry>" +
         shape + "</geometry></collision></link></model>\n";
}

const std::string kPost = "<cylinder><radius>0.25</radius><length>1</length></cylinder>";

class GazeboWorld : public testing::Test {
 protected:
  ImportedWorld imported(const std::string& content, const WorldOptions& options = {}) const {
    return import_world(written(content), options);
  }
  std::string written(const std::string& content) const {
    return folder.write("room.world",
                        "<?xml version='1.0'?>\n<sdf version='1.6'>\n<world name='w'>\n" + content +
                            "</world></sdf>");
  }
  testing::AssertionResult rejects(const std::string& content,
                                   std::initializer_list<std::string> words) const {
    const std::string path = written(content);
    return throws_error(ErrorKind::File, path, words, [&] { import_world(path, {}); });
  }
  Primitives obstacles(const std::string& content, const WorldOptions& options = {}) const {
    return imported(content, options).scenario.primitives();
  }

  MapFolder folder;
};

void expect_corners(const Polygon& polygon, const std::vector<mrpt::math::TPoint2D>& corners) {
  EXPECT_EQ(polygon.vertices.size(), corners.size());
  for (const auto& corner : corners) {
    double nearest = HUGE_VAL;
    for (const auto& vertex : polygon.vertices)
      nearest = std::min(nearest, (vertex - corner).norm());
    EXPECT_LT(nearest, 1e-9) << corner.x << " " << corner.y;
  }
}

TEST_F(GazeboWorld, MakesDiscsOfUprightCylindersAndPolygonsOfBoxes) {
  const ImportedWorld world =
      imported(model("post", "1 2 0.5 0 0 0", kPost) +
               model("wall", "4 0 0.5 0 0 1.5707963267948966", "<box><size>2 0.5 1</size></box>"));
  const Scenario& scenario = world.scenario;
  EXPECT_EQ(scenario.name(), "room");
  ASSERT_EQ(scenario.primitives().discs.size(), 1U);
  EXPECT_EQ(scenario.primitives().discs[0].center, mrpt::math::TPoint2D(1, 2));
  EXPECT_EQ(scenario.primitives().discs[0].radius, 0.25);
  ASSERT_EQ(scenario.primitives().polygons.size(), 1U);
  expect_corners(scenario.primitives().polygons[0], {{3.75, -1}, {4.25, -1}, {4.25, 1}, {3.75, 1}});
  // 0.5 m around x from 0.75 to 4.25 and y from -1 to 2.25.
  EXPECT_NEAR(scenario.bounds().x_min, 0.25, 1e-12);
  EXPECT_NEAR(scenario.bounds().y_min, -1.5, 1e-12);
  EXPECT_NEAR(scenario.bounds().x_max, 4.75, 1e-12);
  EXPECT_NEAR(scenario.bounds().y_max, 2.75, 1e-12);
  EXPECT_EQ(world.message, "");
  EXPECT_FALSE(world.start || world.goal);
}

TEST_F(GazeboWorld, ComposesThePosesOfModelsLinksAndShapes) {
  // The outer frame is at (10, 0), turned by 90 degrees: (1, 0) in it is at (10, 1), and so on.
  const std::string half_turn = "1.5707963267948966";
  const auto discs =
      obstacles("<model name='outer'><pose>10 0 0 0 0 " + half_turn +
                "</pose><model name='inner'><pose>1 0 0 0 0 " + half_turn +
                "</pose><link name='l'><pose>2 0 0 0 0 0</pose><collision name='c'><pose>0 3 0.5 0 "
                "0 0</pose><geometry>" +
                kPost + "</geometry></collision></link></model></model>")
          .discs;
  ASSERT_EQ(discs.size(), 1U);
  EXPECT_NEAR(discs[0].center.x, 10 - 2, 1e-12);
  EXPECT_NEAR(discs[0].center.y, 1 - 3, 1e-12);
}

TEST_F(GazeboWorld, PlacesWhatIsRelativeToOtherFrames) {
  const ImportedWorld world = imported(
      "<frame name='dock'><pose>5 5 0 0 0 0</pose></frame>"
      "<model name='a'><pose relative_to='dock'>1 0 0 0 0 90</pose><link name='l'><collision "
      "name='c'>"
      "<geometry>" +
      kPost +
      "</geometry></collision></link></model>"
      "<model name='b'><pose relative_to='nowhere'>1 0 0 0 0 0</pose></model>"
      "<model name='c'><pose degrees='true'>0 0 0 0 0 180</pose><link name='l'><collision name='c'>"
      "<pose>1 0 0 0 0 0</pose><geometry>" +
      kPost +
      "</geometry></collision></link></model>"
      "<model name='d'><pose rotation_format='quat_xyzw'>0 0 0 0 0 1 0</pose><link name='l'>"
      "<collision name='c'><pose>2 0 0 0 0 0</pose><geometry>" +
      kPost + "</geometry></collision></link></model>");
  const auto& discs = world.scenario.primitives().discs;
  ASSERT_EQ(discs.size(), 3U);
  EXPECT_NEAR(discs[0].center.x, 6, 1e-12);
  EXPECT_NEAR(discs[0].center.y, 5, 1e-12);
  EXPECT_NEAR(discs[1].center.x, -1, 1e-12);
  EXPECT_NEAR(discs[2].center.x, -2, 1e-12);
  EXPECT_TRUE(mentions(world.message, {"relative to other frames 'b'"}));
}

TEST_F(GazeboWorld, PlacesModelsWhereASavedStateHasThem) {
  const auto discs = obstacles(model("post", "1 2 0 0 0 0", kPost) +
                               "<state world_name='w'><model name='post'><pose>7 8 0 0 0 0</pose>"
                               "</model></state>")
                         .discs;
  ASSERT_EQ(discs.size(), 1U);
  EXPECT_EQ(discs[0].center, mrpt::math::TPoint2D(7, 8));
}

TEST_F(GazeboWorld, TakesWhatIsInTheHeightsOfTheRobot) {
  const std::string shelf = "<box><size>1 1 0.2</size></box>";
  const std::string world = model("post", "0 0 0 0 0 0", kPost) +
                            model("lamp", "3 0 2.5 0 0 0", shelf) +
                            model("tile", "6 0 -0.08 0 0 0", shelf);
  EXPECT_TRUE(obstacles(world).polygons.empty());
  EXPECT_TRUE(mentions(imported(world).message, {"2 shapes below 0.05 m or above 2 m"}));
  WorldOptions options;
  options.z_max = 3;
  EXPECT_EQ(obstacles(world, options).polygons.size(), 1U);
  options.z_min = 0;
  EXPECT_EQ(obstacles(world, options).polygons.size(), 2U);
}

TEST_F(GazeboWorld, CutsSpheresAtTheHeightsOfTheRobot) {
  // At 2 m, 0.6 m below its center, a sphere of radius 1 m has a circle of radius 0.8 m.
  const auto discs =
      obstacles(model("ball", "0 0 2.6 0 0 0", "<sphere><radius>1</radius></sphere>") +
                model("ball", "5 0 1 0 0 0", "<sphere><radius>1</radius></sphere>"))
          .discs;
  ASSERT_EQ(discs.size(), 2U);
  EXPECT_NEAR(discs[0].radius, 0.8, 1e-12);
  EXPECT_EQ(discs[1].radius, 1);
}

TEST_F(GazeboWorld, ClipsTiltedBoxesToTheHeightsOfTheRobot) {
  // A board of 8 m, turned by 30 degrees about y: its center line is at x = z / tan 30 from z = 0.
  const std::string board =
      model("ramp", "0 0 0 0 -0.5235987755982988 0", "<box><size>8 1 0.0002</size></box>");
  const auto polygons = obstacles(board).polygons;
  ASSERT_EQ(polygons.size(), 1U);
  const double begin = 0.05 / std::tan(M_PI / 6), end = 2 / std::tan(M_PI / 6);
  for (const auto& corner : polygons[0].vertices) {
    EXPECT_NEAR(std::abs(corner.y), 0.5, 1e-12);
    EXPECT_LT(std::min(std::abs(corner.x - begin), std::abs(corner.x - end)), 1e-3) << corner.x;
  }
  EXPECT_EQ(polygons[0].vertices.size(), 4U);
}

TEST_F(GazeboWorld, CoversTiltedCylinders) {
  // A lying cylinder of length 1 along x: its outline is 1 m by twice the radius.
  const auto polygons = obstacles(model("log", "0 0 0.25 0 1.5707963267948966 0", kPost)).polygons;
  ASSERT_EQ(polygons.size(), 1U);
  double widest = 0;
  for (const auto& corner : polygons[0].vertices) {
    EXPECT_NEAR(std::abs(corner.x), 0.5, 1e-9);
    widest = std::max(widest, std::abs(corner.y));
  }
  EXPECT_GE(widest, 0.25 - 1e-9);
  EXPECT_LE(widest, 0.25 / std::cos(M_PI / 32) + 1e-9);
}

TEST_F(GazeboWorld, TakesPolylines) {
  const std::string l_shape =
      "<polyline><point>0 0</point><point>2 0</point><point>2 1</point><point>1 1</point>"
      "<point>1 2</point><point>0 2</point><point>0 0</point><height>1</height></polyline>";
  const std::string crossed =
      "<polyline><point>0 0</point><point>1 1</point><point>1 0</point><point>0 1</point>"
      "<height>1</height></polyline>";
  const ImportedWorld world =
      imported(model("l", "1 0 0 0 0 0", l_shape) + model("x", "0 0 0 0 0 0", crossed) +
               model("tilted", "0 0 0 0.5 0 0", l_shape));
  ASSERT_EQ(world.scenario.primitives().polygons.size(), 1U);
  expect_corners(world.scenario.primitives().polygons[0],
                 {{1, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 2}, {1, 2}});
  EXPECT_TRUE(mentions(world.message, {"polylines", "'x', 'tilted'"}));
}

TEST_F(GazeboWorld, NamesWhatIsLeftOut) {
  const ImportedWorld world = imported(
      model("post", "1 2 0 0 0 0", kPost) +
      model("chair", "0 0 0 0 0 0", "<mesh><uri>chair.dae</uri></mesh>") +
      model("hill", "0 0 0 0 0 0", "<heightmap/>") +
      model("ground", "0 0 0 0 0 0", "<plane><normal>0 0 1</normal></plane>") +
      model("slope", "0 0 0 0.5 0 0", "<plane><normal>0 0 1</normal></plane>") +
      "<model name='robot'><plugin name='drive' filename='libdrive.so'/></model>"
      "<include><uri>model://sun</uri></include><include><uri>model://cafe</uri></include>");
  EXPECT_EQ(world.message,
            folder.path("room.world") +
                ": left out: meshes of 'chair'; shapes <heightmap> of 'hill'; planes of 'slope'; "
                "models that plugins may move 'robot'; models without a file 'model://cafe'");
  EXPECT_TRUE(rejects("<model name='robot'><plugin name='p' filename='p.so'/></model>",
                      {"no obstacle", "plugins may move 'robot'"}));
  EXPECT_TRUE(rejects("", {"no obstacle"}));
}

TEST_F(GazeboWorld, ReadsIncludedModelsBesideIt) {
  std::filesystem::create_directories(folder.path("models/post"));
  folder.write("models/post/model.sdf",
               "<sdf version='1.6'>" + model("post", "0 1 0 0 0 0", kPost) + "</sdf>");
  const auto discs = obstacles(
                         "<include><uri>model://post</uri><pose>3 4 0 0 0 0</pose></include>"
                         "<include><uri>model://post</uri><name>second</name></include>")
                         .discs;
  ASSERT_EQ(discs.size(), 2U);
  EXPECT_EQ(discs[0].center, mrpt::math::TPoint2D(3, 4));
  EXPECT_EQ(discs[1].center, mrpt::math::TPoint2D(0, 1));
}

TEST_F(GazeboWorld, StopsAtModelsThatIncludeThemselves) {
  std::filesystem::create_directories(folder.path("models/twice"));
  std::string twice = "<include><uri>model://twice</uri></include>";
  for (int i = 0; i < 4; ++i) twice += twice;
  folder.write("models/twice/model.sdf",
               "<sdf version='1.6'><model name='twice'>" + twice + "</model></sdf>");
  EXPECT_TRUE(rejects("<include><uri>model://twice</uri></include>",
                      {"more than 10000 included models", "a smaller world"}));
}

TEST_F(GazeboWorld, MakesMovingObstaclesOfActors) {
  const auto waypoint = [](const std::string& t, const std::string& x) {
    return "<waypoint><time>" + t + "</time><pose>" + x + " 1 0 0 0 0</pose></waypoint>";
  };
  const auto actor = [](const std::string& name, const std::string& waypoints) {
    return "<actor name='" + name +
           "'><script><loop>true</loop><delay_start>1</delay_start>"
           "<trajectory id='0' type='walking'>" +
           waypoints + "</trajectory></script></actor>";
  };
  const ImportedWorld world =
      imported(actor("anna", waypoint("0", "2") + waypoint("4", "6")) +
               actor("ben", waypoint("0", "2") + waypoint("2", "3") + waypoint("4", "2")) +
               "<actor name='still'/>");
  const Movers& movers = world.scenario.movers();
  ASSERT_EQ(movers.size(), 2U);
  EXPECT_EQ(movers[0].id, "anna");
  EXPECT_EQ(movers[0].radius, 0.3);
  EXPECT_EQ(movers[0].waypoints[0].t, 1);
  EXPECT_EQ(movers[0].position(3), mrpt::math::TPoint2D(4, 1));
  EXPECT_EQ(movers[0].after, MoverEnd::Stop);
  EXPECT_EQ(movers[1].after, MoverEnd::Loop);
  EXPECT_TRUE(mentions(world.message, {"actors without waypoints 'still'"}));
}

TEST_F(GazeboWorld, RefusesMalformedWorldsWithTheirLine) {
  EXPECT_TRUE(rejects(model("a", "0 0 0", kPost), {":4: <pose> has 3 numbers", "expected 6"}));
  EXPECT_TRUE(rejects(model("a", "0 0 nan 0 0 0", kPost), {":4: <pose> has 'nan'"}));
  EXPECT_TRUE(rejects(model("a", "2e6 0 0 0 0 0", kPost), {"beyond 1000 km"}));
  EXPECT_TRUE(rejects(model("a", "0 0 0 0 0 0", "<sphere><radius>0</radius></sphere>"),
                      {":4: is 0", "length > 0"}));
  EXPECT_TRUE(rejects(model("a", "0 0 0 0 0 0", "<cylinder><radius>1</radius></cylinder>"),
                      {":4: <cylinder> has no <length>"}));
  EXPECT_TRUE(rejects(model("a", "0 0 0 0 0 0", "<box><size>1 0 1</size></box>"),
                      {":4: a side is not above 0"}));
  EXPECT_TRUE(rejects("<model>", {"is not XML"}));
  std::string deep;
  for (int i = 0; i < 5000; ++i) deep += "<model>";
  EXPECT_TRUE(rejects(deep, {"is not XML", "DEPTH"}));
  std::string wide = "<sdf";
  for (int i = 0; i < 1001; ++i) wide += "\n a" + std::to_string(i) + "=\"1\"";
  EXPECT_TRUE(rejects(wide + "/>", {"more than 1000 attributes"}));
}

TEST_F(GazeboWorld, HasAnyNumberOfFrames) {
  std::string content;
  for (int i = 0; i < 20000; ++i) {
    const std::string n = std::to_string(i);
    content += "<frame name='f" + n + "'><pose>" + n + " 0 0 0 0 0</pose></frame>";
    if (i % 4 == 0)
      content += "<model name='m" + n + "'><pose relative_to='f" + n +
                 "'>0 0 0 0 0 0</pose><link name='l'><collision name='c'><geometry><box><size>"
                 "0.1 0.1 1</size></box></geometry></collision></link></model>";
  }
  EXPECT_EQ(obstacles(content).polygons.size(), 5000U);
}

class MvsimWorld : public testing::Test {
 protected:
  ImportedWorld imported(const std::string& content) const {
    return import_world(written(content), {});
  }
  std::string written(const std::string& content) const {
    return folder.write("hall.world.xml",
                        "<mvsim_world version='1.0'>\n" + content + "</mvsim_world>");
  }
  testing::AssertionResult rejects(const std::string& content,
                                   std::initializer_list<std::string> words) const {
    const std::string path = written(content);
    return throws_error(ErrorKind::File, path, words, [&] { import_world(path, {}); });
  }

  MapFolder folder;
};

TEST_F(MvsimWorld, HasTheFirstVehicleAsItsStart) {
  const ImportedWorld world = imported(
      "<vehicle name='r1' class='jackal'><init_pose>-8 1 90</init_pose></vehicle>"
      "<vehicle name='r2'><init_pose>5 5 0</init_pose></vehicle>"
      "<block><init_pose>3 0 0</init_pose></block>");
  EXPECT_EQ(world.scenario.name(), "hall");
  ASSERT_TRUE(world.start);
  EXPECT_EQ(world.start->x, -8);
  EXPECT_EQ(world.start->y, 1);
  EXPECT_NEAR(world.start->phi, M_PI / 2, 1e-12);
  EXPECT_FALSE(world.goal);
  EXPECT_EQ(world.scenario.bounds().x_min, -8.5);
  EXPECT_TRUE(mentions(world.message, {"vehicles 'r2'"}));
}

TEST_F(MvsimWorld, PlacesBlocksOfClassesWithVariables) {
  const ImportedWorld world = imported(
      "<variable name='HIGH' value='1.5'/>"
      "<block:class name='crate'><zmax>${HIGH}</zmax><shape><pt>-1 -0.5</pt><pt>-1 0.5</pt><pt>1 "
      "0.5"
      "</pt><pt>1 -0.5</pt></shape></block:class>"
      "<block:class name='column'><shape_from_visual/><geometry type='cylinder' radius='0.5' "
      "length='2' vertex_count='4'/></block:class>"
      "<block class='crate'><init_pose>5 5 90</init_pose></block>"
      "<block class='column'><init_pose3d>0 0 0 0 0 0</init_pose3d></block>"
      "<block class='column'><init_pose3d>0 0 3 0 0 0</init_pose3d></block>"
      "<block class='crate'><intangible>true</intangible><init_pose>1 1 0</init_pose></block>");
  const auto& polygons = world.scenario.primitives().polygons;
  ASSERT_EQ(polygons.size(), 2U);
  expect_corners(polygons[0], {{4.5, 4}, {5.5, 4}, {5.5, 6}, {4.5, 6}});
  expect_corners(polygons[1], {{0.5, 0}, {0, 0.5}, {-0.5, 0}, {0, -0.5}});
  EXPECT_TRUE(mentions(world.message, {"intangible blocks 'crate'", "1 shape below"}));
}

TEST_F(MvsimWorld, HasAnyNumberOfVariablesThatBlocksUse) {
  // Each search through all variables would take an hour.
  std::string content;
  for (int i = 0; i < 40000; ++i) {
    const std::string n = std::to_string(i);
    content += "<variable name='v" + n + "' value='" + n + "'/>";
    if (i % 4 == 0)
      content += "<block><geometry type='box' lx='0.1' ly='0.1' lz='1'/><init_pose>${v" + n +
                 "} 0 0</init_pose></block>";
  }
  EXPECT_EQ(imported(content).scenario.primitives().polygons.size(), 10000U);
}

TEST_F(MvsimWorld, WhoseVariablesNameEachOtherIsRefused) {
  // Each level has ten times the size of the one below, which is defined before it, or after.
  for (const bool below_first : {true, false}) {
    const auto name_of = [&](int level) {
      return "V" + std::to_string(below_first ? 10 + level : 21 - level);
    };
    std::string content;
    for (int i = 0; i < 12; ++i) {
      const int level = below_first ? i : 11 - i;
      std::string value = level == 0 ? "1234567890" : "";
      for (int k = 0; k < 10 && level > 0; ++k) value += "${" + name_of(level - 1) + "}";
      content += "<variable name='" + name_of(level) + "' value='" + value + "'/>\n";
    }
    EXPECT_TRUE(
        rejects(content + "<block><init_pose>${" + name_of(11) + "} 0 0</init_pose></block>",
                {below_first ? "variable 'V13' has more than 1000 characters"
                             : "values of variables name each other"}));
  }
}

TEST_F(MvsimWorld, HasDoorsInVerticalPlanes) {
  // A wall of 10 m with doors from 1 to 3 m and from 2.5 to 3.5 m.
  const auto polygons =
      imported(
          "<element class='vertical_plane'><x0>0</x0><y0>0</y0><x1>10</x1><y1>0</y1>"
          "<thickness>0.2</thickness><door position='0.2' width='2'/>"
          "<door><position>0.3</position><width>1</width></door>"
          "<window position='0.8' width='1'/></element>")
          .scenario.primitives()
          .polygons;
  ASSERT_EQ(polygons.size(), 2U);
  expect_corners(polygons[0], {{0, -0.1}, {1, -0.1}, {1, 0.1}, {0, 0.1}});
  expect_corners(polygons[1], {{3.5, -0.1}, {10, -0.1}, {10, 0.1}, {3.5, 0.1}});
}

TEST_F(MvsimWorld, ExtendsWallsThatMeet) {
  const auto polygons =
      imported(
          "<walls><wallThickness>0.2</wallThickness><shape><pt>0 0</pt><pt>4 0</pt>"
          "<pt>4 0</pt><pt>4 3</pt></shape></walls>")
          .scenario.primitives()
          .polygons;
  ASSERT_EQ(polygons.size(), 2U);
  expect_corners(polygons[0], {{0, -0.1}, {4, -0.1}, {4, 0.1}, {0, 0.1}});
  expect_corners(polygons[1], {{3.9, -0.1}, {4.1, -0.1}, {4.1, 3}, {3.9, 3}});
}

TEST_F(MvsimWorld, PutsBlocksOnTheOccupancyGrid) {
  // 4 x 3 pixels of 0.5 m; the upper left one is dark. A block beyond the map extends it by 2
  // cells.
  folder.write("map.pgm", "P2 4 3 255 0 255 255 255 255 255 255 255 255 255 255 255");
  const ImportedWorld world = imported(
      "<element class='occupancy_grid'><file>map.pgm</file><resolution>0.5</resolution>"
      "<centerpixel_x>0</centerpixel_x><centerpixel_y>0</centerpixel_y></element>"
      "<block><shape><pt>0 0</pt><pt>0.3 0</pt><pt>0.3 0.3</pt><pt>0 0.3</pt></shape>"
      "<init_pose>2.6 0.1 0</init_pose></block>");
  const Occupancy cells = make_occupancy(world.scenario, 1);
  EXPECT_EQ(cells.size_x(), 6);
  EXPECT_EQ(cells.size_y(), 3);
  EXPECT_EQ(cells.count_occupied(), 2U);
  EXPECT_TRUE(cells.occupied(0, 2) && cells.occupied(5, 0));
}

TEST_F(MvsimWorld, GivesBackWhatWasExported) {
  auto map = make_grid_map(7, 5, 0.25, {-1, 2});
  for (const auto& [x, y] : {std::pair(0, 0), {3, 2}, {6, 4}}) map.setCell(x, y, 0.0F);
  const Scenario scenario = Scenario::grid("seven", map, {-0.5, 2.6, 0.7}, {0.4, 3});
  const std::string path = folder.path("seven.world.xml");
  export_scenario(scenario, "mvsim", {}, path);
  const auto task = read_map_task(path);
  ASSERT_TRUE(task);
  const Scenario same =
      import_world(path, {}).scenario.with_start_goal(task->start, task->goal).renamed(task->name);
  EXPECT_EQ(same.hash(), scenario.hash());
  EXPECT_EQ(same.name(), "seven");
}

TEST_F(MvsimWorld, NamesWhatIsLeftOut) {
  const ImportedWorld world = imported(
      "<block name='a'><init_pose>$f{1+1} 0 0</init_pose></block>"
      "<block name='b'><init_pose>0 0 0</init_pose><publish><publish_pose_topic>/${NAME}/pose"
      "</publish_pose_topic></publish></block>"
      "<block name='c'><shape_from_visual/><visual/><init_pose>0 0 0</init_pose></block>"
      "<block name='c'><shape_from_visual/><visual/><init_pose>1 0 0</init_pose></block>"
      "<for var='iX' from='0' to='2'/><element class='elevation_map'/>"
      "<include file='x.vehicle.xml'/><include file='more.xml'/><actor name='p'/>");
  EXPECT_EQ(world.scenario.primitives().polygons.size(), 1U);
  EXPECT_EQ(world.message,
            folder.path("hall.world.xml") +
                ": left out: objects with formulas 'a'; meshes of 'c' (2); objects of loops and "
                "conditions 'iX'; elements 'elevation_map'; included files 'more.xml'; actors 'p'");
}

TEST_F(MvsimWorld, RefusesMalformedWorldsWithTheirLine) {
  EXPECT_TRUE(rejects("<block><init_pose>1 2</init_pose></block>", {":2: <init_pose> has 2", "3"}));
  EXPECT_TRUE(rejects("<block name='b'/>", {":2: the block 'b' has no pose"}));
  EXPECT_TRUE(rejects("<block><init_pose>1 2 3</init_pose><geometry type='box' lx='1'/></block>",
                      {":2: ly is 0"}));
  EXPECT_TRUE(rejects("<walls><shape><pt>0 0</pt></shape></walls>", {":2: has 1 point", "pairs"}));
  EXPECT_TRUE(
      rejects("<element class='occupancy_grid'/>", {":2: the occupancy grid has no <file>"}));
  EXPECT_TRUE(rejects("", {"no obstacle"}));
}

class IrSimWorld : public testing::Test {
 protected:
  std::string written(const std::string& content) const {
    return folder.write("plain.yaml", "world: {height: 6, width: 8, offset: [1, -2]}\n" + content);
  }
  ImportedWorld imported(const std::string& content) const {
    return import_world(written(content), {});
  }
  testing::AssertionResult rejects(const std::string& content,
                                   std::initializer_list<std::string> words) const {
    const std::string path = written(content);
    return throws_error(ErrorKind::File, path, words, [&] { import_world(path, {}); });
  }

  MapFolder folder;
};

TEST_F(IrSimWorld, HasTheTaskOfItsRobotInItsWorkspace) {
  const ImportedWorld world = imported(
      "robot:\n  - kinematics: {name: diff}\n    state: [1.5, -1, 0.5]\n    goal: [8, 3, 0]\n"
      "  - kinematics: {name: acker}\n    state: [2, 2, 0, 0]\n    goal: [3, 3, 0]\n"
      "obstacle:\n  - {shape: {name: circle, radius: 0.5}, state: [4, 1]}\n");
  EXPECT_EQ(world.scenario.name(), "plain");
  EXPECT_EQ(world.scenario.bounds(), (Bounds{1, -2, 9, 4}));
  EXPECT_EQ(world.scenario.start(), mrpt::math::TPose2D(1.5, -1, 0.5));
  EXPECT_EQ(world.scenario.goal(), mrpt::math::TPoint2D(8, 3));
  ASSERT_EQ(world.scenario.primitives().discs.size(), 1U);
  EXPECT_EQ(world.scenario.primitives().discs[0].center, mrpt::math::TPoint2D(4, 1));
  EXPECT_EQ(world.scenario.primitives().discs[0].radius, 0.5);
  EXPECT_TRUE(mentions(world.message, {"robots 'acker'"}));
}

TEST_F(IrSimWorld, HasRectanglesPolygonsAndLineStrings) {
  const auto polygons =
      imported(
          "obstacle:\n"
          "  - {shape: {name: rectangle, length: 2, width: 1}, state: [5, 1, 1.5707963267948966]}\n"
          "  - {shape: {name: polygon, vertices: [[0, 0], [1, 0], [0, 1]]}, state: [2, 2, 0]}\n"
          "  - {shape: {name: linestring, vertices: [[2, 0], [4, 0], [4, 1]]}, state: [0, 0, 0]}\n")
          .scenario.primitives()
          .polygons;
  ASSERT_EQ(polygons.size(), 4U);
  expect_corners(polygons[0], {{4.5, 0}, {5.5, 0}, {5.5, 2}, {4.5, 2}});
  expect_corners(polygons[1], {{2, 2}, {3, 2}, {2, 3}});
  // Lines of 0.02 m with ends of half of it.
  expect_corners(polygons[2], {{1.99, -0.01}, {4.01, -0.01}, {4.01, 0.01}, {1.99, 0.01}});
  expect_corners(polygons[3], {{3.99, -0.01}, {4.01, -0.01}, {4.01, 1.01}, {3.99, 1.01}});
}

/// Point(center).buffer(radius) in the frame of the object, as CircleGeometry of ir-sim.
TEST_F(IrSimWorld, HasCirclesAroundACenterInTheFrameOfTheirObject) {
  const auto discs = imported(
                         "obstacle:\n"
                         "  - {shape: {name: circle, radius: 0.5, center: [2, 1]}, state: [5, 1, "
                         "1.5707963267948966]}\n")
                         .scenario.primitives()
                         .discs;
  ASSERT_EQ(discs.size(), 1U);
  EXPECT_NEAR(discs[0].center.x, 5 - 1, 1e-12);
  EXPECT_NEAR(discs[0].center.y, 1 + 2, 1e-12);
}

/// They neither stop a robot (stop_flag in object_base.py) nor are seen (lidar2d.py).
TEST_F(IrSimWorld, HasNoObjectsThatAreUnobstructed) {
  const ImportedWorld world = imported(
      "obstacle:\n  - {shape: {name: circle}, state: [3, 1], unobstructed: True}\n"
      "  - {shape: {name: circle}, state: [4, 1], unobstructed: false}\n");
  ASSERT_EQ(world.scenario.primitives().discs.size(), 1U);
  EXPECT_EQ(world.scenario.primitives().discs[0].center.x, 4);
  EXPECT_TRUE(mentions(world.message, {"left out: unobstructed objects 'circle'"}));
}

TEST_F(IrSimWorld, HasNumberedObstaclesWithTheirShapes) {
  const auto discs = imported(
                         "obstacle:\n  - number: 3\n    distribution: {name: manual}\n"
                         "    state: [[2, 1], [3, 1], [4, 1], [5, 1]]\n"
                         "    shape:\n      - {name: circle, radius: 0.4}\n"
                         "      - {name: circle, radius: 0.1}\n")
                         .scenario.primitives()
                         .discs;
  ASSERT_EQ(discs.size(), 3U);
  EXPECT_EQ(discs[0].radius, 0.4);
  EXPECT_EQ(discs[1].radius, 0.1);
  EXPECT_EQ(discs[2].radius, 0.1);
  EXPECT_EQ(discs[2].center, mrpt::math::TPoint2D(4, 1));
}

TEST_F(IrSimWorld, NamesWhatIsLeftOut) {
  const ImportedWorld world = imported(
      "obstacle:\n"
      "  - {number: 5, distribution: {name: random}, shape: {name: circle, radius: 0.4}}\n"
      "  - {kinematics: {name: omni}, behavior: {name: dash}, shape: {name: circle}, state: [3, "
      "3]}\n"
      "  - {shape: {name: polygon, random_shape: true}}\n"
      "  - {shape: {name: star}}\n");
  EXPECT_EQ(world.message,
            folder.path("plain.yaml") +
                ": left out: obstacles at drawn places 'circle'; obstacles with a "
                "behavior 'circle'; shapes drawn at random 'polygon'; shapes 'star'");
  EXPECT_FALSE(world.start);
}

TEST_F(IrSimWorld, IsToldFromMapsOfRos) {
  EXPECT_TRUE(is_world(written("")));
  EXPECT_FALSE(is_world(folder.write("ros.yaml", "image: a.pgm\nresolution: 1\n")));
  EXPECT_FALSE(is_world(folder.write("broken.yaml", "world: [")));
}

TEST_F(IrSimWorld, RefusesMalformedWorldsWithTheirLine) {
  EXPECT_TRUE(rejects("obstacle:\n  - {state: [1]}\n", {":3: the state is not a list"}));
  EXPECT_TRUE(rejects("obstacle:\n  - {state: [1, .nan]}\n", {":3: the state is not a number"}));
  EXPECT_TRUE(rejects("obstacle:\n  - {shape: {radius: 0}}\n", {":3: the radius is not above 0"}));
  EXPECT_TRUE(rejects("obstacle:\n  - {number: 1e9}\n", {":3: the number is"}));
  EXPECT_TRUE(rejects("obstacle:\n  - {shape: {name: polygon}}\n", {":3: has no list 'vertices'"}));
  EXPECT_TRUE(rejects("robot: [\n", {"is not YAML"}));
}

class StageWorld : public testing::Test {
 protected:
  ImportedWorld imported(const std::string& content) const {
    return import_world(folder.write("cave.world", content), {});
  }
  testing::AssertionResult rejects(const std::string& content,
                                   std::initializer_list<std::string> words) const {
    const std::string path = folder.write("cave.world", content);
    return throws_error(ErrorKind::File, path, words, [&] { import_world(path, {}); });
  }

  MapFolder folder;
};

TEST_F(StageWorld, ScalesTheDarkPixelsOfItsFloorplan) {
  // The dark pixels extend over 4 x 2 of the 6 x 4 pixels: 2 m x 1 m, cells of 0.5 m.
  folder.write("cave.pgm",
               "P2 6 4 255 255 255 255 255 255 255  255 0 0 255 255 255  255 255 255 255 0 255  "
               "255 255 255 255 255 255");
  folder.write("map.inc",
               "# a macro\ndefine floorplan model ( color \"gray30\" obstacle_return 0 )");
  const ImportedWorld world = imported(
      "include \"map.inc\"\nresolution 0.02\nwindow ( size [635 666] )\n"
      "floorplan ( name \"cave\" size [2 1 0.8] pose [3 4 0 0] bitmap \"cave.pgm\" )\n"
      "define robot position ( size [0.4 0.4 0.4] )\n"
      "robot ( name \"r0\" pose [2.5 3.6 0 90] )  robot ( name \"r1\" )  # the end");
  const Occupancy cells = make_occupancy(world.scenario, 1);
  EXPECT_EQ(cells.bounds(), (Bounds{2, 3.5, 4, 4.5}));
  EXPECT_EQ(cells.resolution(), 0.5);
  EXPECT_EQ(cells.count_occupied(), 3U);
  EXPECT_TRUE(cells.occupied(0, 1) && cells.occupied(1, 1) && cells.occupied(3, 0));
  ASSERT_TRUE(world.start);
  EXPECT_EQ(world.start->x, 2.5);
  EXPECT_NEAR(world.start->phi, M_PI / 2, 1e-12);
  EXPECT_TRUE(mentions(world.message, {"robots 'r1'"}));
}

TEST_F(StageWorld, HasBoxesBlocksAndBoundaries) {
  const auto polygons =
      imported(
          "define tri model ( block ( points 3 point[2] [0 2] point[0] [0 0] point[1] [2 0] "
          "z [0 1] ) )\n"
          "model ( size [2 1 1] pose [5 1 0 90] )\ntri ( size [1 1 1] pose [0.5 0.5 0 0] )\n"
          "define zone model ( obstacle_return 0 ranger_return -1 ) zone ( size [9 9 1] )\n"
          "model ( size [8 8 1] boundary 1 block ( point[0] [0 0] point[1] [1 0] point[2] [0 1] ) "
          ")")
          .scenario.primitives()
          .polygons;
  ASSERT_EQ(polygons.size(), 2U + 1 + 4);
  expect_corners(polygons[0], {{4.5, 0}, {5.5, 0}, {5.5, 2}, {4.5, 2}});
  expect_corners(polygons[1], {{0, 0}, {1, 0}, {0, 1}});
  expect_corners(polygons[2], {{-4, -4}, {4, -4}, {-4, 4}});
  expect_corners(polygons[3], {{-4, -4}, {-3.99, -4}, {-3.99, 4}, {-4, 4}});
}

TEST_F(StageWorld, ModelsHaveOriginsAndStandOnOthers) {
  // Stage places shapes at the global pose plus the origin, children on top of their parent.
  const ImportedWorld world = imported(
      "define wall model ( size [ 2 0.5 1 ] )\n"
      "wall ( pose [ 6 3 0 90 ] origin [ 1 0 0 0 ] )\n"
      "wall ( pose [ 0 0 0 90 ] stack_children 0 wall ( pose [ 3 0 0 0 ] ) )\n"
      "wall ( pose [ 9 9 0 0 ] wall ( pose [ 3 0 5 0 ] ) )\n"
      "wall ( name \"ghost\" pose [ 6 6 0 0 ] obstacle_return 0 ranger_return -1 )\n");
  const auto& polygons = world.scenario.primitives().polygons;
  ASSERT_EQ(polygons.size(), 4U);
  expect_corners(polygons[0], {{5.75, 3}, {6.25, 3}, {6.25, 5}, {5.75, 5}});
  expect_corners(polygons[2], {{-0.25, 2}, {0.25, 2}, {0.25, 4}, {-0.25, 4}});
  EXPECT_TRUE(
      mentions(world.message, {"models that nothing sees or touches 'ghost'", "1 shape below"}));
}

TEST_F(StageWorld, RefusesMalformedWorldsWithTheirLine) {
  EXPECT_TRUE(rejects("model ( size [1 1\n", {":2: ends early"}));
  EXPECT_TRUE(rejects("model ( size [1 x 1] )", {":1: size has 'x'"}));
  EXPECT_TRUE(rejects("\nmodel ( size [0 1 1] )", {":2: a size is not above 0"}));
  EXPECT_TRUE(rejects("model ( name \"a )", {":1: has a text without an end"}));
  EXPECT_TRUE(rejects("unit_length \"cm\" model ( )", {"another unit_length", "m and degrees"}));
  EXPECT_TRUE(rejects("include \"cave.world\" include \"cave.world\"", {"100 included files"}));
  std::string deep;
  for (int i = 0; i < 1000; ++i) deep += "model (";
  EXPECT_TRUE(rejects(deep, {"nested too deeply"}));
  EXPECT_TRUE(rejects("define a a ( )", {"no obstacle"}));
}

TEST(WorldImport, SaysWhatAnotherFileSeemsToBe) {
  const MapFolder folder;
  const std::string robot = folder.write("a.world", "<robot name='r'/>");
  EXPECT_TRUE(throws_error(ErrorKind::File, robot + ":1", {"<robot>", "URDF", "<sdf>"},
                           [&] { import_world(robot, {}); }));
  const std::string expands = folder.write(
      "b.world",
      "<!DOCTYPE sdf [<!ENTITY a SYSTEM 'file:///etc/passwd'>]><sdf><world>&a;</world></sdf>");
  EXPECT_TRUE(
      throws_error(ErrorKind::File, expands, {"no obstacle"}, [&] { import_world(expands, {}); }));
}

}  // namespace
}  // namespace slalom
