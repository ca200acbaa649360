// SPDX-License-Identifier: BSD-3-Clause
#include "program_run.h"

#include <slalom/core/hash.h>
#include <slalom/core/version.h>
#include <slalom/io/bundle.h>
#include <slalom/io/result_file.h>

#include <nlohmann/json.hpp>

namespace slalom {
namespace {

using Json = nlohmann::json;

/// A folder "entries" with bundles.
class Registry : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("small.ini", kSmallCampaign);
    std::filesystem::create_directories(folder_ / "entries/lab");
  }

  void add_entry(const std::string& name, const std::string& settings = "") const {
    const ProgramResult made =
        run("slalom-evaluate small.ini --quiet --overwrite -o out --bundle entries/" + name +
            ".slalom " + settings);
    ASSERT_EQ(made.status, 0) << made.err;
  }

  /// The name of an entry in the site.
  std::string name_of(const std::string& bundle) const {
    return Hasher().add(read(bundle)).hex().substr(0, 16);
  }

  Json tables() const { return Json::parse(read("site/registry.json"))["tables"]; }

  /// The rows of a table as objects.
  static std::vector<Json> rows_of(const Json& table) {
    std::vector<Json> rows;
    for (const Json& row : table["rows"]) {
      Json& object = rows.emplace_back(Json::object());
      for (std::size_t i = 0; i < row.size(); ++i) object[table["columns"][i]] = row[i];
    }
    return rows;
  }
};

TEST_F(Registry, RanksTheMethodsOfSeveralBundlesOverTheSameScenarios) {
  add_entry("first");
  // Another method, and one that the first bundle contains already.
  add_entry("lab/second",
            "--set campaign.methods=gap,go --set method.go.adapter=library "
            "--set method.go.plugin=libslalom_go_to_goal.so");
  const std::string verify =
      "slalom-simulate verify entries/first.slalom --fraction 1 --badge-folder checked --quiet ";
  ASSERT_EQ(run(verify).status, 0);
  EXPECT_EQ(run(verify + "--new").out, "entries/first.slalom was verified\n");
  const ProgramResult made =
      run("slalom-analyze registry entries -o site --verifications checked --title 'Our lab'");
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_EQ(made.out, "site/index.html: 1 table of 2 bundles\n");
  const Json table = tables().at(0);
  EXPECT_EQ(tables().size(), 1U);
  std::map<std::string, Json> methods;
  double last = 1;
  for (const Json& row : rows_of(table)) {
    methods[row["method"]] = row;
    EXPECT_LE(row["success"].get<double>(), last);
    last = row["success"];
    EXPECT_EQ(row["rank"], "1-3") << "four scenarios tell nothing apart";
  }
  ASSERT_EQ(methods.size(), 3U) << "each method once: " << table.dump();
  EXPECT_EQ(methods["gap"]["bundle"], "first.slalom");
  EXPECT_EQ(methods["go"]["bundle"], "lab/second.slalom");
  EXPECT_EQ(methods["go"]["verified"], "no");
  EXPECT_EQ(methods["nd"]["verified"].get<std::string>().rfind("4 of 4 runs verified, 20", 0), 0U);
  const std::string page = read("site/index.html");
  EXPECT_NE(page.find("<h1>Our lab</h1>"), std::string::npos);
  const std::string second = name_of("entries/lab/second.slalom");
  EXPECT_NE(page.find("href=\"bundles/" + second + ".slalom\""), std::string::npos);
  EXPECT_NE(page.find("href=\"reports/" + second + "/index.html\""), std::string::npos);
  EXPECT_TRUE(read("site/bundles/" + second + ".slalom") == read("entries/lab/second.slalom"));
  EXPECT_NE(read("site/reports/" + second + "/index.html").find("<title>"), std::string::npos);
}

TEST_F(Registry, HasATableForEachSetOfScenariosAndSettings) {
  add_entry("a");
  add_entry("fast", "--set robot.max_v=1.5");
  add_entry("late", "--set limits.cycle_deadline=10");
  add_entry("other", "--set campaign.seed=6");
  add_entry("patient", "--set limits.run_wall_time=900 --set limits.memory_mb=0");  // as "a"
  add_entry("isolated", "--set limits.network=false");
  ASSERT_EQ(run("slalom-analyze registry entries -o site --no-reports").status, 0);
  std::vector<std::string> titles;
  const Json all = tables();
  for (const Json& table : all) titles.push_back(table["name"]);
  ASSERT_EQ(titles.size(), 5U);
  EXPECT_EQ(std::count_if(titles.begin(), titles.end(),
                          [](const std::string& title) {
                            return title.find(", 4 scenarios: robot.max_v = 1.5") !=
                                   std::string::npos;
                          }),
            1);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "site/reports"));
}

TEST_F(Registry, DoesNotCountItsOwnCopies) {
  add_entry("a");
  for (int times = 0; times < 2; ++times)
    EXPECT_EQ(run("slalom-analyze registry entries -o entries/site --no-reports").out,
              "entries/site/index.html: 1 table of 1 bundle\n");
}

TEST_F(Registry, LeavesOutWhatItsOwnVerificationsRefute) {
  add_entry("good");
  add_entry("other", "--set robot.max_v=0.7");
  std::filesystem::create_directories(folder_ / "checked");
  const auto verification_of = [&](const std::string& bundle) {
    return "checked/" + Hasher().add(read(bundle)).hex() + "_" + version() + ".json";
  };
  write(verification_of("entries/good.slalom"), R"({"color": "red"})");
  write(verification_of("entries/other.slalom"), "[1, 2");
  const ProgramResult made =
      run("slalom-analyze registry entries -o site --no-reports --verifications checked");
  EXPECT_EQ(made.status, 1);
  for (const std::string words :
       {"left out: entries/good.slalom: is different: checked/", ".json: is not a verification"})
    EXPECT_NE(made.err.find(words), std::string::npos) << words << " in " << made.err;
}

TEST_F(Registry, EntriesThatContradictEachOtherHaveNoRank) {
  add_entry("honest");
  ASSERT_EQ(run("slalom-simulate run small.ini -o forged.results --quiet").status, 0);
  {
    const ResultFile from = ResultFile::open((folder_ / "forged.results").string());
    ResultFile to = ResultFile::create((folder_ / "made.results").string(), from.read_manifest(),
                                       from.descriptors(), from.metrics());
    for (const auto& [hash, name] : from.read_scenario_names()) {
      to.add_scenario(from.read_record(hash), from.read_scenario(hash), from.read_references(hash));
      for (RunRecord run : from.read_runs(hash)) {
        if (run.method == "gap") run.outcome = "collision";
        to.add_run(run, {}, from.read_trajectory(run));
      }
    }
    to.commit();
  }
  write_bundle((folder_ / "made.results").string(), (folder_ / "entries/a.slalom").string(), {});
  ASSERT_EQ(run("slalom-analyze registry entries -o site --no-reports").status, 0);
  std::map<std::string, std::string> ranks;
  for (const Json& row : rows_of(tables().at(0)))
    ranks[row["method"].get<std::string>() + " " + row["bundle"].get<std::string>()] = row["rank"];
  EXPECT_EQ(ranks,
            (std::map<std::string, std::string>{{"gap a.slalom", "contradicts honest.slalom"},
                                                {"gap honest.slalom", "contradicts a.slalom"},
                                                {"nd a.slalom", "1"}}));
}

TEST_F(Registry, LeavesOutWhatIsNoWholeResult) {
  add_entry("good");
  const std::string good = read("entries/good.slalom");
  write("entries/damaged.slalom", good.substr(0, good.size() / 2));
  // Statements of its author are not read.
  write("entries/good.slalom.verified.json",
        R"({"message": "8 of 8 runs verified", "color": "brightgreen"})");
  add_entry("quick", "--set scenarios.count=30 --quick 20");
  EXPECT_EQ(run("slalom-simulate verify entries/quick.slalom --quiet").status, 0);
  add_entry("until", "--until 'interval(success) < 0.9'");
  const ProgramResult made = run("slalom-analyze registry entries -o site --no-reports");
  EXPECT_EQ(made.status, 1);
  for (const std::string words :
       {"left out: entries/damaged.slalom: ", "entries/quick.slalom: is of a sample of scenarios",
        "entries/until.slalom: is of a campaign whose number of runs depends on its results"})
    EXPECT_NE(made.err.find(words), std::string::npos) << words << " in " << made.err;
  for (const Json& row : rows_of(tables().at(0))) EXPECT_EQ(row["runs"], 4);
  EXPECT_NE(read("site/index.html").find("Left out: damaged.slalom: "), std::string::npos);
  for (const Json& row : rows_of(tables().at(0))) EXPECT_EQ(row["verified"], "no");
  expect_failure("slalom-analyze registry out -o site2", 3, {"out: contains no bundles"});
  expect_failure("slalom-analyze registry nowhere -o site2", 3, {"nowhere: cannot be read"});
}

}  // namespace
}  // namespace slalom
