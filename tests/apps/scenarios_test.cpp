// SPDX-License-Identifier: BSD-3-Clause
#include "program_run.h"

#include <nlohmann/json.hpp>

#include <chrono>

namespace slalom {
namespace {

class Scenarios : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("generate.ini",
          "[scenarios]\ngenerator = random\n[generator.random]\nwidth = 6\nheight = 6\n"
          "min_distance = 3\nmax_obstacles = 8\n");
  }
  /// A room of 3 m x 2 m with cells of 0.5 m as a ROS map, divided by a wall if `split`.
  void write_room(bool split) const {
    std::string pixels;
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 6; ++column)
        pixels += split && column == 3 ? '\0' : static_cast<char>(254);
    write("room.pgm", "P5\n6 4\n255\n" + pixels);
    write("room.yaml",
          "image: room.pgm\nresolution: 0.5\norigin: [-1, 2, 0]\nnegate: 0\n"
          "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  }
};

TEST_F(Scenarios, GeneratesTheSameListFromTheSameSeed) {
  const std::string generate = "slalom-scenarios generate -c generate.ini -n 5 --quiet --seed ";
  ASSERT_EQ(run(generate + "7 -o a.scenarios").status, 0);
  ASSERT_EQ(run(generate + "7 -o b.scenarios").status, 0);
  ASSERT_EQ(run(generate + "8 -o c.scenarios").status, 0);
  const std::string a = run("slalom-scenarios list a.scenarios").out;
  EXPECT_EQ(std::count(a.begin(), a.end(), '\n'), 5);
  EXPECT_EQ(a, run("slalom-scenarios list b.scenarios").out);
  EXPECT_NE(a, run("slalom-scenarios list c.scenarios").out);
}

/// The objects printed by `describe --json`, without computing times. If the wall time of the
/// program is given, each computing time must be positive and shorter.
std::vector<nlohmann::json> descriptions_in(const std::string& text, double wall_ms = 0) {
  std::vector<nlohmann::json> descriptions;
  std::istringstream lines(text);
  std::string line;
  while (std::getline(lines, line)) {
    descriptions.push_back(nlohmann::json::parse(line));
    for (auto& detail : descriptions.back()["details"]) {
      if (wall_ms > 0) {
        EXPECT_GT(detail["time_ms"].get<double>(), 0);
        EXPECT_LT(detail["time_ms"].get<double>(), wall_ms);
      }
      detail.erase("time_ms");
    }
  }
  return descriptions;
}

TEST_F(Scenarios, DescribesAndStoresValues) {
  ASSERT_EQ(run("slalom-scenarios generate -c generate.ini -n 2 --quiet -o a.scenarios").status, 0);
  const auto begin = std::chrono::steady_clock::now();
  const ProgramResult first = run("slalom-scenarios describe a.scenarios --json");
  const std::chrono::duration<double, std::milli> elapsed =
      std::chrono::steady_clock::now() - begin;
  ASSERT_EQ(first.status, 0) << first.err;
  const auto descriptions = descriptions_in(first.out, elapsed.count());
  ASSERT_EQ(descriptions.size(), 2U);
  for (const auto& json : descriptions) {
    EXPECT_GE(json["detour_ratio"].get<double>(), 1);
    // The configuration space also contains the inflated borders.
    EXPECT_GT(json["cspace_density"].get<double>(), json["density"].get<double>());
    EXPECT_LE(json["confinement"].get<double>(), 1);
    const auto& detail = json["details"]["confinement"];
    EXPECT_EQ(detail["unit"], "-");
    EXPECT_EQ(detail["version"], 1);
    EXPECT_EQ(detail["parameters"], "sensor_range=8;resolution=0.05");
    EXPECT_LE(detail["standard_error"].get<double>(), 0.005);
  }
  EXPECT_EQ(descriptions, descriptions_in(run("slalom-scenarios describe a.scenarios --json").out));
}

TEST_F(Scenarios, DescribesWithFootprintAndExactConfinement) {
  ASSERT_EQ(run("slalom-scenarios generate -c generate.ini -n 1 --quiet -o a.scenarios").status, 0);
  const std::string describe =
      "slalom-scenarios describe a.scenarios --json --resolution 0.1"
      " --descriptors cspace_density,confinement";
  const auto disc = descriptions_in(run(describe).out).at(0);
  const auto box =
      descriptions_in(
          run(describe + " --footprint '-0.4,-0.2;0.4,-0.2;0.4,0.2;-0.4,0.2' --exact-confinement")
              .out)
          .at(0);
  EXPECT_EQ(disc["details"]["cspace_density"]["parameters"], "robot_radius=0.25;resolution=0.1");
  EXPECT_EQ(box["details"]["cspace_density"]["parameters"],
            "footprint=-0.4,-0.2 0.4,-0.2 0.4,0.2 -0.4,0.2;resolution=0.1");
  EXPECT_GT(box["cspace_density"], disc["cspace_density"]);
  EXPECT_FALSE(box["details"]["confinement"].contains("standard_error"));
  EXPECT_NEAR(box["confinement"].get<double>(), disc["confinement"].get<double>(), 0.03);
  expect_failure(describe + " --footprint 0,1", 2, {"--footprint", "3 to 64 corners"});
}

TEST_F(Scenarios, ImportsARosMapAtItsOrigin) {
  write_room(false);
  ASSERT_EQ(run("slalom-scenarios import room.yaml -o room.scenarios --start=-0.5,3,0 --goal 1.5,3")
                .status,
            0);
  const std::string text = run("slalom-scenarios show room.scenarios --id room").out;
  EXPECT_NE(text.find("6 x 4 cells of 0.5 m"), std::string::npos) << text;
  EXPECT_NE(text.find("x -1 to 2 m, y 2 to 4 m"), std::string::npos) << text;
}

TEST_F(Scenarios, RejectsAnUnsolvablePair) {
  write_room(true);
  expect_failure(
      "slalom-scenarios import room.yaml -o room.scenarios --start=-0.5,3,0 --goal 1.5,3", 1,
      {"room", "unsolvable"});
  expect_failure("slalom-scenarios import room.yaml -o room.scenarios", 2,
                 {"start and goal", "--pairs"});
  expect_failure("slalom-scenarios import room.yaml -o room.scenarios --start 1 --goal 1,2", 2,
                 {"--start 1", "x,y,phi"});
}

TEST_F(Scenarios, ReferencesHaveACertificate) {
  write_room(false);
  ASSERT_EQ(run("slalom-scenarios import room.yaml -o room.scenarios --start=-0.5,3,0 --goal 1.5,3")
                .status,
            0);
  const auto json =
      nlohmann::json::parse(run("slalom-scenarios reference room.scenarios --json").out);
  // No obstacles: 2 m straight.
  EXPECT_NEAR(json["shortest_length"].get<double>(), 2, 1e-9);
  EXPECT_LE(json["lower_bound"].get<double>(), 2 + 1e-9);
}

TEST_F(Scenarios, ReferencesNameTheNarrowestPlaceAndDrawIt) {
  // A door of 1 m; cells of 5 cm that its edges touch are occupied, too.
  write("door.scenario.yaml",
        "name: door\nrepresentation: continuous\nbounds: [0, 0, 6, 4]\nstart: [1, 2, 0]\n"
        "goal: [5, 2]\ndiscs: []\npolygons:\n  - [[3, 0], [3.2, 0], [3.2, 1.5], [3, 1.5]]\n"
        "  - [[3, 2.5], [3.2, 2.5], [3.2, 4], [3, 4]]\n");
  const std::string import = "slalom-scenarios import door.scenario.yaml ";
  ASSERT_EQ(run(import + "-o door.scenarios").status, 0);
  const ProgramResult found = run("slalom-scenarios reference door.scenarios --json -o door.svg");
  ASSERT_EQ(found.status, 0) << found.err;
  const auto json = nlohmann::json::parse(found.out);
  EXPECT_NEAR(json["narrowest_width"].get<double>(), 0.9, 0.1);
  EXPECT_NEAR(json["narrowest_place"][0].get<double>(), 3.1, 0.15);
  EXPECT_NEAR(json["narrowest_place"][1].get<double>(), 2, 0.05);
  EXPECT_NE(run("slalom-scenarios reference door.scenarios").out.find("\n  narrowest_place = ["),
            std::string::npos);
  const std::string picture = read("door.svg");
  EXPECT_NE(picture.find("<svg"), std::string::npos);
  EXPECT_NE(picture.find("polyline"), std::string::npos);
  ASSERT_EQ(run("slalom-scenarios generate -c generate.ini -n 2 --quiet -o two.scenarios").status,
            0);
  expect_failure("slalom-scenarios reference two.scenarios -o two.svg", 2,
                 {"-o", "2 scenarios", "one scenario"});
  expect_failure("slalom-scenarios reference door.scenarios -o door.gif", 2, {".png or .svg"});
}

TEST_F(Scenarios, RendersExportsAndImports) {
  ASSERT_EQ(run("slalom-scenarios generate -c generate.ini -n 1 --quiet -o a.scenarios").status, 0);
  const std::string id = run("slalom-scenarios list a.scenarios").out.substr(0, 8);
  ASSERT_EQ(run("slalom-scenarios render a.scenarios --id " + id + " -o a.png").status, 0);
  EXPECT_EQ(read("a.png").substr(1, 3), "PNG");
  ASSERT_EQ(run("slalom-scenarios render a.scenarios --id " + id + " -o a.svg").status, 0);
  EXPECT_EQ(read("a.svg").substr(0, 4), "<svg");
  ASSERT_EQ(
      run("slalom-scenarios export a.scenarios --id " + id + " --format yaml -o a.scenario.yaml")
          .status,
      0);
  ASSERT_EQ(run("slalom-scenarios import a.scenario.yaml -o b.scenarios --quiet").status, 0);
  EXPECT_EQ(run("slalom-scenarios list b.scenarios").out,
            run("slalom-scenarios list a.scenarios").out);
  expect_failure("slalom-scenarios render a.scenarios --id " + id + " -o a.bmp", 2,
                 {"a.bmp", ".png or .svg"});
  expect_failure("slalom-scenarios show a.scenarios --id nobody", 2, {"nobody"});
}

TEST_F(Scenarios, MrptDataSetsAreImported) {
  const ProgramResult result =
      run("slalom-scenarios import /usr/share/mrpt/datasets/localization_demo.simplemap.gz "
          "-o demo.scenarios --pairs 2 --seed 3");
  ASSERT_EQ(result.status, 0) << result.err;
  const std::string list = run("slalom-scenarios list demo.scenarios").out;
  EXPECT_EQ(std::count(list.begin(), list.end(), '\n'), 2);
}

}  // namespace
}  // namespace slalom
