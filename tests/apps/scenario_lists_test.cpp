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
  Ended slalom(const std::string& arguments) const { return run("slalom-scenarios " + arguments); }

  std::vector<std::string> names(const std::string& arguments) const {
    std::vector<std::string> names;
    const Ended ended = slalom(arguments + " --json");
    EXPECT_EQ(ended.status, 0) << ended.err;
    for (const Json& line : lines_of(ended.out)) names.push_back(line["name"]);
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
  const auto chosen =
      names("select a.scenarios --where 'density >= 0.03' --order-by 'density desc'");
  ASSERT_EQ(chosen.size(), expected.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) EXPECT_EQ(chosen[i], expected[i].second);
  ASSERT_EQ(slalom("select a.scenarios --where 'density >= 0.03' --order-by 'density desc' "
                   "--limit 2 --quiet -o b.scenarios")
                .status,
            0);
  EXPECT_EQ(names("list b.scenarios"), (std::vector<std::string>{chosen[0], chosen[1]}));
}

TEST_F(ScenarioLists, IndexesAreMadeUsedShownAndDropped) {
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
  expect_refusal("slalom-scenarios index drop a.scenarios --name by_densty", 2,
                 {"no index 'by_densty'", "'by_density'"});
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
  expect_refusal("slalom-scenarios delete a.scenarios", 2, {"which scenarios?", "--all"});
  ASSERT_EQ(slalom("delete c.scenarios --all").status, 0);
  EXPECT_TRUE(names("list c.scenarios").empty());
  ASSERT_EQ(slalom("delete c.scenarios --file").status, 0);
  expect_refusal("slalom-scenarios list c.scenarios", 3, {"c.scenarios"});
  expect_refusal("slalom-scenarios copy a.scenarios -o a.scenarios", 2, {"a.scenarios", "another"});
}

TEST_F(ScenarioLists, TagsAndNamesAreKept) {
  const auto all = names("list a.scenarios");
  ASSERT_EQ(slalom("tag a.scenarios --ids " + all[2] + " --add narrow,hard").status, 0);
  ASSERT_EQ(slalom("tag a.scenarios --where 'tag = hard' --remove hard").status, 0);
  ASSERT_EQ(slalom("rename a.scenarios --id " + all[2] + " --name doorway").status, 0);
  const auto chosen = lines_of(slalom("select a.scenarios --where 'tag = narrow' --json").out);
  ASSERT_EQ(chosen.size(), 1U);
  EXPECT_EQ(chosen[0]["name"], "doorway");
  EXPECT_EQ(chosen[0]["tags"], Json::array({"narrow"}));
  expect_refusal("slalom-scenarios tag a.scenarios --add 'two words'", 2, {"two words", "letters"});
  expect_refusal("slalom-scenarios tag a.scenarios", 2, {"--add"});
}

TEST_F(ScenarioLists, AreMergedDeduplicatedAndSplit) {
  ASSERT_EQ(slalom("generate -c generate.ini -n 8 --seed 9 --quiet -o b.scenarios").status, 0);
  ASSERT_EQ(slalom("merge a.scenarios b.scenarios a.scenarios -o m.scenarios").status, 0);
  EXPECT_EQ(names("list m.scenarios").size(), 20U);
  ASSERT_EQ(slalom("split m.scenarios --share 0.4 --seed 3 --development d.scenarios "
                   "--held-out h.scenarios")
                .status,
            0);
  const auto held = names("list h.scenarios");
  EXPECT_EQ(names("list d.scenarios").size() + held.size(), 20U);
  EXPECT_GT(held.size(), 0U);
  // The other way round, each scenario is on the same side.
  ASSERT_EQ(slalom("merge b.scenarios a.scenarios -o n.scenarios").status, 0);
  ASSERT_EQ(slalom("split n.scenarios --share 0.4 --seed 3 --development d.scenarios "
                   "--held-out h.scenarios")
                .status,
            0);
  auto again = names("list h.scenarios"), sorted = held;
  std::sort(again.begin(), again.end());
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(again, sorted);
  ASSERT_EQ(slalom("dedupe m.scenarios --by density:10 --quiet -o one.scenarios").status, 0);
  EXPECT_EQ(names("list one.scenarios").size(), 1U) << "no densities differ by 10";
  expect_refusal("slalom-scenarios dedupe m.scenarios --by density", 2, {"--by density", "NUMBER"});
}

TEST_F(ScenarioLists, MistakesAreToldWithTheirPlace) {
  expect_refusal("slalom-scenarios select a.scenarios --where 'densty > 1'", 2,
                 {"selection, character 1", "'density'"});
  expect_refusal("slalom-scenarios select a.scenarios --order-by 'density up'", 2, {"character 9"});
  expect_refusal("slalom-scenarios select a.scenarios --ids nobody", 2, {"no scenario 'nobody'"});
  expect_refusal(
      "slalom-scenarios index create a.scenarios --name x --descriptor density --edges 1,0", 2,
      {"growing edges"});
  expect_refusal(
      "slalom-scenarios index create a.scenarios --name x --descriptor densty --edges 0,1", 2,
      {"'densty'", "'density'"});
  expect_refusal(
      "slalom-scenarios index create a.scenarios --name name --descriptor density --edges 0,1", 2,
      {"name of a field"});
  expect_refusal("slalom-scenarios merge a.scenarios none.scenarios -o m.scenarios", 3,
                 {"none.scenarios"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "m.scenarios"));
}

}  // namespace
}  // namespace slalom
