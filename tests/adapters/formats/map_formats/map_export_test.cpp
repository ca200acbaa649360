// SPDX-License-Identifier: BSD-3-Clause
#include "map_files.h"
#include "map_readers.h"

#include <slalom/core/random.h>
#include <slalom/core/read_file.h>
#include <slalom/io/png_scene.h>
#include <slalom/io/scenario_yaml.h>
#include <slalom/map_formats/map_export.h>
#include <slalom/map_formats/map_task.h>
#include <slalom/scenario/grid_map.h>
#include <slalom/scenario/occupancy.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

Scenario random_grid_scenario(RandomEngine& random) {
  auto map = make_grid_map(uniform_int(random, 1, 30), uniform_int(random, 1, 30),
                           uniform_real(random, 0.02, 0.7),
                           {uniform_real(random, -90, 90), uniform_real(random, -90, 90)});
  for (int y = 0; y < static_cast<int>(map.getSizeY()); ++y)
    for (int x = 0; x < static_cast<int>(map.getSizeX()); ++x)
      if (uniform_int(random, 0, 3) == 0) map.setCell(x, y, 0.0F);
  const auto within = [&random](double low, double high) {
    return low + uniform_real(random, 0.1, 0.9) * (high - low);
  };
  const double x0 = map.getXMin(), x1 = map.getXMax(), y0 = map.getYMin(), y1 = map.getYMax();
  return Scenario::grid("map \"a: b\" #" + std::to_string(uniform_int(random, 0, 99)), map,
                        {within(x0, x1), within(y0, y1), uniform_real(random, -4, 4)},
                        {within(x0, x1), within(y0, y1)})
      .with_goal_heading(uniform_int(random, 0, 1) == 0
                             ? std::nullopt
                             : std::optional(uniform_real(random, -4, 4)));
}

Scenario imported(const std::string& path) {
  const auto task = read_map_task(path);
  if (!task) throw std::runtime_error("no task file of " + path);
  return Scenario::grid(task->name, load_occupancy_grid(path), task->start, task->goal)
      .with_goal_heading(task->goal_heading);
}

TEST(MapExport, PreservesContentWhenReimported) {
  RandomEngine random(21);
  const MapFolder folder;
  const std::vector<std::pair<std::string, std::string>> maps = {{"ros", "a.yaml"},
                                                                 {"mrpt", "b.gridmap.gz"}};
  for (int round = 0; round < 60; ++round) {
    const Scenario scenario = random_grid_scenario(random);
    for (const auto& [format, name] : maps) {
      export_scenario(scenario, format, {}, folder.path(name));
      const Scenario again = imported(folder.path(name));
      ASSERT_EQ(again.hash(), scenario.hash()) << format;
      ASSERT_EQ(again.name(), scenario.name());
    }
    export_scenario(scenario, "yaml", {}, folder.path("c.scenario.yaml"));
    ASSERT_EQ(load_scenario_yaml(folder.path("c.scenario.yaml")).hash(), scenario.hash());
  }
}

Scenario disc_scenario() {
  Primitives obstacles;
  obstacles.discs.push_back({{2, 1.5}, 0.4});
  return Scenario::continuous("disc -- & <one>", {0, 0, 4, 3}, obstacles, {0.5, 0.5, M_PI / 2},
                              {3.5, 2.5});
}

TEST(MapExport, ConvertsOtherRepresentationsToCells) {
  const MapFolder folder;
  MapExportOptions options;
  options.resolution = 0.25;
  for (const std::string format : {"ros", "mrpt"}) {
    const std::string path = folder.path(format == "ros" ? "d.yaml" : "d.gridmap.gz");
    export_scenario(disc_scenario(), format, options, path);
    EXPECT_EQ(imported(path).hash(), convert(disc_scenario(), Representation::Grid, 0.25).hash());
  }
}

TEST(MapExport, AddsABorderToAnMvsimWorld) {
  const MapFolder folder;
  MapExportOptions options;
  options.resolution = 0.25;
  export_scenario(disc_scenario(), "mvsim", options, folder.path("d.world.xml"));
  const std::string xml = bytes_of_file(folder.path("d.world.xml"));
  EXPECT_TRUE(has(xml, "<element class=\"occupancy_grid\">\n    <file>d.gridmap</file>"));
  EXPECT_TRUE(has(xml, "Slalom scenario disc - - & <one>")) << "no double dash within a comment";
  EXPECT_TRUE(has(xml, "0.5 0.5 90\n")) << "degrees";
  const auto map = load_occupancy_grid(folder.path("d.gridmap"));
  const Occupancy cells = make_occupancy(disc_scenario(), 0.25);
  ASSERT_EQ(map.getSizeX(), 18U);  // 4 m are 16 cells, plus a wall on either side
  ASSERT_EQ(map.getSizeY(), 14U);
  EXPECT_FLOAT_EQ(map.getXMin(), -0.25F);
  for (int y = 0; y < 14; ++y)
    for (int x = 0; x < 18; ++x)
      EXPECT_EQ(map.getCell(x, y) < 0.5F, cells.occupied(x - 1, y - 1)) << x << ' ' << y;
}

TEST(MapExport, RendersImages) {
  const MapFolder folder;
  export_scenario(disc_scenario(), "svg", {}, folder.path("d.svg"));
  EXPECT_TRUE(has(bytes_of_file(folder.path("d.svg")), "<svg"));
  export_scenario(disc_scenario(), "png", {}, folder.path("d.png"));
  const GrayImage image = read_gray_image(folder.path("d.png"));
  EXPECT_EQ(image.width, 800);
  EXPECT_EQ(image.height, 600);
  EXPECT_LT(image.pixels[300U * 800U + 400U], 200) << "the disc at the center";
  EXPECT_EQ(image.pixels[20U * 800U + 400U], 255);
}

TEST(MapExport, ShowsMoversWithTheirPathsInPictures) {
  const MapFolder folder;
  // 800 pixels for 4 m, so 200 per m; y upwards, 600 pixels high. It waits at (1, 2.5) until 1 s.
  const Mover walker{"walker", 0.2, {{0, {1, 2.5}}, {1, {1, 2.5}}, {5, {3, 2.5}}}, MoverEnd::Stop};
  const auto picture = [&](const Scenario& scenario, const SceneOptions& options) {
    render_png(scenario, options, folder.path("w.png"));
    return read_gray_image(folder.path("w.png"));
  };
  SceneOptions options;
  options.max_pixels = 800;
  const auto at = [](const GrayImage& image, double x, double y) {
    return image
        .pixels[static_cast<std::size_t>(600 - 200 * y) * 800U + static_cast<std::size_t>(200 * x)];
  };
  const Scenario moving = disc_scenario().with_movers({walker});
  const GrayImage still = picture(disc_scenario(), options), begin = picture(moving, options);
  EXPECT_EQ(at(still, 1, 2.6), 255);
  EXPECT_LT(at(begin, 1, 2.6), 200) << "the disc at 0 s";
  EXPECT_EQ(at(begin, 1, 2.75), 255) << "beyond its radius";
  EXPECT_LT(at(begin, 2.5, 2.5), 200) << "the path";
  EXPECT_EQ(at(begin, 2.5, 2.6), 255);
  options.time = 4;  // 3 of 4 s of the way: at (2.5, 2.5)
  const GrayImage later = picture(moving, options);
  EXPECT_LT(at(later, 2.5, 2.6), 200);
  EXPECT_EQ(at(later, 1, 2.6), 255);
}

TEST(MapExport, LeavesNoTemporaryFiles) {
  const MapFolder folder;
  for (const ExportFormat& format : export_formats()) {
    const std::string path = folder.path("no/such/folder/x" + format.ending);
    EXPECT_TRUE(throws_error(ErrorKind::Job, "", {"no/such/folder/x"}, [&] {
      export_scenario(disc_scenario(), format.name, {}, path);
    })) << format.name;
  }
  for (const ExportFormat& format : export_formats())
    export_scenario(disc_scenario(), format.name, {}, folder.path("x" + format.ending));
  for (const auto& file : std::filesystem::directory_iterator(folder.path("")))
    EXPECT_FALSE(has(file.path().filename().string(), ".tmp")) << file.path();
}

TEST(MapExport, AppendsTheExtensionOfTheFormat) {
  const MapFolder folder;
  for (const ExportFormat& format : export_formats()) {
    export_scenario(disc_scenario(), format.name, {}, folder.path(format.name));
    EXPECT_TRUE(std::filesystem::exists(folder.path(format.name + format.ending)));
  }
}

TEST(MapExport, RejectsUnknownFormatsAndExtensions) {
  EXPECT_TRUE(throws_error(ErrorKind::Usage,
                           "format: ", {"unknown", "'stl'", "yaml, ros, mrpt, mvsim, svg, png"},
                           [] { export_scenario(disc_scenario(), "stl", {}, "/nowhere/d.stl"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "/nowhere/d.pgm: ", {"format ros", ".yaml"},
                           [] { export_scenario(disc_scenario(), "ros", {}, "/nowhere/d.pgm"); }));
}

TEST(MapTask, IsNextToItsMap) {
  EXPECT_EQ(task_path("a/office.gridmap.gz"), "a/office.task.yaml");
  EXPECT_EQ(task_path("a/office.yaml"), "a/office.task.yaml");
  EXPECT_FALSE(read_map_task("/nowhere/office.yaml"));
}

TEST(MapTask, ReportsErrors) {
  const auto rejects = [](const std::string& text, const std::string& where,
                          const std::string& word) {
    return throws_error(ErrorKind::File, where, {word}, [&] { parse_map_task(text, "t.yaml"); });
  };
  EXPECT_TRUE(rejects("name: a\nstart: [1, 2]\ngoal: [1, 2]\n", "t.yaml: ", "malformed 'start'"));
  EXPECT_TRUE(
      rejects("name: a\nstart: [1, 2, .nan]\ngoal: [1, 2]\n", "t.yaml: ", "malformed 'start'"));
  EXPECT_TRUE(rejects("name: a\nstart: [1, 2, 3]\n", "t.yaml: ", "malformed 'goal'"));
  EXPECT_TRUE(rejects("start: [1, 2, 3]\n", "t.yaml: ", "not a task"));
  EXPECT_TRUE(rejects("- 1\n", "t.yaml: ", "not a task"));
  EXPECT_TRUE(rejects("name: [a\n", "t.yaml:2: ", "not YAML"));
}

TEST(MapExport, SaysThatMoversAreLeftOut) {
  const MapFolder folder;
  const Mover walker{"walker", 0.3, {{0, {3, 1}}}, MoverEnd::Stop};
  const Scenario still = disc_scenario(), moving = still.with_movers({walker});
  for (const ExportFormat& format : export_formats()) {
    const std::string path = folder.path("moving" + format.ending);
    EXPECT_EQ(export_scenario(still, format.name, {}, path), "") << format.name;
    const std::string left_out = export_scenario(moving, format.name, {}, path);
    if (format.has_movers) {
      EXPECT_EQ(left_out, "") << format.name;
      const bool is_text = format.name != "png";
      EXPECT_EQ(read_file(path, "an export").find("walker") != std::string::npos, is_text)
          << format.name;
    } else {
      EXPECT_EQ(left_out, "scenario " + moving.name() +
                              ": 1 moving obstacle left out, the format " + format.name +
                              " has static obstacles only");
    }
  }
  const Scenario walked = moving.with_people({{"anna", 0.25, 1.3, {1, 1}, {{2, 1}}}});
  const auto left_out = [&](const std::string& format, const std::string& ending) {
    return export_scenario(walked, format, {}, folder.path("walked" + ending));
  };
  const std::string where = "scenario " + walked.name();
  EXPECT_EQ(left_out("yaml", ".yaml"), "");
  EXPECT_EQ(left_out("svg", ".svg"), where + ": 1 person left out, the format svg has no people");
  EXPECT_EQ(left_out("mrpt", ".gridmap.gz"),
            where +
                ": 1 moving obstacle and 1 person left out, the format mrpt has static "
                "obstacles only");
  const std::string world = folder.path("world.xml");
  export_scenario(still, "mvsim", {}, world);
  EXPECT_EQ(read_file(world, "an export").find("moving"), std::string::npos);
  export_scenario(moving, "mvsim", {}, world);
  EXPECT_NE(read_file(world, "an export").find("without its moving obstacles: 1"),
            std::string::npos);
}

}  // namespace
}  // namespace slalom
