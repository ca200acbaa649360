// SPDX-License-Identifier: BSD-3-Clause
#include "program_run.h"

#include <nlohmann/json.hpp>

namespace slalom {
namespace {

using Json = nlohmann::json;

std::vector<Json> lines_of(const std::string& text) {
  std::vector<Json> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(Json::parse(line));
  return lines;
}

class ScenarioLists : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("generate.ini",
          "[scenarios]\ngenerator = random\n[generator.random]\nwidth = 6\nheight = 6\n"
          "min_distance = 3\nmax_obstacles = 12\n");
    ASSERT_EQ(slalom("generate -c generate.ini -n 12 --quiet -o a.scenarios").status, 0);
  }
  ProgramResult slalom(const std::string& arguments) const {
    return run("slalom-scenarios " + arguments);
  }

  std::vector<std::string> names(const std::string& arguments) const {
    std::vector<std::string> names;
    const ProgramResult result = slalom(arguments + " --json");
    EXPECT_EQ(result.status, 0) << result.err;
    for (const Json& line : lines_of(result.out)) names.push_back(line["name"]);
    return names;
  }
};

TEST_F(ScenarioLists, SelectAgreesWithDescribe) {
  std::vector<std::pair<double, std::string>> expected;
  for (const Json& line : lines_of(slalom("describe a.scenarios --descriptors density --json").out))
    if (line["density"] >= 0.03)
      expected.emplace_back(-line["density"].get<double>(), line["name"]);
  std::sort(expected.begin(), expected.end());
  ASSERT_GE(expected.size(), 3U);
  const auto selected =
      names("select a.scenarios --where 'density >= 0.03' --order-by 'density desc'");
  ASSERT_EQ(selected.size(), expected.size());
  for (std::size_t i = 0; i < selected.size(); ++i) EXPECT_EQ(selected[i], expected[i].second);
  ASSERT_EQ(slalom("select a.scenarios --where 'density >= 0.03' --order-by 'density desc' "
                   "--limit 2 --quiet -o b.scenarios")
                .status,
            0);
  EXPECT_EQ(names("list b.scenarios"), (std::vector<std::string>{selected[0], selected[1]}));
}

TEST_F(ScenarioLists, NoOutputReplacesAnInputOrAFileOfAnotherKind) {
  const std::string ini = read("generate.ini"), list = read("a.scenarios");
  std::filesystem::create_symlink("a.scenarios", folder_ / "link.scenarios");
  const std::string convert = "slalom-scenarios convert a.scenarios --to grid --resolution 0.1 -o ";
  for (const std::string name : {"a.scenarios", "./a.scenarios", "link.scenarios"})
    expect_failure(convert + name, 2, {"-o " + name, "is also an input", "different"});
  expect_failure("slalom-scenarios generate -c generate.ini -n 2 -o generate.ini", 2,
                 {"-o generate.ini", "is also an input"});
  write("copy.ini", "[scenarios]\nlist = ./a.scenarios\n");
  expect_failure("slalom-scenarios generate -c copy.ini -o a.scenarios", 2,
                 {"-o a.scenarios", "is also an input", "copy.ini:2", "list = ./a.scenarios"});
  const std::string split = "slalom-scenarios split a.scenarios --fraction 0.5 ";
  expect_failure(split + "--development ./a.scenarios --held-out h.scenarios", 2,
                 {"--development ./a.scenarios", "is also an input", "different"});
  expect_failure(split + "--development d.scenarios --held-out link.scenarios", 2,
                 {"--held-out link.scenarios", "is also an input", "different"});
  expect_failure(convert + "generate.ini", 3, {"generate.ini", "different kind", "not replaced"});
  EXPECT_EQ(read("generate.ini"), ini);
  EXPECT_EQ(read("a.scenarios"), list);
}

TEST_F(ScenarioLists, MoversOfAFileReplaceThoseOfAScenario) {
  write("room.scenario.yaml",
        "name: room\nrepresentation: continuous\nbounds: [0, 0, 6, 4]\nstart: [1, 2, 0]\n"
        "goal: [5, 2]\ndiscs: []\npolygons: []\npublished_path:\n  field: [0, 0, 6, 4]\n"
        "  cell_size: 0.5\n  points:\n    - [1, 2]\n    - [5, 2]\n");
  write("walk.csv", "id,t,x,y\na,0,3,1\na,2,3,3\n");
  write("still.csv", "id,t,x,y\na,2,3,3\na,2,3,3\n");
  ASSERT_EQ(slalom("import room.scenario.yaml -o r.scenarios").status, 0);
  const std::string movers = "slalom-scenarios movers r.scenarios room ";
  expect_failure(movers, 2, {"no file specified", "a file, or --remove"});
  expect_failure(movers + "walk.csv --remove", 2, {"excludes"});
  expect_failure(movers + "still.csv", 3, {"still.csv:3", "does not follow"});
  expect_failure(movers + "none.csv", 3, {"none.csv"});
  const auto yaml = [&] {
    EXPECT_EQ(slalom("export r.scenarios room -o room.yaml").status, 0);
    const std::string text = read("room.yaml");
    std::filesystem::remove(folder_ / "room.yaml");
    return text;
  };
  EXPECT_NE(yaml().find("published_path"), std::string::npos);
  ASSERT_EQ(run(movers + "walk.csv").status, 0);
  const std::string walked = yaml();
  EXPECT_NE(walked.find("id: \"a\""), std::string::npos) << walked;
  EXPECT_EQ(walked.find("published_path"), std::string::npos) << "it is of the old content";
  ASSERT_EQ(run(movers + "--remove").status, 0);
  EXPECT_EQ(yaml().find("movers"), std::string::npos);
}

TEST_F(ScenarioLists, RecordedPeopleOfAFileReactInPlaceOfMovers) {
  write("room.scenario.yaml",
        "name: room\nrepresentation: continuous\nbounds: [0, 0, 6, 4]\nstart: [1, 2, 0]\n"
        "goal: [5, 2]\nmovers:\n  - {id: a, radius: 0.3, after: stop, waypoints: [[0, 3, 3]]}\n"
        "discs: []\npolygons: [[[4, 0], [4.6, 0], [4.6, 1], [4, 1]]]\n");
  write("walk.csv", "id,t,x,y\na,0,3,1\na,2,3,3\nfar,0,9,1\nfar,1,9,2\n");
  write("wall.csv", "id,t,x,y\nw,0,4.3,0.5\nw,1,4.3,0.6\n");
  ASSERT_EQ(slalom("import room.scenario.yaml -o r.scenarios").status, 0);
  const std::string movers = "slalom-scenarios movers r.scenarios room ";
  expect_failure(movers + "wall.csv --react", 3,
                 {"room: person 'w'", "no position with room", "from walls"});
  // The cell of 3 m around the wall covers x from 3 to 6 m, y up to 3 m.
  expect_failure(movers + "walk.csv --react --resolution 3", 3, {"no position with room"});
  const ProgramResult made = run(movers + "walk.csv --react");
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_NE(made.err.find("left out: 1 of 2"), std::string::npos) << made.err;
  const auto shown = [&] { return slalom("show r.scenarios room").out; };
  EXPECT_NE(shown().find("people          1"), std::string::npos) << shown();
  EXPECT_EQ(shown().find("movers"), std::string::npos) << shown();
  ASSERT_EQ(run(movers + "--remove --react").status, 0);
  EXPECT_EQ(shown().find("people"), std::string::npos) << shown();
}

TEST_F(ScenarioLists, IndexesAreCreatedUsedShownAndDropped) {
  const std::string select = "select a.scenarios --where 'density >= 0.02 and density < 0.05'";
  const auto before = names(select);
  EXPECT_NE(slalom(select + " --plan").out.find("SCAN"), std::string::npos);
  ASSERT_EQ(slalom("index create a.scenarios --name by_density --descriptor density "
                   "--edges 0,0.02,0.05,1 --quiet")
                .status,
            0);
  EXPECT_NE(slalom(select + " --plan").out.find("INDEX index_by_density"), std::string::npos);
  EXPECT_EQ(names(select), before);
  EXPECT_EQ(names("select a.scenarios --where 'by_density[1]'"), before);
  EXPECT_EQ(slalom("index list a.scenarios").out, "by_density  density  0,0.02,0.05,1\n");
  const Json shown = Json::parse(slalom("index show a.scenarios --name by_density --json").out);
  EXPECT_EQ(shown["counts"][1], before.size());
  expect_failure("slalom-scenarios index drop a.scenarios --name by_densty", 2,
                 {"unknown index 'by_densty'", "'by_density'"});
  ASSERT_EQ(slalom("index drop a.scenarios --name by_density").status, 0);
  EXPECT_EQ(slalom("index list a.scenarios").out, "");
}

TEST_F(ScenarioLists, CopiesMovesAndDeletes) {
  const auto all = names("list a.scenarios");
  const std::string two = "--ids " + all[1] + "," + all[4];
  ASSERT_EQ(slalom("copy a.scenarios " + two + " -o b.scenarios").status, 0);
  ASSERT_EQ(slalom("copy a.scenarios " + two + " -o b.scenarios").status, 0);
  EXPECT_EQ(names("list b.scenarios"), (std::vector<std::string>{all[1], all[4]}));
  ASSERT_EQ(slalom("move a.scenarios --where \"name = " + all[0] + "\" -o b.scenarios").status, 0);
  EXPECT_EQ(names("list b.scenarios").size(), 3U);
  EXPECT_EQ(names("list a.scenarios").size(), 11U);
  ASSERT_EQ(slalom("delete a.scenarios " + two + " -o c.scenarios").status, 0);
  EXPECT_EQ(names("list a.scenarios").size(), 11U);
  EXPECT_EQ(names("list c.scenarios").size(), 9U);
  ASSERT_EQ(slalom("delete a.scenarios " + two).status, 0);
  EXPECT_EQ(names("list a.scenarios"), names("list c.scenarios"));
  expect_failure("slalom-scenarios delete a.scenarios", 2,
                 {"delete a.scenarios", "--where", "--all"});
  ASSERT_EQ(slalom("delete c.scenarios --all").status, 0);
  EXPECT_TRUE(names("list c.scenarios").empty());
  ASSERT_EQ(slalom("delete c.scenarios --file").status, 0);
  expect_failure("slalom-scenarios list c.scenarios", 3, {"c.scenarios"});
  expect_failure("slalom-scenarios copy a.scenarios -o a.scenarios", 2,
                 {"a.scenarios", "different"});
}

TEST_F(ScenarioLists, DeletedScenariosAreListedAndRestored) {
  const auto all = names("list a.scenarios");
  EXPECT_EQ(slalom("restore a.scenarios").out, "");
  ASSERT_EQ(slalom("delete a.scenarios --quiet --ids " + all[1] + "," + all[4]).status, 0);
  ASSERT_EQ(slalom("delete a.scenarios --quiet --ids " + all[7]).status, 0);
  ASSERT_EQ(slalom("move a.scenarios --quiet --ids " + all[2] + " -o b.scenarios").status, 0);
  EXPECT_EQ(names("restore a.scenarios"), (std::vector<std::string>{all[7], all[1], all[4]}));
  EXPECT_EQ(names("restore b.scenarios"), std::vector<std::string>{});
  const std::string id = lines_of(slalom("restore a.scenarios --json").out)[1]["id"];
  EXPECT_EQ(slalom("restore a.scenarios " + id + " " + all[7]).err, "a.scenarios: 10 scenarios\n");
  EXPECT_EQ(names("restore a.scenarios"), std::vector<std::string>{all[4]});
  const std::string restore = "slalom-scenarios restore a.scenarios ";
  expect_failure(restore + all[7], 2, {"a.scenarios: unknown deleted scenario '" + all[7] + "'"});
  expect_failure(restore + all[4] + "x", 2, {"unknown deleted scenario", "expected '" + all[4]});
  expect_failure(restore + "--all " + all[4], 2, {"--all"});
  EXPECT_EQ(slalom("restore a.scenarios --all").err, "a.scenarios: 11 scenarios\n");
  EXPECT_EQ(slalom("restore a.scenarios --all --quiet").err, "");
  std::vector<std::string> others = all;
  others.erase(others.begin() + 2);
  EXPECT_EQ(names("list a.scenarios"), others) << "in their places";
}

TEST_F(ScenarioLists, TagsAndNamesAreKept) {
  const auto all = names("list a.scenarios");
  ASSERT_EQ(slalom("tag a.scenarios --ids " + all[2] + " --add narrow,hard").status, 0);
  ASSERT_EQ(slalom("tag a.scenarios --where 'tag = hard' --remove hard").status, 0);
  ASSERT_EQ(slalom("rename a.scenarios --id " + all[2] + " --name doorway").status, 0);
  const auto selected = lines_of(slalom("select a.scenarios --where 'tag = narrow' --json").out);
  ASSERT_EQ(selected.size(), 1U);
  EXPECT_EQ(selected[0]["name"], "doorway");
  EXPECT_EQ(selected[0]["tags"], Json::array({"narrow"}));
  expect_failure("slalom-scenarios tag a.scenarios --add 'two words'", 2, {"two words", "letters"});
  expect_failure("slalom-scenarios tag a.scenarios", 2, {"--add"});
}

TEST_F(ScenarioLists, AreMergedDeduplicatedAndSplit) {
  ASSERT_EQ(slalom("generate -c generate.ini -n 8 --seed 9 --quiet -o b.scenarios").status, 0);
  ASSERT_EQ(slalom("merge a.scenarios b.scenarios a.scenarios -o m.scenarios").status, 0);
  EXPECT_EQ(names("list m.scenarios").size(), 20U);
  ASSERT_EQ(slalom("split m.scenarios --fraction 0.4 --seed 3 --development d.scenarios "
                   "--held-out h.scenarios")
                .status,
            0);
  const auto held = names("list h.scenarios");
  EXPECT_EQ(names("list d.scenarios").size() + held.size(), 20U);
  EXPECT_GT(held.size(), 0U);
  // With the lists merged in reverse order, each scenario is in the same part.
  ASSERT_EQ(slalom("merge b.scenarios a.scenarios -o n.scenarios").status, 0);
  ASSERT_EQ(slalom("split n.scenarios --fraction 0.4 --seed 3 --development d.scenarios "
                   "--held-out h.scenarios")
                .status,
            0);
  auto again = names("list h.scenarios"), sorted = held;
  std::sort(again.begin(), again.end());
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(again, sorted);
  ASSERT_EQ(slalom("dedupe m.scenarios --by density:10 --quiet -o one.scenarios").status, 0);
  EXPECT_EQ(names("list one.scenarios").size(), 1U) << "no densities differ by 10";
  expect_failure("slalom-scenarios dedupe m.scenarios --by density", 2, {"--by density", "NUMBER"});
}

TEST_F(ScenarioLists, VerbsTakeAScenarioByNameOrIdAsAnArgumentOrAnOption) {
  const Json entry = lines_of(slalom("list a.scenarios --json").out)[3];
  const std::string id = entry["id"], name = entry["name"], shown = "name            " + name;
  const std::vector<std::string> forms = {name,           id,           id.substr(0, 8),
                                          "--id " + name, "--id " + id, name + " --id " + name};
  for (const std::string& form : forms) {
    EXPECT_EQ(slalom("show a.scenarios " + form).out.substr(0, shown.size()), shown) << form;
    EXPECT_EQ(slalom("render a.scenarios -o a.svg " + form).status, 0) << form;
    EXPECT_EQ(slalom("export a.scenarios -o a.yaml " + form).status, 0) << form;
    const ProgramResult reference = slalom("reference a.scenarios --json " + form);
    EXPECT_EQ(Json::parse(reference.out)["id"], id) << form << reference.err;
  }
  for (const std::string verb :
       {"show", "render -o a.svg", "export -o a.yaml", "reference", "rename --name other"}) {
    for (const std::string option : {"", "--id "})
      expect_failure("slalom-scenarios " + verb + " a.scenarios " + option + "random_003", 2,
                     {"a.scenarios: unknown scenario 'random_003'", "expected 'random_00"});
    expect_failure("slalom-scenarios " + verb + " a.scenarios random_0001 --id random_0002", 2,
                   {"random_0001", "random_0002"});
    if (verb != "reference")
      expect_failure("slalom-scenarios " + verb + " a.scenarios", 2, {"scenario is required"});
  }
  ASSERT_EQ(slalom("rename a.scenarios " + id + " --name doorway").status, 0);
  EXPECT_EQ(slalom("show a.scenarios doorway").status, 0);
}

TEST_F(ScenarioLists, VerbsReportThatNoScenarioMatches) {
  const auto all = names("list a.scenarios");
  const std::string none = " a.scenarios --where 'density > 2' ";
  for (const std::string& command :
       {"select" + none, "select" + none + "-o b.scenarios", "copy" + none + "-o b.scenarios",
        "move" + none + "-o b.scenarios", "delete" + none, "tag" + none + "--add hard"}) {
    const ProgramResult result = slalom(command);
    EXPECT_EQ(result.status, 0) << command;
    EXPECT_NE(result.err.find("a.scenarios: no scenario matches density > 2\n"), std::string::npos)
        << command << "\n"
        << result.err;
    EXPECT_EQ(result.out, "") << command;
    EXPECT_EQ(slalom(command + " --quiet").err, "") << command;
  }
  EXPECT_NE(slalom("select" + none + "--ids " + all[0])
                .err.find("no scenario matches density > 2, ids " + all[0]),
            std::string::npos);
  EXPECT_EQ(names("list a.scenarios"), all);
}

TEST_F(ScenarioLists, ErrorsAreReportedWithTheirPosition) {
  expect_failure("slalom-scenarios select a.scenarios --where 'densty > 1'", 2,
                 {"selection, character 1", "'density'"});
  expect_failure("slalom-scenarios select a.scenarios --order-by 'density up'", 2, {"character 9"});
  expect_failure("slalom-scenarios select a.scenarios --ids nobody", 2,
                 {"unknown scenario 'nobody'"});
  expect_failure(
      "slalom-scenarios index create a.scenarios --name x --descriptor density --edges 1,0", 2,
      {"increasing edges"});
  expect_failure(
      "slalom-scenarios index create a.scenarios --name x --descriptor densty --edges 0,1", 2,
      {"'densty'", "'density'"});
  expect_failure(
      "slalom-scenarios index create a.scenarios --name name --descriptor density --edges 0,1", 2,
      {"name of a field"});
  expect_failure("slalom-scenarios merge a.scenarios none.scenarios -o m.scenarios", 3,
                 {"none.scenarios"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "m.scenarios"));
}

}  // namespace
}  // namespace slalom
