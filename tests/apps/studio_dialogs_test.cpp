// SPDX-License-Identifier: BSD-3-Clause
#include "studio_fixture.h"

namespace slalom {
namespace {

class StudioDialogs : public StudioTest {
 protected:
  std::size_t scenarios_in(const std::string& list) const {
    const std::string shown = run("slalom-scenarios list " + list).out;
    return static_cast<std::size_t>(std::count(shown.begin(), shown.end(), '\n'));
  }
  void expect_image(const std::string& name) const {
    EXPECT_GT(std::filesystem::file_size(folder_ / name), 10000U) << name;
  }

  /// 8 x 4 cells with a wall in the middle and a gap at the bottom.
  void write_map() const {
    write("m.map", "type octile\nheight 4\nwidth 8\nmap\n....@...\n....@...\n....@...\n........\n");
  }
};

TEST_F(StudioDialogs, OpensAListThroughTheTableOfAFolder) {
  std::filesystem::create_directories(folder_ / "lists/empty");
  make_list(2, "lists/b.scenarios");
  for (int i = 100; i < 200; ++i) write("lists/a_" + std::to_string(i) + ".scenarios", "");
  expect_played(
      "size 1280 800\n"
      "wait idle\n"
      "do file.open\n"
      "wait idle\n"
      "expect folder contains lists/\n"
      "expect folder lacks generate.ini\n"
      "click folder lists/\n"
      "wait idle\n"
      "expect dialog contains \"List: lists/\"\n"
      "screenshot folder.png\n"
      "click folder empty/\n"
      "expect folder lacks b.scenarios\n"
      "click folder ../\n"
      "wheel -100 folder\n"
      "click folder b.scenarios at 0.9 0.5\n"  // scrolls to it
      "expect dialog contains \"List: lists/b.scenarios\"\n"
      "key Enter\n"
      "wait idle\n"
      "expect list contains \"2 scenarios\"\n");
  expect_image("folder.png");
}

TEST_F(StudioDialogs, SaysWhyAFolderCannotBeRead) {
  expect_played(
      "do file.open\n"
      "wait idle\n"
      "type none/x\n"
      "wait idle\n"
      "expect folder contains \"No such file\"\n"
      "screenshot none.png\n"
      "click folder ../\n"
      "expect dialog contains \"List: x\"\n");
}

TEST_F(StudioDialogs, PutDroppedFilesIntoTheirField) {
  make_list(2);
  write_map();
  expect_played(
      "do file.open\n"
      "drop a.scenarios m.map\n"
      "expect dialog contains \"List: 2 files dropped; expected one\"\n"
      "drop a.scenarios\n"
      "key Enter\n"
      "wait idle\n"
      "expect list contains \"2 scenarios\"\n"
      "do file.import\n"
      "drop m.map a.scenarios\n"
      "drop generate.ini\n"
      "expect dialog contains \"Files: a.scenarios, m.map, generate.ini\"\n"
      "key Escape\n"
      "do help.about\n"
      "drop a.scenarios\n"  // a message takes none
      "expect dialog contains Version\n");
}

TEST_F(StudioDialogs, GeneratesIntoTheOpenListUndoably) {
  make_list(2);
  expect_played(
      "size 1280 800\n"
      "wait idle\n"
      "do generate.random\n"
      "expect dialog contains \"Generate random scenarios\"\n"
      "click dialog \"choice families maze\"\n"
      "click dialog \"choice families random\"\n"
      "click dialog \"field count\"\n"
      "type 3\n"
      "key Tab\n"
      "type 7\n"
      "screenshot random.png\n"
      "click dialog ok\n"
      "wait idle\n"
      "expect list contains \"5 scenarios\"\n"
      "expect list contains \"maze_0000\"\n"
      "expect status contains \"3 scenarios added to a.scenarios\"\n"
      "key Ctrl+Z\n"
      "wait idle\n"
      "expect list contains \"2 scenarios\"\n"
      "key Ctrl+Y\n"
      "wait idle\n"
      "expect list contains \"5 scenarios\"\n",
      "a.scenarios");
  EXPECT_EQ(scenarios_in("a.scenarios"), 5U);
  expect_image("random.png");
}

TEST_F(StudioDialogs, GeneratesTheSameNewListAsTheCommandLine) {
  expect_played(
      "key Ctrl+G\n"
      "click dialog \"field count\"\n"
      "type 3\n"
      "click dialog \"field file\"\n"
      "type made.scenarios\n"
      "key Enter\n"
      "wait idle\n"
      "expect list contains \"3 scenarios\"\n");
  write("same.ini",
        "[scenarios]\ngenerator = random\ncount = 3\n[robot]\nradius = 0.25\n"
        "[simulation]\nresolution = 0.05\n");
  ASSERT_EQ(run("slalom-scenarios generate -c same.ini -o same.scenarios --quiet").status, 0);
  const std::string made = run("slalom-scenarios list made.scenarios --json").out;
  EXPECT_FALSE(made.empty());
  EXPECT_EQ(made, run("slalom-scenarios list same.scenarios --json").out);
}

TEST_F(StudioDialogs, ShowsErrorsInTheFormAndKeepsItOpen) {
  make_list(2);
  expect_played(
      "wait idle\n"
      "do generate.random\n"
      "click dialog \"field count\"\n"
      "type many\n"
      "key Enter\n"
      "expect dialog contains \"Number: 'many' is not valid\"\n"
      "click dialog \"field count\"\n"
      "key Ctrl+A\n"
      "type 2\n"
      "click dialog \"choice families random\"\n"
      "click dialog \"choice families crop\"\n"
      "key Enter\n"
      "expect dialog contains \"[generator.crop] map\"\n"
      "screenshot wrong.png\n"
      "key Escape\n"
      "expect list contains \"2 scenarios\"\n",
      "a.scenarios");
}

TEST_F(StudioDialogs, FillsBinsAndReportsTheResult) {
  make_list(1);
  expect_played(
      "size 1280 800\n"
      "wait idle\n"
      "do generate.bins\n"
      "screenshot bins.png\n"
      "click dialog \"choice families poisson_forest\"\n"
      "click dialog \"choice families cellular_automaton\"\n"
      "click dialog \"field edges.density\"\n"
      "type \"0, 0.1, 0.2\"\n"
      "click dialog \"field per_bin\"\n"
      "type 1\n"
      "key Enter\n"
      "wait idle\n"
      "expect dialog contains \"density 0.1 to 0.2: 1 of 1, full\"\n"
      "screenshot report.png\n"
      "key Enter\n"
      "expect list contains \"3 scenarios\"\n",
      "a.scenarios");
  EXPECT_NE(run("slalom-scenarios list a.scenarios").out.find("#bin_1"), std::string::npos);
}

TEST_F(StudioDialogs, CancelsAGenerationWithoutAddingScenarios) {
  make_list(1);
  expect_played(
      "wait idle\n"
      "do generate.random\n"
      "click dialog \"field count\"\n"
      "type 100000\n"
      "key Enter\n"
      "wait until status contains \"Generate random scenarios\"\n"
      "do generate.random\n"
      "expect status contains \"scenarios are being generated, imported, searched or shrunk\"\n"
      "click status cancel\n"
      "wait idle\n"
      "expect list contains \"1 scenario\"\n",
      "a.scenarios");
}

TEST_F(StudioDialogs, ImportsMapsLikeTheCommandLine) {
  make_list(1);
  write_map();
  const std::string input =
      "wait idle\n"
      "do file.import\n"
      "click dialog \"field files\"\n"
      "type m.map\n"
      "click dialog \"field start\"\n"
      "type 0.5,0.5,0\n"
      "click dialog \"field goal\"\n"
      "type 7.5,0.5\n";
  expect_played("size 1280 800\n" + input +
                    "screenshot import.png\n"
                    "key Enter\n"
                    "wait idle\n"
                    "expect dialog contains \"expected\"\n"
                    "key Enter\n"
                    "expect list contains \"1 scenario\"\n",
                "a.scenarios");
  expect_played(input +
                    "wheel -40 dialog\n"
                    "click dialog \"field cell_size\"\n"
                    "key Ctrl+A\n"
                    "type 1\n"
                    "screenshot import_end.png\n"
                    "key Enter\n"
                    "wait idle\n"
                    "expect list contains \"2 scenarios\"\n",
                "a.scenarios");
  ASSERT_EQ(run("slalom-scenarios import m.map --start 0.5,0.5,0 --goal 7.5,0.5 --cell-size 1 "
                "-o b.scenarios")
                .status,
            0);
  const std::string id = run("slalom-scenarios list b.scenarios").out.substr(0, 12);
  EXPECT_NE(run("slalom-scenarios list a.scenarios").out.find(id), std::string::npos);
}

TEST_F(StudioDialogs, OpensOrImportsDroppedFilesInAnyOrder) {
  make_list(2);
  for (const std::string name : {"x", "y"}) {
    const std::string id = name == "x" ? "random_0000" : "random_0001";
    ASSERT_EQ(
        run("slalom-scenarios export a.scenarios --id " + id + " -o " + name + ".scenario.yaml")
            .status,
        0);
  }
  const std::string both = run("slalom-scenarios list a.scenarios").out;
  for (const std::string files :
       {"x.scenario.yaml y.scenario.yaml", "y.scenario.yaml x.scenario.yaml"}) {
    make_list(3, "b.scenarios", 8);
    expect_played("drop " + files + " b.scenarios\n" +
                  "expect dialog contains \"x.scenario.yaml, y.scenario.yaml\"\n"
                  "key Enter\n"
                  "wait idle\n"
                  "expect list contains \"5 scenarios\"\n");
    EXPECT_NE(run("slalom-scenarios list b.scenarios").out.find(both), std::string::npos)
        << "sorted by name";
  }
}

TEST_F(StudioDialogs, ExportsTheCurrentScenario) {
  make_list(2);
  expect_played(
      "size 1280 800\n"
      "wait idle\n"
      "do file.export\n"
      "screenshot export.png\n"
      "click dialog \"choice format svg\"\n"
      "click dialog \"field file\"\n"
      "type shown\n"
      "key Enter\n"
      "wait idle\n"
      "expect status contains \"was exported to shown\"\n"
      "do file.export\n"
      "click dialog \"choice format svg\"\n"
      "click dialog \"field file\"\n"
      "type shown\n"
      "key Enter\n"
      "expect dialog contains \"already exists\"\n"
      "click dialog \"field replace\"\n"
      "key Enter\n"
      "wait idle\n"
      "expect status contains \"was exported to shown\"\n",
      "a.scenarios");
  EXPECT_NE(read("shown.svg").find("<svg"), std::string::npos);
}

}  // namespace
}  // namespace slalom
